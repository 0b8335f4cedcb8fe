// The ball as a body: what it has for inertia, how it rolls on the playfield, and what the playfield takes of its way.
#include "engine/core/rng.h"
#include "engine/core/trig.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double r = 0.0135, earth = 9.81, degrees_of_slope = 6.5;

struct Kind {
    const char* text;
    double inertia;  ///< in units of m r^2
};
constexpr Kind kinds[] = {{"disc", 0.5}, {"sphere", 0.4}};

std::string physics_of(const Kind& kind, const char* integrator, const std::string& more = "") {
    return "physics: {integrator: " + std::string(integrator) + ", ball_inertia: " + kind.text + more + "}\n";
}

constexpr const char* integrators[] = {"symplectic_euler", "ballistic"};

}  // namespace

TEST_CASE("a ball that rolls down a rail has gravity by one part in 1 + k, and the playfield's share on top where it rolls on that") {
    for (const Kind& kind : kinds)
        for (const char* integrator : integrators)
            for (const bool rolls : {false, true}) {
                INFO(kind.text << ' ' << integrator << " rolls: " << rolls);
                const std::string physics = physics_of(kind, integrator, rolls ? ", ball_rolls: true" : "");
                World world(program_of(room(4, 2, ", slope: 6.5", "materials: {default: {friction: 1, restitution: 0}}\n" + physics,
                                            "  - half_plane: {at: [0, 1.2], turn: -20}\n")));
                const Vec2 down{cosine_degrees(20), -sine_degrees(20)}, out{sine_degrees(20), cosine_degrees(20)};
                const BallId ball = world.add_ball(Vec2(0, 1.2) + 0.1 * down + (r + 1e-7) * out, {0, 0});
                const double pull = earth * sine_degrees(degrees_of_slope) / (rolls ? 1 + kind.inertia : 1.0) * sine_degrees(20);
                const int ticks = 1000;
                for (int tick = 0; tick < ticks; ++tick) world.step();
                const double speed = dot(world.find(ball)->velocity, down);
                CHECK(relative_error(speed, pull / (1 + kind.inertia) * world.time()) < 2e-3);
                CHECK(relative_error(speed, r * -world.find(ball)->spin) < 2e-3);  // without slip
            }
}

TEST_CASE("an impact that stops the slip leaves a ball k / (1 + k) less of its speed along the wall") {
    for (const Kind& kind : kinds)
        for (const char* integrator : integrators) {
            INFO(kind.text << ' ' << integrator);
            World world(program_of(room(1, 1, ", slope: 0", "materials: {default: {friction: 100, restitution: 1, tangential: 0}}\n" + physics_of(kind, integrator), "")));
            const BallId ball = world.add_ball({0.3, 0.1}, {1, -1});
            while (world.find(ball)->velocity.y() < 0) world.step();
            CHECK(relative_error(world.find(ball)->velocity.x(), 1 / (1 + kind.inertia)) < 1e-12);
            CHECK(relative_error(world.find(ball)->spin, -1 / (1 + kind.inertia) / r) < 1e-12);
            CHECK(relative_error(world.find(ball)->velocity.y(), 1) < 1e-12);
        }
}

TEST_CASE("a ball that rolls on the playfield falls by 5/7 of gravity as a sphere, by 2/3 as a disc") {
    for (const Kind& kind : kinds) {
        World world(program_of(room(1, 2, ", slope: 6.5", physics_of(kind, "ballistic", ", ball_rolls: true"), "")));
        const BallId ball = world.add_ball({0.5, 1.9}, {0, 0});
        while (world.tick() < 1000) world.step();
        const double pull = earth * sine_degrees(degrees_of_slope) / (1 + kind.inertia);
        CHECK(relative_error(-world.find(ball)->velocity.y(), pull) < 1e-12);
        CHECK(relative_error(1.9 - world.find(ball)->position.y(), 0.5 * pull) < 1e-12);
    }
}

TEST_CASE("the playfield's resistance stops a ball after v^2 / (2 a), and it stands from then on") {
    for (const Kind& kind : kinds)
        for (const char* integrator : integrators)
            for (const bool rolls : {false, true}) {
                INFO(kind.text << ' ' << integrator << " rolls: " << rolls);
                const std::string more = std::string(rolls ? ", ball_rolls: true" : "") + ", rolling_resistance: 0.02";
                World world(program_of(room(2, 2, ", slope: 0", physics_of(kind, integrator, more), "")));
                const BallId ball = world.add_ball({0.1, 0.5}, {0.4, 0.3});
                const double taken = 0.02 * earth / (rolls ? 1 + kind.inertia : 1.0);
                double last = 0.5;
                while (world.time() < 0.5 / taken + 0.01) {
                    world.step();
                    const double speed = length(world.find(ball)->velocity);
                    REQUIRE(speed <= last);
                    last = speed;
                }
                CHECK(last == 0);
                const Vec2 place = world.find(ball)->position;
                CHECK(relative_error(length(place - Vec2(0.1, 0.5)), 0.125 / taken) < 0.5 * taken * world.step_length() / 0.125 + 2e-3);
                for (int tick = 0; tick < 1000; ++tick) world.step();
                CHECK(world.find(ball)->position == place);
            }
}

TEST_CASE("a playfield that resists more than it slopes holds a ball where it is put; one that slopes more lets it go by the difference") {
    for (const char* integrator : integrators) {
        INFO(integrator);
        const std::string table = ", slope: 2", most = ", rolling_resistance: 0.036", less = ", rolling_resistance: 0.03";
        World holds(program_of(room(1, 2, table, physics_of(kinds[1], integrator, most), "")));  // tan 2 degrees is 0.0349
        World lets(program_of(room(1, 2, table, physics_of(kinds[1], integrator, less), "")));
        const BallId held = holds.add_ball({0.5, 1.5}, {0, 0}), let = lets.add_ball({0.5, 1.5}, {0, 0});
        while (holds.tick() < 2000) {
            holds.step();
            lets.step();
        }
        CHECK(holds.find(held)->position == Vec2(0.5, 1.5));
        const double pull = earth * (sine_degrees(2) - 0.03 * cosine_degrees(2));
        const double of_a_tick = 1e-3 * earth * 0.03;  // on parabolas the resistance of a tick is taken when the next one begins
        CHECK(std::fabs(-lets.find(let)->velocity.y() - 2 * pull) < 1.000001 * of_a_tick);
    }
}

TEST_CASE("a ball on a rail stands when the playfield resists more than the rail slopes") {
    for (const char* integrator : integrators)
        for (const double turn : {-1.0, -4.0}) {
            INFO(integrator << ' ' << turn);
            World world(program_of(room(4, 2, ", slope: 30",
                                        "materials: {default: {friction: 0, restitution: 0}}\n" +
                                            physics_of(kinds[1], integrator, ", rolling_resistance: 0.02"),
                                        "  - half_plane: {at: [0, 1], turn: " + std::to_string(turn) + "}\n")));
            const BallId ball = world.add_ball({0.5, 1 + 0.5 * tangent(radians(turn)) + (r + 1e-7) / cosine_degrees(turn)}, {0, 0});
            while (world.tick() < 2000) world.step();
            const double pull = earth * (sine_degrees(30) * sine_degrees(-turn) - 0.02 * cosine_degrees(30));
            const double speed = length(world.find(ball)->velocity);
            if (pull < 0) CHECK(speed == 0);
            else CHECK(relative_error(speed, pull * world.time()) < 2e-3);
        }
}

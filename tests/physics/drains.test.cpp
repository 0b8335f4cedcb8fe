// Drains: a ball leaves the game where its centre first comes into one, on its path as flown, and meets nothing that lies behind.
#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "engine/core/trig.h"
#include "engine/physics/mechanisms/mechanism.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

std::string number(double x) { return std::to_string(x); }

std::string point(const Vec2& p) { return "[" + number(p.x()) + ", " + number(p.y()) + "]"; }

/// The first place and time at which the centre of the first ball is in the drain, by 100 samples a millimetre of all that it flew: in a world
/// whose drain, of a layer of its own, drains nothing.
struct Seen {
    bool drained = false;
    double time = 0;
    Vec2 place{0, 0};
};
Seen sampled(World world, int ticks) {
    world.record_paths(true);
    const Program& program = world.program();
    const Sensor& drain = at(program.sensors, 0);
    const LayerMask of_drain = at(program.parts, drain.part).layers;
    for (int tick = 0; tick < ticks; ++tick) {
        world.step();
        for (const PathSegment& segment : world.paths()) {
            const double way = length(segment.velocity) * segment.duration;
            const int samples = 1 + static_cast<int>(1e5 * way);
            for (int k = 0; k <= samples; ++k) {
                const double t = segment.duration * k / samples;
                if (drains(program, drain, segment.at(t), of_drain)) return {true, segment.start + t, segment.at(t)};
            }
        }
    }
    return {};
}

std::string table_of(const std::string& drain_layer, const std::string& drain, const std::string& others) {
    return room(1, 1, ", slope: 5", "materials: {default: {restitution: 1, friction: 0}}\n", "  - drain: {" + drain_layer + drain + "}\n" + others);
}

}  // namespace

TEST_CASE("a ball drains before it meets what lies behind the drain, at any speed") {
    for (const double speed : {1.0, 10.0, 100.0, 1000.0})
        for (const char* with : {"", "  - flipper: {at: [0.2, 0.5], input: [a]}\n"}) {
            INFO(speed << with);
            World world(program_of(room(1, 1, ", slope: 0", "", "  - drain: {at: [0.5, 0.5], size: [0.1, 20mm]}\n"
                                                               "  - bumper: {at: [0.5, 0.42], radius: 30mm}\n" +
                                                                   std::string(with) + "inputs: {a: [A]}\n")));
            const BallId ball = world.add_ball({0.5, 0.6}, {0, -speed});
            int hits = 0;
            double time = 0;
            for (int tick = 0; tick < 200 && world.find(ball)->state != BallState::drained; ++tick) {
                world.step();
                for (const Event& event : world.events()) {
                    hits += event.kind == EventKind::hit || event.kind == EventKind::kick;
                    if (event.kind == EventKind::drain) time = event.time;
                }
            }
            CHECK(world.find(ball)->state == BallState::drained);
            CHECK(hits == 0);
            CHECK(std::fabs(world.find(ball)->position.y() - 0.51) < 2e-5);
            CHECK(std::fabs(time - 0.09 / speed) < 2e-5 / speed);
        }
}

TEST_CASE("a drain between the ends of a tick takes no ball that bounces round it") {
    World world(program_of(room(1, 1, ", slope: 0", "materials: {default: {restitution: 1, friction: 0}}\n",
                                "  - drain: {at: [0.5, 35.5mm], size: [20mm, 5mm]}\n")));
    // Down to the floor and up again within a tick: the chord lies in the drain, the path below it only at the walls' distance.
    const BallId ball = world.add_ball({0.47, 0.0355}, {60, -44});
    for (int tick = 0; tick < 3; ++tick) world.step();
    CHECK(world.find(ball)->state == BallState::rolling);
}

TEST_CASE("balls drain where and when dense samples of their paths first lie in the drain, round walls, bats and each other") {
    int drained = 0, missed = 0;
    for (std::uint64_t n = 0; n < 150; ++n) {
        CounterRng rng(n, 0xd4a1);
        const double x = rng.in(0.2, 0.8), y = rng.in(0.2, 0.8), turn = rng.in(0, 180), width = rng.in(0.05, 0.4), height = rng.in(0.005, 0.1);
        const std::string drain =
            "at: " + point({x, y}) + ", turn: " + number(turn) + ", size: " + point({width, height});
        std::string others;
        if (n % 3 == 1) others = "  - flipper: {at: [0.1, 0.3], input: [a]}\n";
        if (n % 3 == 2) others = "  - circle: {at: [0.5, 0.1], radius: 60mm}\n";
        others += "inputs: {a: [A]}\n";
        World real(program_of(table_of("", drain, others))), other(program_of(table_of("layer: [cellar], ", drain, others)));
        const double speed = std::exp(rng.in(0, 6)), way = rng.in(0, 360);
        const Vec2 velocity = speed * Vec2(cosine_degrees(way), sine_degrees(way));
        const Vec2 start{rng.in(0.02, 0.15), 0.9};
        for (World* world : {&real, &other}) world->add_ball(start, velocity);
        const int ticks = 60;
        const Seen seen = sampled(other, ticks);
        INFO(n << ' ' << drain << " speed " << speed << " way " << way << " start " << start.x());
        bool found = false;
        for (int tick = 0; tick < ticks && !found; ++tick) {
            real.step();
            for (const Event& event : real.events()) {
                if (event.kind != EventKind::drain) continue;
                found = true;
                if (!seen.drained) continue;
                CHECK(std::fabs(event.time - seen.time) * speed < 5e-5);
                CHECK(length(event.position - seen.place) < 5e-5);
            }
        }
        drained += found;
        missed += found != seen.drained;  // a corner cut by less than the samples or the steps see
    }
    CHECK(drained > 40);
    CHECK(missed <= 1);
}

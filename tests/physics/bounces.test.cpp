// Impacts against their closed forms: bouncing, oblique impact, billiards, balls among themselves, rest.
#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double g = 9.81, r = 0.0135;

std::string floor_of(const std::string& material) {
    return "materials:\n  floor: {" + material + "}\n";
}

/// A room under full gravity whose walls are of the given material.
ProgramPtr hall(const std::string& material, const std::string& more_physics = "", double width = 10, double height = 10,
                const std::string& slope = "90") {
    std::string text =
        room(width, height, ", slope: " + slope, "physics: {integrator: ballistic" + more_physics + "}\n" + floor_of(material), "");
    text.insert(text.find("{id: air") + 1, "material: floor, ");
    return program_of(text);
}

void step_to_first_event(World& world) {
    while (world.events().empty() && world.time() < 2) world.step();
    REQUIRE_FALSE(world.events().empty());
}

}  // namespace

// Each bounce keeps e of the speed: h_n = e^(2n) h_0, and all of them together with the first fall last
// sqrt(2 h0 / g) (1 + e) / (1 - e) (geometric series).
TEST_CASE("a bouncing ball loses height geometrically and comes to rest when the series says") {
    const double e = 0.5, h0 = 1;
    const ProgramPtr program = hall("restitution: 0.5", ", rest_speed: 0");
    World world(program);
    world.add_ball({5, r + h0}, {0, 0});
    std::vector<Event> hits;
    while (world.time() < 2) {
        world.step();
        for (const Event& event : world.events())
            if (event.kind == EventKind::hit) hits.push_back(event);
    }
    REQUIRE(hits.size() == 7);  // the next bounce would last 7 ms: what follows in less than 10 ms is the same touch
    const double gap = 0.5e-7;  // a ball is stopped half the tolerance early
    for (std::size_t n = 0; n < 7; ++n) {
        const double speed = std::sqrt(2 * g * (h0 - gap)) * std::pow(e, static_cast<double>(n));
        CHECK(relative_error(hits[n].speed, speed) < 1e-9);
        const double height = hits[n].speed * hits[n].speed / (2 * g);
        CHECK(relative_error(height, std::pow(e, 2.0 * static_cast<double>(n)) * (h0 - gap)) < 1e-9);
    }
    const Event& last = hits.back();  // from there on the rest of the series in closed form
    const double end = last.time + 2 * e * last.speed / (g * (1 - e));
    CHECK(relative_error(end, std::sqrt(2 * (h0 - gap) / g) * (1 + e) / (1 - e)) < 1e-9);
    CHECK(world.balls()[0].velocity == Vec2(0, 0));
    CHECK(world.balls()[0].position.y() - r < 1e-7);
}

TEST_CASE("an elastic ball keeps its apex over 1e5 bounces") {
    const double h0 = 0.05;
    World world(hall("restitution: 1", ", step: 4ms"));
    world.add_ball({5, r + h0}, {0, 0});
    const double energy = world.energy();
    // Bounces are 2 sqrt(2 h0 / g) = 0.2 s apart, fifty ticks: a hundred thousand of them take five million.
    while (world.stats().impacts < 100000 && world.tick() < 6'000'000) world.step();
    REQUIRE(world.stats().impacts >= 100000);
    // Energy is m g (r + apex): the apex above the floor's contact, to the same relative error.
    const double apex = world.energy() / (0.08 * g) - r;
    CHECK(relative_error(apex, h0) < 1e-9);
    CHECK(relative_error(world.energy(), energy) < 1e-9);
}

// Newton's law along the normal and e_t along the surface: tan(out) = (e_t / e) tan(in), for the velocity of the contact point;
// the centre of a disc without spin takes a third of that change (Cross, "Grip-slip behavior of a bouncing ball", 2002).
TEST_CASE("an oblique impact turns the contact point's velocity as restitution and tangential restitution say") {
    for (const double et : {0.0, 0.4, 0.9, -0.5}) {
        const double e = 0.6;
        World world(hall("restitution: 0.6, friction: 100, tangential: " + std::to_string(et), "", 10, 10, "0"));
        world.add_ball({5, 0.5}, {2, -3});
        step_to_first_event(world);
        const Ball& ball = world.balls()[0];
        const double slip_in = 2, slip_out = ball.velocity.x() + r * ball.spin;  // floor: the contact point is below
        CHECK(relative_error(ball.velocity.y(), e * 3) < 1e-9);
        CHECK(std::fabs(slip_out - et * slip_in) < 1e-9);
        CHECK(std::fabs(ball.velocity.x() - (2 - (1 - et) * 2 / 3)) < 1e-9);
        CHECK(std::fabs(std::fabs(slip_out / ball.velocity.y()) - std::fabs(et / e) * (2.0 / 3)) < 1e-9);
    }
}

// Coulomb: |dv_t| <= mu (1 + e) |v_n|.
// A disc whose slip v stops keeps 2/3 of it and spins with the wall (inertia m r^2 / 2: the slip yields three times as
// easily as the centre).
TEST_CASE("friction grips of itself: it slows and spins a ball that grazes a wall") {
    const Vec2 v(0.5, -1);
    World rough(hall("restitution: 0.5, friction: 100", "", 10, 10, "0")), smooth(hall("restitution: 0.5, friction: 0", "", 10, 10, "0"));
    for (World* world : {&rough, &smooth}) {
        world->add_ball({5, r + 0.01}, v);
        for (int i = 0; i < 20; ++i) world->step();
    }
    const Ball &rolls = rough.balls()[0], &slips = smooth.balls()[0];
    CHECK(rolls.velocity.x() == Approx(v.x() * 2 / 3).epsilon(1e-12));
    CHECK(r * std::fabs(rolls.spin) == Approx(v.x() * 2 / 3).epsilon(1e-12));
    CHECK(rolls.spin < 0);  // clockwise: along the floor to the right
    CHECK(slips.velocity.x() == v.x());
    CHECK(slips.spin == 0);
}

TEST_CASE("friction never takes more than the Coulomb cone allows") {
    World world(hall("restitution: 0.5, friction: 0.1, tangential: 0", "", 10, 10, "0"));
    world.add_ball({5, 0.5}, {4, -2});
    step_to_first_event(world);
    CHECK(relative_error(4 - world.balls()[0].velocity.x(), 0.1 * 1.5 * 2) < 1e-9);
}

TEST_CASE("restitution falls with the speed of the impact as e0 / (1 + k v)") {
    World world(hall("restitution: 0.8, falloff: 0.43", "", 10, 10, "0"));
    world.add_ball({5, 0.5}, {0, -3});
    step_to_first_event(world);
    CHECK(relative_error(world.balls()[0].velocity.y(), 3 * 0.8 / (1 + 0.43 * 3)) < 1e-9);
}

// Unfolding (mirror images of the table): the coordinate is a triangle wave of the straight path's.
TEST_CASE("a rectangle billiard is the unfolded straight line") {
    const double width = 0.7, height = 0.4, gap = 0.5e-7;
    World world(hall("restitution: 1, friction: 0", "", width, height, "0"));
    const Vec2 start(0.31, 0.17), v(1.7, 0.9);
    world.add_ball(start, v);
    for (int i = 0; i < 20000; ++i) world.step();
    const auto unfolded = [&](double x0, double speed, double size) {
        const double lo = r + gap, span = size - 2 * lo;
        const double way = std::fmod(x0 - lo + speed * 20, 2 * span);
        return lo + (way <= span ? way : 2 * span - way);
    };
    CHECK(world.stats().impacts > 60);
    CHECK(std::fabs(world.balls()[0].position.x() - unfolded(start.x(), v.x(), width)) < 1e-8);
    CHECK(std::fabs(world.balls()[0].position.y() - unfolded(start.y(), v.y(), height)) < 1e-8);
}

// Equal masses: the components along the line of centres are exchanged for e = 1; (1 - e) and (1 + e) halves otherwise.
TEST_CASE("two balls exchange momentum along the line of centres and keep what the law keeps") {
    for (const double e : {1.0, 0.8, 0.0}) {
        const ProgramPtr program = program_of(
            "pinfield: 1\ntable: {size: [4, 4], slope: 0}\nphysics: {integrator: ballistic, ball_restitution: " + std::to_string(e) +
            "}\nscene: []\n");
        World world(program);
        world.add_ball({1.9, 2}, {1.5, 0});
        world.add_ball({2.1, 2.01}, {-0.5, -0.1});
        const double energy = world.energy();
        const Vec2 momentum(1.0, -0.1), relative(2.0, 0.1);
        bool met = false;
        Vec2 n{0, 0};
        for (int i = 0; i < 300; ++i) {
            world.step();
            for (const Event& event : world.events())
                if (event.kind == EventKind::ball_hit) { met = true; n = event.normal; }
        }
        REQUIRE(met);
        const Ball &a = world.balls()[0], &b = world.balls()[1];
        CHECK(length(a.velocity + b.velocity - momentum) < 1e-12);
        const double closing = dot(n, relative), opening = -dot(n, a.velocity - b.velocity);
        CHECK(std::fabs(opening - e * closing) < 1e-9);
        CHECK(std::fabs(world.energy() - (energy - 0.08 * 0.25 * (1 - e * e) * closing * closing)) < 1e-9);
    }
}

TEST_CASE("Newton's cradle passes the speed of the first ball to the last") {
    const ProgramPtr program =
        program_of("pinfield: 1\ntable: {size: [4, 4], slope: 0}\nphysics: {integrator: ballistic, ball_restitution: 1}\nscene: []\n");
    World world(program);
    world.add_ball({1, 2}, {2, 0});
    for (int i = 0; i < 4; ++i) world.add_ball({1.5 + i * (2 * r + 1e-7), 2}, {0, 0});
    for (int i = 0; i < 400; ++i) world.step();
    for (int i = 0; i < 4; ++i) CHECK(length(at(world.balls(), i).velocity) < 1e-9);
    CHECK(length(world.balls()[4].velocity - Vec2(2, 0)) < 1e-9);
}

TEST_CASE("a resting ball does not change a bit") {
    for (const std::string integrator : {"ballistic", "symplectic_euler"}) {
        std::string text =
            room(1, 1, ", slope: 6.5", "physics: {integrator: " + integrator + "}\n",
                 "  - box: {size: [0.3, 0.05], turn: -40, at: [0.33, 0.1]}\n  - box: {size: [0.3, 0.05], turn: 40, at: [0.57, 0.1]}\n");
        World world(program_of(text));
        world.add_ball({0.45, 0.5}, {0.1, 0});
        world.add_ball({0.9, 0.1}, {0, 0});
        for (int i = 0; i < 20000; ++i) world.step();
        const Ball first = world.balls()[0], second = world.balls()[1];
        CHECK(first.velocity == Vec2(0, 0));
        CHECK(second.velocity == Vec2(0, 0));
        CHECK(gap_at(world, first.position).distance - r > 0);
        CHECK(gap_at(world, first.position).distance - r < 1.1e-7);
        for (int i = 0; i < 1000; ++i) {
            world.step();
            REQUIRE(world.balls()[0].position == first.position);
            REQUIRE(world.balls()[0].spin == 0);
            REQUIRE(world.balls()[1].position == second.position);
        }
    }
}

TEST_CASE("a ball slides along a hollow without burning its budget") {
    const std::string text =
        "pinfield: 1\ntable: {size: [1, 1], slope: 0}\nphysics: {integrator: ballistic}\nmaterials: {default: {restitution: 0.3, friction: "
        "0}}\nscene:\n"
        "  - domain: {id: air, children: [circle: {radius: 0.3, at: [0.5, 0.5]}]}\n";
    World world(program_of(text));
    world.add_ball({0.5 + 0.3 - r - 1e-7, 0.5}, {0, 2});
    for (int i = 0; i < 2000; ++i) world.step();
    const Ball& ball = world.balls()[0];
    CHECK(world.stats().capped_ticks == 0);
    CHECK(world.stats().impacts < 2000 * 20);
    CHECK(length(ball.velocity) == Approx(2).epsilon(0.01));  // the wall is smooth: it does not slow the ball
    CHECK(gap_at(world, ball.position).distance - r < 1e-6);
    CHECK(gap_at(world, ball.position).distance - r > 0);
}

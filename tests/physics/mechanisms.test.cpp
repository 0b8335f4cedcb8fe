// Flippers and plungers: the times and speeds that their defaults promise, and the laws of impact with them.
#include "engine/core/trig.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double r = 0.0135;

ProgramPtr with_flipper(const std::string& fields, const std::string& more = "") {
    return program_of(
        "pinfield: 1\ntable: {size: [2, 2], slope: 0}\nphysics: {integrator: ballistic, step: 0.1ms}\ninputs: {left: [Z], plunge: "
        "[Space]}\n" +
        more + "scene:\n  - flipper: {id: f, at: [1, 1], input: [left]" + fields + "}\n");
}

/// Milliseconds until the flipper first stands at q.
double time_to(World& world, double q) {
    const double start = world.time();
    while (std::fabs(world.movers()[0].q - q) > 1e-12 && world.time() < start + 1) {
        const double before = world.movers()[0].q;
        world.step();
        for (const Event& event : world.events())
            if (event.kind == EventKind::end_stop) return 1e3 * (event.time - start);
        if (before == world.movers()[0].q && world.time() > start + 0.01) break;
    }
    return 1e3 * (world.time() - start);
}

}  // namespace

// The ramp gives q = a t^3 / (6 T) up to T = 30 ms, then constant torque; the return is q = a' t^2 / 2 with a' = 0.058 a.
TEST_CASE("a flipper goes up in about 34 ms at 76 rad/s and comes down in about 89 ms") {
    World world(with_flipper(""));
    world.set_input(0, 1);
    double fastest = 0;
    const double start = world.time();
    double up = 0;
    while (up == 0 && world.time() < 0.1) {
        world.step();
        for (const Event& event : world.events())
            if (event.kind == EventKind::end_stop) {
                up = event.time - start;
                fastest = event.speed;  // of the tip's end, lever times rate
            }
    }
    CHECK(1e3 * up == Approx(34.5).margin(1));
    CHECK(fastest / 0.077 == Approx(76).margin(1.5));
    CHECK(fastest * 0.07 / 0.077 == Approx(5.3).margin(0.1));
    for (int i = 0; i < 3000; ++i) world.step();
    CHECK(world.movers()[0].q == radians(-30 + 51));
    CHECK(world.movers()[0].rate == 0);
    world.set_input(0, 0);
    CHECK(time_to(world, radians(-30)) == Approx(89).margin(1));
    for (int i = 0; i < 3000; ++i) world.step();
    CHECK(world.movers()[0].q == radians(-30));
}

TEST_CASE("a tapped flipper does not reach its end-stop") {
    World world(with_flipper(""));
    world.set_input(0, 1);
    for (int i = 0; i < 100; ++i) world.step();
    world.set_input(0, 0);
    double highest = -10;
    for (int i = 0; i < 3000; ++i) {
        world.step();
        highest = std::max(highest, world.movers()[0].q);
    }
    CHECK(highest > radians(-29));
    CHECK(highest < radians(10));
    CHECK(world.movers()[0].q == radians(-30));
}

// A heavy bat is a moving wall: v' = -e v + (1 + e) V with V = rate x lever at the contact.
TEST_CASE("a ball leaves a heavy flipper as it leaves a wall that moves") {
    const ProgramPtr program = with_flipper(", mass: 1e9, rest: 0, swing: 60, ramp: 0, strength: 100000",
                                            "materials: {default: {restitution: 0.7, friction: 0}}\n");
    World world(program);
    world.set_input(0, 1);
    world.add_ball({1.05, 1.05}, {0, -1});
    Event hit;
    while (hit.speed == 0 && world.time() < 0.2) {
        world.step();
        for (const Event& event : world.events())
            if (event.kind == EventKind::hit) hit = event;
    }
    REQUIRE(hit.speed > 0);
    const double surface = hit.speed + dot(hit.normal, Vec2(0, -1));  // approach = V - v.n
    CHECK(surface > 0.1);
    CHECK(std::fabs(dot(hit.normal, world.balls()[0].velocity) - (-0.7 * -1 * -dot(hit.normal, Vec2(0, -1)) + 1.7 * surface)) < 1e-6);
}

// Angular momentum about the pivot: of the ball m x v, of the bat I rate, I = m L^2 / 3.
TEST_CASE("a ball and a free flipper keep their angular momentum, and with e = 1 their energy") {
    const ProgramPtr program = with_flipper(", strength: 0.001, rest: 0, swing: 90, end_torque: 0, return_ratio: 0",
                                            "materials: {default: {restitution: 1, friction: 0}}\n");
    World world(program);
    world.add_ball({1.055, 0.95}, {0, 1.5});  // from below: pushes the bat off its lower stop
    const double inertia = 0.25 * 0.077 * 0.077 / 3, mass = 0.08;
    const double momentum = mass * cross(Vec2(0.055, 0), Vec2(0, 1.5)), energy = 0.5 * mass * 1.5 * 1.5;
    bool hit = false;
    for (int i = 0; i < 500; ++i) {
        world.step();
        for (const Event& event : world.events())
            if (event.kind == EventKind::hit) hit = true;
        if (hit) break;
    }
    REQUIRE(hit);
    const Ball& ball = world.balls()[0];
    const double rate = world.movers()[0].rate;
    CHECK(rate > 1);
    CHECK(relative_error(mass * cross(ball.position - Vec2(1, 1), ball.velocity) + inertia * rate, momentum) < 1e-6);
    CHECK(relative_error(0.5 * mass * dot(ball.velocity, ball.velocity) + 0.5 * inertia * rate * rate, energy) < 1e-6);
}

namespace {

/// A bat with the defaults, rubber on it, and a rail that leads to it; slope and steps as tables have them.
ProgramPtr with_inlane() {
    return program_of(
        "pinfield: 1\ntable: {size: [0.6, 1.2]}\nphysics: {integrator: ballistic}\n"
        "materials: {rubber: {restitution: 0.8, falloff: 0.43, friction: 0.6}, default: {restitution: 0.2}}\ninputs: {go: [Z]}\nscene:\n"
        "  - flipper: {at: [0.2, 0.2], rest: -30, swing: 51, material: rubber, input: [go]}\n"
        "  - segment: {a: [0.1, 0.268], b: [0.186, 0.2119], thickness: 8mm}\n");
}

/// Top speed of a ball that rolls onto the bat and is shot `press` ticks after it was let go.
double shot(const ProgramPtr& program, int press) {
    World world(program);
    world.add_ball({0.13, 0.272}, {0, 0});
    double top = 0;
    for (int tick = 0; tick < press + 80; ++tick) {
        if (tick == press) world.set_input(0, 1);
        world.step();
        if (tick > press) top = std::max(top, length(world.balls()[0].velocity));
    }
    return top;
}

/// With what speed off the raised bat a ball leaves that comes down to it at this speed, when the bat was sent up `lead` ticks before.
double caught(const ProgramPtr& program, double speed, int lead) {
    const Vec2 along{cosine_degrees(21), sine_degrees(21)}, out{-sine_degrees(21), cosine_degrees(21)};
    constexpr int fall = 80;
    World world(program);
    world.add_ball(Vec2(0.2, 0.2) + 0.045 * along + (0.0085 + r) * out + Vec2(0, speed * fall * world.step_length()), {0, -speed});
    double off = 0;
    bool hit = false;
    for (int tick = 0; tick < fall + 200; ++tick) {
        if (tick == fall - lead) world.set_input(0, 1);
        world.step();
        for (const Event& event : world.events()) hit = hit || event.kind == EventKind::hit;
        if (hit) off = std::max(off, dot(world.balls()[0].velocity, out));
    }
    return off;
}

}  // namespace

TEST_CASE("a flipper's best shot is as fast as a machine's: above 3.5 m/s, with a tip that unloaded reaches 5.7") {
    const ProgramPtr program = with_inlane();
    double best = 0;
    for (int press = 860; press < 960; press += 4) best = std::max(best, shot(program, press));
    CHECK(best > 3.5);
    CHECK(best < 5.7);
}

TEST_CASE("a live catch in good time leaves a ball less than 0.3 m/s") {
    const ProgramPtr program = with_inlane();
    for (const double speed : {1.0, 2.0}) {
        double least = infinity;
        for (int lead = 40; lead < 60; ++lead) least = std::min(least, caught(program, speed, lead));
        CHECK(least < 0.3);
    }
}

TEST_CASE("a ball pinched between a flipper and a wall stops the flipper and is not entered") {
    const ProgramPtr program = program_of(
        "pinfield: 1\ntable: {size: [2, 2], slope: 6.5}\ninputs: {left: [Z]}\nscene:\n  - flipper: {id: f, at: [1, 1], rest: -30, swing: "
        "60, input: [left]}\n"
        "  - box: {size: [0.3, 0.1], at: [1.05, 1.075]}\n");
    World world(program);
    world.add_ball({1.05, 1.008}, {0, 0});
    for (int k = 0; k < 40; ++k) {
        world.set_input(0, k % 2 ? 0 : 1);
        for (int i = 0; i < 100; ++i) {
            world.step();
            REQUIRE(gap_at(world, world.balls()[0].position).distance - r > -1e-9);
        }
    }
}

TEST_CASE("a plunger launches the ball that lies on it at the rod's speed, restitution included") {
    const ProgramPtr program = program_of(
        "pinfield: 1\ntable: {size: [1, 2], slope: 6.5}\ninputs: {plunge: [Space]}\nmaterials: {default: {restitution: 0.25, friction: "
        "0}}\nscene:\n"
        "  - plunger: {id: p, at: [0.5, 0.2], stroke: 40mm, speed: 3.5, pull_time: 0.5, input: [plunge]}\n"
        "  - box: {size: [0.02, 0.4], at: [0.476, 0.3]}\n  - box: {size: [0.02, 0.4], at: [0.524, 0.3]}\n");
    World world(program);
    world.add_ball({0.5, 0.2 + r + 1e-4}, {0, 0});
    world.set_input(0, 1);
    for (int i = 0; i < 1500; ++i) world.step();
    CHECK(world.movers()[0].q == -0.04);
    CHECK(std::fabs(world.balls()[0].position.y() - (0.16 + r)) < 1e-6);
    world.set_input(0, 0);
    world.step();
    CHECK(world.balls()[0].velocity.y() == Approx(3.5 * 1.25).epsilon(0.01));
    for (int i = 0; i < 30; ++i) world.step();
    CHECK(world.movers()[0].q == 0);
    CHECK(world.movers()[0].rate == 0);
}

TEST_CASE("a rod that presses a ball against a ceiling stops, jams the ball once, harms nobody, and lets it go again") {
    const ProgramPtr program = program_of(
        "pinfield: 1\ntable: {size: [1, 1], slope: 0}\ninputs: {plunge: [Space]}\nmaterials: {default: {restitution: 0.5}}\nscene:\n"
        "  - plunger: {id: p, at: [0.5, 0.2], stroke: 40mm, speed: 3.5, pull_time: 0.1, input: [plunge]}\n"
        "  - box: {size: [0.2, 0.02], at: [0.5, 0.23]}\n"
        "  - box: {size: [0.02, 0.2], at: [0.476, 0.2]}\n  - box: {size: [0.02, 0.2], at: [0.524, 0.2]}\n");
    World world(program);
    world.set_input(0, 1);
    for (int i = 0; i < 500; ++i) world.step();
    world.add_ball({0.5, 0.19}, {0, 0});
    int jams = 0;
    const auto run = [&](int ticks) {
        for (int i = 0; i < ticks; ++i) {
            world.step();
            REQUIRE(gap_at(world, world.balls()[0].position).distance - r > -1e-9);
            for (const Event& event : world.events()) jams += event.kind == EventKind::jam;
        }
    };
    run(200);
    CHECK(jams == 0);
    world.set_input(0, 0);
    run(1000);
    CHECK(jams == 1);
    CHECK(world.balls()[0].state == BallState::jammed);
    CHECK(world.movers()[0].q < -1e-3);
    world.set_input(0, 1);
    run(500);
    CHECK(world.balls()[0].state != BallState::jammed);
    CHECK(world.movers()[0].q == -0.04);
}

TEST_CASE("half the stroke gives half the speed") {
    const ProgramPtr program = program_of(
        "pinfield: 1\ntable: {size: [1, 2], slope: 0}\ninputs: {plunge: [Space]}\nscene:\n  - plunger: {id: p, at: [0.5, 0.2], stroke: "
        "40mm, speed: 3, pull_time: 0.5, input: [plunge]}\n");
    World world(program);
    world.set_input(0, 1);
    for (int i = 0; i < 250; ++i) world.step();
    world.set_input(0, 0);
    world.step();
    REQUIRE(world.events().size() >= 1);
    CHECK(world.movers()[0].rate == Approx(1.5).epsilon(0.01));
}

TEST_CASE("a bumper kicks above its threshold and not below") {
    const ProgramPtr program = program_of(
        "pinfield: 1\ntable: {size: [1, 1], slope: 0}\nmaterials: {default: {restitution: 0.5, friction: 0}}\nscene:\n  - bumper: {id: b, "
        "at: [0.5, 0.5], radius: 24mm, kick: 0.8, threshold: 0.1}\n");
    for (const double speed : {0.09, 0.5}) {
        World world(program);
        world.add_ball({0.5, 0.56}, {0, -speed});
        for (int tick = 0; tick < 2000 && world.events().empty(); ++tick) world.step();
        REQUIRE_FALSE(world.events().empty());
        CHECK(relative_error(world.balls()[0].velocity.y(), 0.5 * speed + (speed < 0.1 ? 0.0 : 0.8)) < 1e-9);
    }
}

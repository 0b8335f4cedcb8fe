// Balls that lie on each other: ball against ball is part of the promise, also for an hour.
#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/game/simulation.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double r = 0.0135;

/// Metres by which any two balls in play overlap now.
double overlap(const World& world) {
    double most = 0;
    for (const Ball& a : world.balls())
        for (const Ball& b : world.balls())
            if (a.id < b.id && a.state != BallState::drained && b.state != BallState::drained)
                most = std::max(most, 2 * r - length(a.position - b.position));
    return most;
}

struct Pile {
    std::string what, text;
    std::vector<Vec2> balls;
    bool flipper = false;  ///< its first input is held
};

const std::string sloped = "pinfield: 1\ntable: {size: [0.5, 1], slope: 6.5}\ninputs: {left: [Z]}\nscene:\n"
                           "  - domain: {children: [box: {size: [0.5, 1], at: [0.25, 0.5]}]}\n";

std::vector<Vec2> column(const Vec2& first, const Vec2& step, int n) {
    std::vector<Vec2> places;
    for (int k = 0; k < n; ++k) places.push_back(first + k * step);
    return places;
}

std::vector<Pile> piles() {
    const std::string funnel =
        "  - triangle: {a: [0, 0], b: [0.23, 0], c: [0, 0.3]}\n  - triangle: {a: [0.5, 0], b: [0.5, 0.3], c: [0.27, 0]}\n"
        "  - box: {size: [0.1, 0.02], at: [0.25, 0.01]}\n";
    std::vector<Vec2> twenty;
    for (int k = 0; k < 20; ++k) twenty.push_back({0.16 + 0.045 * (k % 5) + 0.003 * (k / 5), 0.3 + 0.05 * (k / 5)});
    return {
        {"two, one above the other", sloped, {{0.25, 0.0136}, {0.25, 0.0410}}},
        {"four in a chute", sloped + "  - box: {size: [0.02, 0.5], at: [0.224, 0.25]}\n  - box: {size: [0.02, 0.5], at: [0.276, 0.25]}\n",
         column({0.249, 0.02}, {0.0005, 0.03}, 4)},
        {"six in a trough", sloped + "  - box: {size: [0.6, 0.04], at: [0.25, 0.1], turn: 10}\n", column({0.1, 0.16}, {0.035, 0.01}, 6)},
        {"three on a cradled flipper",
         sloped + "  - flipper: {at: [0.012, 0.2], rest: -30, swing: 51, input: [left]}\n", column({0.03, 0.27}, {0.004, 0.03}, 3), true},
        {"twenty in a funnel", sloped + funnel, twenty},
    };
}

World filled(const Pile& pile, Integrator integrator) {
    WorldOptions options;
    options.integrator = integrator;
    World world(program_of(pile.text), options);
    for (const Vec2& place : pile.balls) world.add_ball(place, {0, 0});
    if (pile.flipper) world.set_input(0, 1);
    return world;
}

/// What the integrator keeps in free flight (see contact.test.cpp), of all balls.
double kept_energy(const World& world, Integrator integrator) {
    double sum = world.energy();
    const PhysicsRecord& physics = world.program().physics;
    if (integrator == Integrator::symplectic_euler)
        for (const Ball& ball : world.balls()) sum += 0.5 * world.step_length() * physics.ball_mass * dot(physics.gravity, ball.velocity);
    return sum;
}

/// No overlap, no gain of energy once a flipper's blow is over, and in the end nothing moves.
void check_pile(const Pile& pile, Integrator integrator, double minutes) {
    INFO(pile.what << ", integrator " << static_cast<int>(integrator));
    World world = filled(pile, integrator);
    double worst = 0, depth = 0, least = infinity, gained = 0;
    const auto ticks = static_cast<std::int64_t>(std::llround(minutes * 60 / world.step_length()));
    for (std::int64_t t = 0; t < ticks; ++t) {
        world.step();
        worst = std::max(worst, overlap(world));
        if (t % 10 == 0)
            for (const Ball& ball : world.balls()) depth = std::max(depth, r - gap_at(world, ball.position).distance);
        if (pile.flipper && world.time() < 5) continue;
        const double now = kept_energy(world, integrator);
        gained = std::max(gained, now - least);
        least = std::min(least, now);
    }
    CHECK(worst < 1e-6);
    CHECK(depth < 1e-6);
    // As much as a micrometre of height for each ball: what the band of contact lets them sink and puts back.
    CHECK(gained < 1e-6 * static_cast<double>(pile.balls.size()) * 0.08 * length(world.program().physics.gravity));
    for (const Ball& ball : world.balls()) CHECK((ball.state == BallState::resting || ball.state == BallState::drained));
}

}  // namespace

TEST_CASE("balls that lie on each other do not sink into each other, and fall asleep") {
    for (const Pile& pile : piles())
        for (const Integrator integrator : {Integrator::symplectic_euler, Integrator::ballistic}) check_pile(pile, integrator, 1);
}

TEST_CASE("balls that lie on each other for an hour do not sink into each other", "[slow]") {
    for (const Pile& pile : piles())
        for (const Integrator integrator : {Integrator::symplectic_euler, Integrator::ballistic}) check_pile(pile, integrator, 60);
}

TEST_CASE("balls that were put into each other part at bounded speed, without energy, and the auditor and the referee tell it") {
    for (const Integrator integrator : {Integrator::symplectic_euler, Integrator::ballistic})
        for (const double apart : {0.0, 0.004, 0.02}) {
            WorldOptions options;
            options.integrator = integrator;
            World world(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 0}\nscene: []\n"), options);
            world.add_ball({0.5, 0.5}, {0, 0});
            const BallId thrown = world.add_ball({0.7, 0.5}, {0, 0});
            world.set_ball(thrown, {0.5 + apart, 0.5}, {0, 0});
            Game game(world);
            SimulationOptions run;
            run.seconds = 0.1;
            run.audit = true;
            const SimulationSummary told = simulate(game, run);
            CHECK(told.max_penetration > 0.5 * (2 * r - apart) - 2.1e-3);
            REQUIRE(told.audit);
            CHECK(told.audit->worst_overlap > 0.5 * (2 * r - apart) - 2.1e-3);
            for (int t = 0; t < 100; ++t) {
                const Vec2 before[] = {world.balls()[0].position, world.balls()[1].position};
                world.step();
                for (int k = 0; k < 2; ++k) CHECK(length(at(world.balls(), k).position - before[k]) < 2.1e-3);
            }
            CHECK(overlap(world) <= 0);
            CHECK(world.energy() == 0);
        }
}

TEST_CASE("of two balls that start at one place one waits until the other has gone, and so does one that is put back onto another") {
    const std::string spawns = "  - spawn: {at: [0.25, 0.5], velocity: [0, 1]}\n  - spawn: {at: [0.25, 0.505]}\n";
    World world(program_of(sloped + spawns));
    world.add_spawned_balls();
    int told = 0;
    for (int t = 0; t < 2000; ++t) {
        world.step();
        REQUIRE(overlap(world) < 1e-6);
        for (const Event& event : world.events()) told += event.kind == EventKind::held_back;
    }
    CHECK(told == 1);
    for (const Ball& ball : world.balls()) CHECK(ball.state != BallState::drained);
    world.set_ball(world.balls()[0].id, {0.25, 0.5}, {0, 0});
    world.put_back(world.balls()[1].id);
    for (int t = 0; t < 2000; ++t) {
        world.step();
        REQUIRE(overlap(world) < 1e-6);
    }
}

TEST_CASE("the auditor sees two balls that pass through each other within a tick") {
    WorldOptions blind;
    blind.sweep = false;
    World world(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 0}\nscene: []\n"), blind);
    world.add_ball({0.4, 0.5}, {200, 0});
    world.add_ball({0.6, 0.51}, {-200, 0});
    world.record_paths(true);
    Auditor auditor;
    world.step();
    CHECK(overlap_of_balls(world) == 0);
    auditor.after_tick(world);
    CHECK(auditor.report().worst_overlap == Approx(2 * r - 0.01));
}

TEST_CASE("a ball that is shot into a pile that sleeps wakes all of it, and a pile whose support is taken away falls") {
    for (const Integrator integrator : {Integrator::symplectic_euler, Integrator::ballistic}) {
        World world = filled(piles()[1], integrator);
        for (int t = 0; t < 5000; ++t) world.step();
        for (const Ball& ball : world.balls()) REQUIRE(ball.state == BallState::resting);
        World shot = world;
        shot.add_ball({0.25, 0.5}, {0, -3});
        double worst = 0;
        bool woken = false;
        for (int t = 0; t < 3000; ++t) {
            shot.step();
            worst = std::max(worst, overlap(shot));
            woken = woken || shot.balls()[0].state == BallState::rolling;
        }
        CHECK(woken);
        CHECK(worst < 1e-6);
        const double top = world.balls()[3].position.y();
        world.set_ball(world.balls()[0].id, {0.4, 0.5}, {0, 0});
        for (int t = 0; t < 2000; ++t) world.step();
        CHECK(world.balls()[3].position.y() < top - r);
    }
}

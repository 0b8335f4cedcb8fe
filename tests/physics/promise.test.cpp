// The promise: no ball ever passes through a solid, at any speed; energy is exact.
#include "engine/core/trig.h"
#include "engine/game/simulation.h"
#include "engine/physics/bench.h"
#include "engine/physics/scatter.h"
#include "engine/scene/playfield.h"
#include "tests/physics/support.h"
#include "tests/program/random_construction.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double r = 0.0135;

ProgramPtr generated(int obstacles) {
    const auto program = compile(playfield(catalog(), obstacles));
    REQUIRE(program);
    return *program;
}

SimulationSummary soak(const ProgramPtr& program, int balls, double seconds, double speed, WorldOptions options, bool beating) {
    options.balls_collide = false;
    World world(program, options);
    REQUIRE(scatter_balls(world, balls, speed, options.seed) == balls);
    SimulationOptions run;
    run.seconds = seconds;
    run.audit = true;
    const auto ticks = static_cast<std::int64_t>(seconds / world.step_length());
    for (std::int64_t t = 0; beating && t < ticks; ++t)
        for (int i = 0; i < static_cast<int>(program->inputs.size()); ++i)
            if ((t + 7 * i) % 60 == 0) run.inputs.push_back({t, i, (t + 7 * i) / 60 % 2 ? 0.0 : 1.0});
    Game game(std::move(world));
    return simulate(game, run);
}

void check_clean(const SimulationSummary& s) {
    CHECK(s.escaped == 0);
    CHECK(s.finite);
    CHECK(s.max_penetration < 1e-6);
    REQUIRE(s.audit);
    CHECK(s.audit->crossings == 0);
    CHECK(s.audit->worst_depth < 1e-6);
    CHECK(s.audit->segments > 0);
}

}  // namespace

TEST_CASE("a ball at 1000 m/s never passes a 1 mm wall") {
    const ProgramPtr program = program_of("pinfield: 1\ntable: {size: [1, 1]}\nscene:\n  - box: {size: [1mm, 1], at: [0.5, 0.5]}\n");
    for (const double e : {0.0, 0.6, 1.0}) {
        WorldOptions options;
        options.restitution = e;
        World world(program, options);
        for (int i = 0; i < 40; ++i) world.add_ball({0.1 + 0.008 * i, 0.1 + 0.02 * i}, {1000, 5.0 * i - 100});
        world.record_paths(true);
        Auditor auditor;
        for (int t = 0; t < 200; ++t) {
            world.step();
            auditor.after_tick(world);
            for (const Ball& ball : world.balls()) REQUIRE(ball.position.x() < 0.5 - 0.0005 - r + 1e-9);
        }
        CHECK(auditor.report().crossings == 0);
        CHECK(auditor.report().worst_depth <= 0);
    }
}

TEST_CASE("a ball in a hollow hardly wider than itself gains no energy and stays in it, at any speed") {
    const ProgramPtr program = program_of("pinfield: 1\nscene:\n  - domain: {children: [circle: {radius: 13.6mm, at: [0.2, 0.2]}]}\n");
    for (const double speed : {1.0, 50.0, 700.0, 1400.0, 1e5, 1e6}) {
        World world(program);
        world.add_ball({0.20001, 0.2}, {0.707 * speed, 0.708 * speed});
        world.record_paths(true);
        Auditor auditor;
        const double mass = program->physics.ball_mass, gravity = 1.2, step = 1e-3;  // gravity's upper bound
        double energy = world.energy();
        for (int t = 0; t < 50; ++t) {
            world.step();
            auditor.after_tick(world);
            INFO(speed << " m/s, tick " << t);
            // However often it goes round in a tick, gravity pulls once: symplectic Euler adds at most m |v| g h.
            const double pull = gravity * step * (mass * std::sqrt(2 * energy / mass) + mass * gravity * step);
            REQUIRE(world.energy() <= energy * (1 + 1e-9) + pull + mass * gravity * 2e-4);
            energy = world.energy();
        }
        CHECK(auditor.report().crossings == 0);
        CHECK(auditor.report().worst_depth < 1e-6);
    }
}

TEST_CASE("no ball enters the first table's solids at 1, 10, 100 and 1000 m/s, with the flippers still and beating") {
    const ProgramPtr program = first_table();
    for (const double speed : {1.0, 10.0, 100.0, 1000.0})
        for (const bool beating : {false, true})
            for (const bool elastic : {false, true}) {
                INFO(speed << " m/s, beating " << beating << ", elastic " << elastic);
                WorldOptions options;
                if (elastic) options.restitution = 1;
                check_clean(soak(program, 10, speed > 50 ? 0.02 : 0.2, speed, options, beating));
            }
}

namespace {

/// A solid of operators over operators with walls down to 1/5000 of it, on an even table.
ProgramPtr constructed(std::uint64_t seed, int depth) {
    Scene scene(test::catalog());
    test::set(scene.table(), "size", Vec2(2, 2));
    test::set(scene.table(), "slope", 0.0);
    const NodeId top = test::RandomConstruction(scene, seed, 1.0 / 5000).grow({}, depth);
    test::set(*scene.find(top), "at", Vec2(1, 1));
    return test::compiled(scene);
}

void check_constructions(std::uint64_t first, int count, int deepest) {
    std::int64_t hits = 0;
    for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
        const ProgramPtr program = constructed(seed, 1 + static_cast<int>(seed % static_cast<std::uint64_t>(deepest)));
        for (const double speed : {1.0, 10.0, 100.0, 1000.0}) {
            INFO("seed " << seed << " at " << speed << " m/s");
            WorldOptions options;
            options.balls_collide = false;
            World world(program, options);
            if (scatter_balls(world, 10, speed, seed) == 0) continue;  // a solid all over the table
            SimulationOptions run;
            run.seconds = speed > 50 ? 0.02 : 0.2;
            run.audit = true;
            Game game(std::move(world));
            const SimulationSummary summary = simulate(game, run);
            check_clean(summary);
            hits += at(summary.events, EventKind::hit);
        }
    }
    CHECK(hits > 10 * count);
}

}  // namespace

TEST_CASE("no ball enters a solid of any operators over walls, pins and gaps far thinner than itself, at any speed") {
    check_constructions(1, 6, 3);
}

TEST_CASE("no ball enters a solid of operators over operators over walls far thinner than itself, at any speed", "[slow]") {
    check_constructions(5000, 60, 6);
}

TEST_CASE("the auditor complains when the sweep is switched off") {
    WorldOptions options;
    options.sweep = false;
    const SimulationSummary s = soak(generated(200), 20, 0.05, 30, options, false);
    CHECK(s.audit->crossings > 0);
    CHECK(s.audit->worst_depth > 1e-3);
    CHECK(s.escaped > 0);
}

TEST_CASE("elastic ballistic flight among static solids keeps its energy to 1e-9 over 10 s") {
    WorldOptions options;
    options.restitution = 1;
    options.integrator = Integrator::ballistic;
    options.balls_collide = false;
    const ProgramPtr program = generated(200);
    for (const double speed : {1.0, 10.0}) {
        World world(program, options);
        scatter_balls(world, 10, speed, 3);
        std::vector<double> first;
        for (const Ball& ball : world.balls()) first.push_back(world.energy(ball));
        for (int i = 0; i < 10000; ++i) world.step();
        for (std::size_t i = 0; i < first.size(); ++i) CHECK(relative_error(world.energy(world.balls()[i]), first[i]) < 1e-9);
        CHECK(world.stats().capped_ticks == 0);
        CHECK(world.stats().impacts > 100);
    }
}

TEST_CASE("the free path pays for most ball-steps and changes nothing") {
    const BenchResult bench = bench_simulation(generated(200), 20, 1, 500);
    CHECK(bench.free_share > 0.5);
    CHECK(bench.energy_drift < 1e-9);
}

TEST_CASE("balls in a solid after an edit come out at bounded speed, without energy") {
    const std::string before = room(1, 1, ", slope: 0", "", "  - circle: {id: c, radius: 0.05, at: [0.3, 0.3]}\n");
    const std::string after = room(1, 1, ", slope: 0", "", "  - circle: {id: c, radius: 0.05, at: [0.62, 0.5]}\n");
    World world(program_of(before));
    world.add_ball({0.6, 0.5}, {0, 0});
    world.set_program(program_of(after));
    for (int i = 0; i < 200; ++i) {
        const Vec2 from = world.balls()[0].position;
        world.step();
        CHECK(length(world.balls()[0].position - from) <= 2.1e-3);
    }
    CHECK(gap_at(world, world.balls()[0].position).distance >= r);
    CHECK(length(world.balls()[0].velocity) < 1e-9);
}

TEST_CASE("a number that is no number takes its ball out of the game and says so") {
    World world(program_of(room(1, 1, "", "", "")));
    world.add_ball({0.5, 0.5}, {0, 0});
    const BallId lost = world.add_ball({0.2, 0.2}, {0, 0});
    world.set_ball(lost, {0.2, 0.2}, {std::nan(""), 0});
    bool reported = false;
    for (int i = 0; i < 50; ++i) {
        world.step();
        for (const Event& event : world.events()) reported = reported || event.kind == EventKind::quarantine;
    }
    CHECK(reported);
    CHECK(world.find(lost)->state == BallState::quarantined);
    CHECK(world.balls()[0].velocity.y() < 0);
}

TEST_CASE("a drained ball leaves the game and can be put back") {
    World world(
        program_of(room(1, 1, "", "", "  - drain: {id: d, at: [0.5, 0.05], size: [0.2, 20mm]}\n  - spawn: {id: s, at: [0.5, 0.3]}\n")));
    world.add_spawned_balls();
    bool drained = false;
    for (int i = 0; i < 3000 && !drained; ++i) {
        world.step();
        for (const Event& event : world.events()) drained = drained || event.kind == EventKind::drain;
    }
    REQUIRE(drained);
    const Vec2 there = world.balls()[0].position;
    for (int i = 0; i < 10; ++i) world.step();
    CHECK(world.balls()[0].position == there);
    world.put_back(world.balls()[0].id);
    CHECK(world.balls()[0].position == Vec2(0.5, 0.3));
    CHECK(world.balls()[0].state == BallState::rolling);
}

TEST_CASE("a ball is put back where its spawn is by then, and where that last was when it is gone") {
    const auto table = [](const std::string& spawn) {
        return program_of(room(1, 1, ", slope: 0", "", "  - drain: {id: d, at: [0.5, 0.05], size: [0.2, 20mm]}\n" + spawn));
    };
    World world(table("  - spawn: {id: s, at: [0.5, 0.3], velocity: [0, 1]}\n"));
    world.add_spawned_balls();
    const BallId thrown = world.add_ball({0.2, 0.2}, {0, 0});
    world.set_program(table("  - spawn: {id: s, at: [0.4, 0.35], turn: 90, velocity: [0, 2]}\n"));
    CHECK(world.balls()[0].position == Vec2(0.5, 0.3));
    for (int i = 0; i < 2; ++i) {
        world.put_back(world.balls()[0].id);
        world.put_back(thrown);
        CHECK(world.balls()[0].position == Vec2(0.4, 0.35));
        CHECK(world.balls()[0].velocity == Vec2(-2, 0));
        CHECK(world.find(thrown)->position == Vec2(0.2, 0.2));
        world.set_program(table(""));
    }
}

TEST_CASE("balls are scattered over free space, and not into a drain") {
    World world(program_of("pinfield: 1\ntable: {size: [0.5, 0.5], slope: 0}\nscene:\n  - circle: {radius: 0.1, at: [0.25, 0.4]}\n"
                           "  - drain: {at: [0.25, 0.1], size: [0.5, 0.2]}\n"));
    REQUIRE(scatter_balls(world, 200, 1, 7) == 200);
    for (const Ball& ball : world.balls()) {
        CHECK(gap_at(world, ball.position).distance >= r);
        CHECK(ball.position.y() > 0.2);
    }
}

TEST_CASE("a ball is put back only when no mover stands where it starts") {
    World world(
        program_of("pinfield: 1\ntable: {size: [1, 1], slope: 0}\ninputs: {left: [Z]}\nscene:\n  - flipper: {at: [0.5, 0.5], rest: -40, "
                   "swing: 80, input: [left]}\n"
                   "  - drain: {at: [0.9, 0.5], size: [0.05, 0.05]}\n"));
    const BallId ball = world.add_ball({0.55, 0.545}, {0, 0});  // where the raised bat stands
    world.set_ball(ball, {0.85, 0.5}, {1, 0});
    world.set_input(0, 1);
    for (int i = 0; i < 100; ++i) world.step();
    REQUIRE(world.find(ball)->state == BallState::drained);
    world.put_back(ball);
    CHECK(world.find(ball)->state == BallState::drained);
    world.set_input(0, 0);
    for (int i = 0; i < 200; ++i) world.step();
    CHECK(world.find(ball)->state != BallState::drained);
    CHECK(world.find(ball)->position == Vec2(0.55, 0.545));
}

// Same inputs, same bits: from one run to the next, and from every compiler at every level of optimisation.
#include "engine/core/hash.h"
#include "engine/core/rng.h"
#include "engine/physics/scatter.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

TEST_CASE("a snapshot plays on as the original does") {
    World world(first_table());
    world.add_spawned_balls();
    scatter_balls(world, 5, 2, 1);
    for (int i = 0; i < 100; ++i) world.step();
    World copy = world;
    for (int i = 0; i < 500; ++i) {
        world.step();
        copy.step();
    }
    CHECK(world.state_hash() == copy.state_hash());
}

// Proves determinism only, never correctness: the number may change with every improvement, but not with the compiler.
TEST_CASE("a scripted game has the same hash from every compiler at every level of optimisation") {
    const ProgramPtr program = program_of(
        "pinfield: 1\ntable: {size: [0.5, 1], slope: 6.5}\ninputs: {left: [Z]}\nmaterials: {default: {restitution: 0.8, falloff: 0.3, "
        "tangential: 0.4, scatter: 3}}\n"
        "scene:\n  - domain: {children: [box: {size: [0.5, 1], round: 40mm, at: [0.25, 0.5]}]}\n  - bumper: {at: [0.2, 0.7]}\n  - bumper: "
        "{at: [0.35, 0.6]}\n"
        "  - flipper: {at: [0.2, 0.2], input: [left]}\n  - smooth_union: {k: 20mm, children: [circle: {radius: 20mm, at: [0.1, 0.4]}, "
        "circle: {radius: 15mm, at: [0.13, 0.43]}]}\n"
        "  - ellipse: {radii: [40mm, 20mm], at: [0.4, 0.35]}\n");
    World world(program);
    for (int i = 0; i < 6; ++i) world.add_ball({0.1 + 0.05 * i, 0.85}, {0.3 * i - 0.7, 0.2});
    for (int t = 0; t < 10000; ++t) {
        if (t % 150 == 0) world.set_input(0, t / 150 % 2 ? 0 : 1);
        world.step();
    }
    CHECK(hex16(world.state_hash()) == "7fca5823365189fb");
}

/// As a person would play it: every input now and then, a ball that drains comes back.
TEST_CASE("a hundred thousand ticks of the first table have the same hash from every compiler at every level of optimisation") {
    World world(first_table());
    world.add_spawned_balls();
    scatter_balls(world, 2, 1, 5);
    CounterRng player(2026);
    std::vector<bool> held(world.program().inputs.size(), false);
    int drained = 0;
    for (int t = 0; t < 100000; ++t) {
        for (std::size_t i = 0; i < held.size(); ++i) {
            if (player.in(0, 1) > (held[i] ? 0.01 : 0.002)) continue;
            held[i] = !held[i];
            world.set_input(static_cast<int>(i), held[i] ? 1 : 0);
        }
        world.step();
        const std::vector<Event> events(world.events().begin(), world.events().end());
        for (const Event& event : events)
            if (event.kind == EventKind::drain) ++drained, world.put_back(event.ball);
    }
    CHECK(drained > 10);
    CHECK(world.stats().impacts > 10000);
    CHECK(hex16(world.state_hash()) == "d3682bf1fa91d765");
}

// What persists from tick to tick is all that the future depends on, and all of it is in the hash.
#include <set>

#include "engine/core/rng.h"
#include "engine/physics/persistent_state.h"
#include "engine/physics/scatter.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

/// A hollow, blends, a tree without end, flippers of both hands, a plunger, a drain, solids in another layer, surfaces that scatter.
const std::string crowded_table =
    "pinfield: 1\ntable: {size: [0.5, 1], slope: 6.5}\ninputs: {left: [Z], right: [Slash], plunge: [Space]}\n"
    "materials: {default: {restitution: 0.7, falloff: 0.3, tangential: 0.4, scatter: 3}}\nscene:\n"
    "  - domain: {children: [box: {size: [0.5, 1], round: 60mm, at: [0.25, 0.5]}]}\n"
    "  - difference: {at: [0.25, 0.35], turn: 40, children: [box: {size: [0.2, 0.05]}, circle: {radius: 70mm, at: [0, 70mm]}]}\n"
    "  - round: {radius: 1mm, children: [intersection: {at: [0.08, 0.92], turn: 180, children: [half_plane: {}, half_plane: {turn: 90}]}]}\n"
    "  - smooth_union: {k: 20mm, children: [circle: {radius: 20mm, at: [0.1, 0.5]}, circle: {radius: 15mm, at: [0.13, 0.53]}]}\n"
    "  - ellipse: {radii: [40mm, 20mm], at: [0.4, 0.6], layer: upstairs}\n  - bumper: {at: [0.3, 0.75]}\n  - bumper: {at: [0.15, 0.8]}\n"
    "  - flipper: {at: [0.15, 0.15], input: [left]}\n  - flipper: {at: [0.35, 0.15], flip: x, input: [right]}\n"
    "  - plunger: {at: [0.45, 0.2], stroke: 40mm, input: [plunge]}\n  - drain: {at: [0.25, 0.04], size: [0.4, 20mm]}\n"
    "  - spawn: {at: [0.25, 0.9], velocity: [0.3, 0]}\n  - spawn: {at: [0.39, 0.42]}\n";

/// Every input now and then: what a person would do, from tick and seed alone.
void press_at_random(World& world, std::uint64_t seed) {
    CounterRng player(seed, static_cast<std::uint64_t>(world.tick()));
    for (std::size_t i = 0; i < world.program().inputs.size(); ++i)
        if (player.in(0, 1) < 0.01) world.set_input(static_cast<int>(i), player.in(0, 1) < 0.5 ? 1 : 0);
}

void put_back_drained(World& world) {
    const std::vector<Event> events(world.events().begin(), world.events().end());
    for (const Event& event : events)
        if (event.kind == EventKind::drain) world.put_back(event.ball);
}

/// Two states that differ in everything, so that a member which is left out of one does not hide in the other.
PersistentState sample(bool other) {
    PersistentState state;
    state.balls.resize(2);
    state.memories.resize(2);
    state.movers.resize(2);
    state.pressed = {0, 1};
    state.edges.resize(2);
    state.open_touches.resize(2);
    double next = other ? -7.25 : 0;
    each_value(state, [&](auto& value) {
        using T = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<T, double>) value = next += 0.5;
        if constexpr (std::is_same_v<T, bool>) value = other;
        if constexpr (requires { value.has_value(); }) {
            if (other) value.emplace();
        }
    });
    return state;
}

/// Changes the n-th value by as little as it can be changed.
class Change {
public:
    explicit Change(int n) : n_(n) {}
    bool done() const { return n_ < 0; }

    template <class T>
    void operator()(T& value) {
        if (n_-- != 0) return;
        if constexpr (std::is_same_v<T, double>) value = std::nextafter(value, infinity);
        else if constexpr (std::is_same_v<T, bool>) value = !value;
        else if constexpr (std::is_arithmetic_v<T>) ++value;
        else if constexpr (std::is_enum_v<T>) value = static_cast<T>(static_cast<int>(value) + 1);
        else if constexpr (requires { value.has_value(); }) value ? value.reset() : static_cast<void>(value.emplace());
        else value.emplace_back();
    }

private:
    int n_;
};

}  // namespace

TEST_CASE("the smallest change of any one value that persists changes the hash") {
    for (const bool other : {false, true}) {
        std::set<std::uint64_t> hashes{hash_of(sample(other))};
        int changes = 0;
        for (bool done = true; done; ++changes) {
            PersistentState state = sample(other);
            Change change(changes);
            each_value(state, change);
            done = change.done();
            INFO("value " << changes);
            if (done) CHECK(hashes.insert(hash_of(state)).second);
        }
        // Six options, tick and next ball, six lists; of two of each: a ball's 14 numbers, its memory's 12, a touch's 15, a mover's 10, an
        // input, an edge's 2.
        CHECK(changes - 1 == 6 + 3 * other + 2 + 6 + 2 * (14 + 12 + 15 + 10 + 1 + 2));
    }
}

TEST_CASE("a world's hash sees what is still to come of it: inputs that wait, places where balls start, the next ball's id") {
    World world(program_of(crowded_table));
    world.add_spawned_balls();
    std::set<std::uint64_t> hashes{world.state_hash()};
    const auto changes = [&](auto&& change) {
        World copy = world;
        CHECK(copy.state_hash() == world.state_hash());
        change(copy);
        return hashes.insert(copy.state_hash()).second;
    };
    CHECK(changes([](World& w) { w.set_input(0, 1); }));
    CHECK(changes([](World& w) { w.set_input(1, 1); }));
    CHECK(changes([](World& w) { w.add_ball({0.25, 0.5}, {0, 0}); }));
    CHECK(changes([](World& w) { w.set_ball(w.balls()[0].id, {std::nextafter(0.25, 1.0), 0.9}, {0.3, 0}); }));
    CHECK(changes([](World& w) { w.set_ball(w.balls()[0].id, {0.3, 0.75}, {0.3, 0}); }));  // embedded in a bumper
    CHECK(changes([](World& w) { w.step(); }));
    WorldOptions seeded;
    seeded.seed = 2;
    World other(world.shared_program(), seeded);
    other.add_spawned_balls();
    CHECK(hashes.insert(other.state_hash()).second);
}

TEST_CASE("worlds of equal hash stay equal under equal inputs for ten thousand ticks, wherever a snapshot was taken") {
    const int table = GENERATE(0, 1, 2, 3);
    WorldOptions options;
    if (table >= 2) options.integrator = Integrator::ballistic;
    if (table == 3) options.restitution = 1;
    World world(table % 2 == 0 ? first_table() : program_of(crowded_table), options);
    world.add_spawned_balls();
    REQUIRE(scatter_balls(world, 3, 2, 11) == 3);
    constexpr int ticks = 10000;
    const auto seed = static_cast<std::uint64_t>(table);
    CounterRng when(77, seed);
    std::vector<World> copies;
    int next = 0, drained = 0, held = 0;
    for (int t = 0; t < 2 * ticks; ++t) {
        press_at_random(world, seed);
        for (World& copy : copies) press_at_random(copy, seed);
        if (t == next && t < ticks) {  // in the middle of things: inputs pressed, and some that are not applied yet
            copies.push_back(world);
            next += 1 + static_cast<int>(when.in(0, ticks / 3));
        }
        world.step();
        for (const MoverState& mover : world.movers()) held += mover.driven;
        for (const Event& event : world.events()) drained += event.kind == EventKind::drain;
        put_back_drained(world);
        for (World& copy : copies) {
            copy.step();
            put_back_drained(copy);
            INFO("table " << table << ", tick " << t);
            REQUIRE(copy.state_hash() == world.state_hash());
        }
    }
    CHECK(copies.size() >= 4);
    CHECK(held > 0);
    CHECK(drained > 0);
    CHECK(world.stats().impacts > 300);
}

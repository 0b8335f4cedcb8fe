// Balls that cannot start where they should: told with place and hint, held back, and judged alike by referee and auditor.
#include "engine/game/starts.h"

#include <fmt/format.h>

#include <string_view>

#include "engine/core/error_codes.h"
#include "engine/core/numbers.h"
#include "engine/core/rng.h"
#include "engine/game/simulation.h"
#include "engine/physics/free_place.h"
#include "engine/physics/start.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double r = 0.0135;

const std::string flat = "pinfield: 1\ntable: {size: [1, 1], slope: 0}\n";
const std::string things =
    "inputs: {go: [Space]}\nscene:\n  - domain: {id: air, children: [box: {size: [0.8, 0.8], at: [0.5, 0.5]}]}\n"
    "  - circle: {id: rock, at: [0.5, 0.5], radius: 0.1}\n  - drain: {id: out, at: [0.3, 0.2], size: [0.1, 40mm]}\n"
    "  - flipper: {id: bat, at: [0.2, 0.8], rest: 0, swing: 60, input: [go]}\n";

Reading table_of(const std::string& text) { return read_table(std::make_shared<const SourceText>("test.yaml", text), catalog()); }

/// Text that places a spawn.
std::string spawn(double x, double y) { return "  - spawn: {at: [" + std::to_string(x) + ", " + std::to_string(y) + "]}\n"; }

int count(const World& world, EventKind kind) {
    int found = 0;
    for (const Event& event : world.events()) found += event.kind == kind;
    return found;
}

}  // namespace

TEST_CASE("what keeps a ball from starting is named, with the depth that geometry gives") {
    const Reading read = table_of(flat + things);
    const ProgramPtr program = compiled(read);
    struct Case {
        Vec2 at;
        Hindrance hindrance;
        std::string_view node;
        double depth;
    };
    for (const Case& c : {Case{{0.5, 0.62}, Hindrance::none, "", 0},
                          Case{{0.5, 0.6 + r}, Hindrance::none, "", 0},  // touches the rock
                          Case{{0.5, 0.61}, Hindrance::solid, "rock", r - 0.01},
                          Case{{0.5, 0.55}, Hindrance::solid, "rock", r + 0.05},
                          Case{{0.11, 0.4}, Hindrance::solid, "air", r - 0.01},  // its centre is inside
                          Case{{0.08, 0.4}, Hindrance::outside, "air", r + 0.02},
                          Case{{-3, 0.4}, Hindrance::outside, "air", r + 3.1},
                          Case{{0.3, 0.2}, Hindrance::drain, "out", 0},
                          Case{{0.3, 0.23}, Hindrance::none, "", 0},  // a drain takes centres
                          Case{{0.2, 0.8}, Hindrance::mover, "bat", r + 0.0116}}) {
        INFO(c.at.transpose());
        const Start start = start_at(*program, c.at);
        CHECK(start.hindrance == c.hindrance);
        CHECK((start.node ? read.scene.path(start.node) : "") == c.node);
        CHECK(start.depth == Approx(c.depth).margin(1e-9));
    }
}

TEST_CASE("the hint of an impossible start is a place in whole millimetres from where a ball starts") {
    const Reading read = table_of(flat + things);
    const ProgramPtr program = compiled(read);
    CounterRng rng(5);
    int impossible = 0;
    for (int n = 0; n < 300; ++n) {
        const Vec2 at{rng.in(-0.5, 1.5), rng.in(-0.5, 1.5)};
        const auto found = impossible_start(*program, read.scene, at, ground_layer, {});
        CHECK(found.has_value() == (start_at(*program, at).hindrance != Hindrance::none));
        if (!found) continue;
        ++impossible;
        const std::string_view hint = found->hint, words = "the nearest place on the table with room for a ball is [";
        REQUIRE(hint.starts_with(words));
        const std::size_t comma = hint.find(", ", words.size()), end = hint.find(']', words.size());
        REQUIRE((comma < end && end < hint.size()));
        const double x = parse_number(hint.substr(words.size(), comma - words.size())).value();
        const double y = parse_number(hint.substr(comma + 2, end - comma - 2)).value();
        CHECK(start_at(*program, {x, y}).hindrance == Hindrance::none);
        CHECK(std::fabs(1e3 * x - std::round(1e3 * x)) < 1e-6);
        // Nothing much nearer has room: as brute force over a grid of 5 mm finds it.
        double least = infinity;
        for (int i = 20; i < 180; ++i)
            for (int j = 20; j < 180; ++j) {
                const Vec2 there{0.005 * i, 0.005 * j};
                if (start_at(*program, there).hindrance == Hindrance::none)
                    least = std::min(least, length(there - Vec2(std::clamp(at.x(), 0.0, 1.0), std::clamp(at.y(), 0.0, 1.0))));
            }
        CHECK(length(Vec2(x, y) - Vec2(std::clamp(at.x(), 0.0, 1.0), std::clamp(at.y(), 0.0, 1.0))) < least + 0.005);
    }
    CHECK(impossible > 100);
}

TEST_CASE("a ball that cannot start is held back, told once with what is there, and starts when there is room") {
    for (const auto& [x, y, node] : {std::tuple{0.5, 0.55, "rock"}, std::tuple{0.5, 0.605, "rock"}, std::tuple{0.05, 0.5, "air"}, std::tuple{0.3, 0.2, "out"}}) {
        INFO(node);
        const Reading read = table_of(flat + things + spawn(x, y));
        World world(compiled(read));
        world.add_spawned_balls();
        Game game(std::move(world), parents_of(read.scene));
        int told = 0;
        for (int t = 0; t < 3000; ++t) {
            game.step();
            CHECK(game.world().balls()[0].state == BallState::drained);
            told += count(game.world(), EventKind::held_back);
            for (const Event& event : game.world().events()) CHECK((event.node ? read.scene.path(event.node) : "") == node);
        }
        CHECK(told == 1);
        CHECK(game.drained() == 0);
        Reading moved = table_of(flat + things + spawn(0.2, 0.5));
        moved.scene.keep_ids_of(read.scene);
        game.set_program(compiled(moved), parents_of(moved.scene));
        game.step();
        CHECK(game.world().balls()[0].state == BallState::rolling);
        CHECK(game.world().balls()[0].position == Vec2(0.2, 0.5));
    }
}

TEST_CASE("a ball that starts on what it touches starts there, at rest") {
    const std::string text = "pinfield: 1\ntable: {size: [1, 1], slope: 6.5}\ninputs: {go: [Space]}\nscene:\n"
                             "  - plunger: {at: [0.7, 0.1], input: [go]}\n";
    for (const Vec2& at : {Vec2(0.5, r), Vec2(0.7, 0.1 + r)}) {
        World world(program_of(text + spawn(at.x(), at.y())));
        world.add_spawned_balls();
        CHECK(world.balls()[0].state == BallState::rolling);
        world.put_back(world.balls()[0].id);
        for (int t = 0; t < 100; ++t) world.step();
        CHECK(length(world.balls()[0].position - at) < 1e-6);
    }
}

TEST_CASE("a ball whose start a flipper takes waits until the flipper is out of the way") {
    World world(program_of(flat + things + spawn(0.26, 0.805)));
    world.add_spawned_balls();
    for (int t = 0; t < 100; ++t) world.step();
    CHECK(world.balls()[0].state == BallState::drained);
    world.set_input(0, 1);
    for (int t = 0; t < 200; ++t) world.step();
    CHECK(world.balls()[0].state != BallState::drained);
}

// Whatever the referee sees the auditor sees, who looks at the ends of ticks as well as between them.
TEST_CASE("referee and auditor agree about balls that an editor's hand puts anywhere") {
    int escaped = 0, deep = 0;
    for (std::uint64_t n = 0; n < 60; ++n) {
        CounterRng rng(n, 0x57a27);
        const auto drawn = [&](double lo, double hi) { return std::to_string(rng.in(lo, hi)); };
        const std::string x = drawn(0.2, 0.8), y = drawn(0.2, 0.8), height = drawn(0.002, 0.2), turn = drawn(0, 90);
        const std::string walls = fmt::format("  - box: {{at: [{}, {}], size: [0.2, {}], turn: {}}}\n", x, y, height, turn);
        World world(program_of(fmt::format("pinfield: 1\ntable: {{size: [1, 1], slope: 6.5}}\n{}{}", things, walls)));
        for (int k = 0; k < 3; ++k) world.add_ball({rng.in(-0.1, 1.1), rng.in(-0.1, 1.1)}, {rng.in(-1, 1), rng.in(-1, 1)});
        Game game(std::move(world));
        SimulationOptions how;
        how.seconds = 0.2;
        how.audit = true;
        const SimulationSummary summary = simulate(game, how);
        REQUIRE(summary.audit);
        INFO("table " << n);
        CHECK(std::max(summary.audit->worst_depth, summary.audit->worst_overlap) >= summary.max_penetration);
        if (summary.escaped > 0) CHECK(summary.audit->worst_depth > r);
        if (summary.escaped > 0) CHECK(summary.audit->crossings > 0);
        escaped += summary.escaped;
        deep += summary.max_penetration > 1e-6;
    }
    CHECK(escaped > 20);
    CHECK(deep > 20);
}

TEST_CASE("the auditor sees a ball where it stands, though it has no path") {
    World world(program_of(flat + things));
    const BallId ball = world.add_ball({0.5, 0.7}, {0, 0});
    world.record_paths(true);
    Auditor auditor;
    auditor.after_tick(world);
    CHECK(auditor.report().worst_depth == 0);
    world.set_ball(ball, {0.5, 0.58}, {0, 0});
    auditor.after_tick(world);
    CHECK(auditor.report().segments == 0);
    CHECK(auditor.report().worst_depth == Approx(r + 0.02));
    CHECK(auditor.report().crossings == 1);
}

TEST_CASE("a ball of another layer does not stand in the way of one that looks for a free place") {
    World world(program_of("pinfield: 1\ntable: {size: [1, 1], slope: 0}\nscene:\n  - circle: {at: [0.5, 0.5], radius: 0.1}\n"
                           "  - spawn: {layer: [upstairs], at: [0.5, 0.62]}\n  - spawn: {at: [0.3, 0.3]}\n"));
    world.add_spawned_balls();
    const Ball upstairs = world.balls()[0], ground = world.balls()[1];
    REQUIRE_FALSE(share_layer(upstairs, ground));
    world.set_ball(ground.id, {0.5, 0.59}, {0, 0});
    const auto place = free_place(world, *world.find(ground.id), 0.25);
    REQUIRE(place);
    CHECK(length(*place - Vec2(0.5, 0.6 + r)) < 1e-4);  // where the other ball is, had they a layer in common
    world.set_ball(upstairs.id, {0.8, 0.8}, {0, 0});
    world.add_ball({0.5, 0.62}, {0, 0});
    const auto farther = free_place(world, *world.find(ground.id), 0.25);
    REQUIRE(farther);
    CHECK(length(*farther - *place) > 0.5 * r);
}

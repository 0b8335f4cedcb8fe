// What a game agrees on above the world: hits, drained balls and their return, the log of inputs.
#include "engine/game/game.h"

#include "engine/core/rng.h"
#include "engine/game/simulation.h"
#include "engine/physics/scatter.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

/// A scene and what it compiles to.
struct Table {
    Scene scene;
    ProgramPtr program;

    explicit Table(const std::string& text, const Scene* ids_from = nullptr)
        : Table(read_table(std::make_shared<const SourceText>("test.yaml", text), catalog()), ids_from) {}
    explicit Table(Reading read, const Scene* ids_from = nullptr) : scene(catalog()) {
        if (ids_from) read.scene.keep_ids_of(*ids_from);
        program = compiled(read);
        scene = std::move(read.scene);
    }
    NodeId operator[](std::string_view path) const { return scene.find(path)->id; }
};

/// One ball of this motion; balls at the table's spawns besides.
Game game_with_ball(const Table& table, const Vec2& position, const Vec2& velocity) {
    World world(table.program);
    world.add_spawned_balls();
    world.add_ball(position, velocity);
    return Game(std::move(world), parents_of(table.scene));
}

void run(Game& game, int ticks) {
    for (int t = 0; t < ticks; ++t) game.step();
}

/// Runs until it has events of this kind in its last tick.
void run_until(Game& game, EventKind kind) {
    const std::int64_t before = game.events().at(static_cast<std::size_t>(kind));
    for (int t = 0; t < 3000 && game.events().at(static_cast<std::size_t>(kind)) == before; ++t) game.step();
    REQUIRE(game.events().at(static_cast<std::size_t>(kind)) > before);
}

const std::string still = "pinfield: 1\ntable: {size: [1, 1], slope: 0}\n";

/// Every input now and then.
void press_at_random(Game& game, CounterRng& player) {
    for (std::size_t i = 0; i < game.world().program().inputs.size(); ++i)
        if (player.in(0, 1) < 0.01) game.set_input(static_cast<int>(i), player.in(0, 1) < 0.5 ? 1 : 0);
}

}  // namespace

TEST_CASE("a bumper that kicks is hit once, and so is one that is too slow for a kick") {
    const Table table(still + "scene:\n  - bumper: {id: pop, at: [0.5, 0.5], kick: 0.8, threshold: 0.1}\n  - box: {id: wall, at: [0.5, 0.2]}\n");
    for (const double speed : {0.09, 0.5}) {
        Game game = game_with_ball(table, {0.5, 0.56}, {0, -speed});
        run_until(game, EventKind::hit);
        CHECK(game.events().at(static_cast<std::size_t>(EventKind::kick)) == (speed > 0.1 ? 1 : 0));
        CHECK(game.hits_of(table["pop"]) == 1);
        CHECK(game.bumper_hits() == 1);
        CHECK(game.hits_of(table["wall"]) == 0);
    }
}

TEST_CASE("a group and an operation are hit when anything in them is, once for each ball and tick") {
    // A ball falls into the corner between two boxes of a group and meets both in one tick; another ball meets the union's circle.
    const Table table(still +
                      "materials: {default: {restitution: 0}}\nscene:\n  - group: {id: outer, children: [group: {id: corner, children: [\n"
                      "      box: {id: floor, at: [0.2, 0.1], size: [0.2, 20mm]}, box: {id: side, at: [0.1, 0.2], size: [20mm, 0.2]}]}]}\n"
                      "  - union: {id: pair, at: [0.7, 0.5], children: [circle: {id: left, at: [-0.1, 0]}, circle: {id: right, at: [0.1, 0]}]}\n");
    const double r = table.program->physics.ball_radius;
    Game game = game_with_ball(table, {0.11 + r + 0.01, 0.11 + r + 0.01}, {-1, -1});
    run_until(game, EventKind::hit);
    run(game, 5);
    CHECK(game.events().at(static_cast<std::size_t>(EventKind::hit)) == 2);
    CHECK(game.hits_of(table["floor"]) == 1);
    CHECK(game.hits_of(table["side"]) == 1);
    CHECK(game.hits_of(table["corner"]) == 1);
    CHECK(game.hits_of(table["outer"]) == 1);
    Game other = game_with_ball(table, {0.8, 0.6}, {0, -1});
    run_until(other, EventKind::hit);
    CHECK(other.hits_of(table["right"]) == 1);
    CHECK(other.hits_of(table["left"]) == 0);
    CHECK(other.hits_of(table["pair"]) == 1);
    CHECK(other.hits_of(table["outer"]) == 0);
    CHECK(other.bumper_hits() == 0);
}

TEST_CASE("two balls that hit the same node in one tick hit it twice") {
    const Table table(still + "scene:\n  - bumper: {id: pop, at: [0.5, 0.5]}\n");
    Game game = game_with_ball(table, {0.5, 0.6}, {0, -1});
    World world = game.world();
    world.add_ball({0.5, 0.4}, {0, 1});
    Game both(std::move(world), parents_of(table.scene));
    run_until(both, EventKind::hit);
    CHECK(both.hits_of(table["pop"]) == 2);
    CHECK(both.bumper_hits() == 2);
}

TEST_CASE("a drained ball comes back after a second of the table's time, whatever the tick, or as the options say") {
    const std::string scene = "scene:\n  - spawn: {id: start, at: [0.5, 0.5], velocity: [0, -1]}\n  - drain: {at: [0.5, 0.25], size: [0.4, 0.1]}\n";
    for (const double step : {0.0005, 0.001, 0.004}) {
        const Table table(still + "physics: {step: " + std::to_string(step) + "}\n" + scene);
        for (const double wait : {0.0, 0.25, 1.0}) {
            World world(table.program);
            world.add_spawned_balls();
            Game game(std::move(world), {}, wait == 1.0 ? GameOptions{} : GameOptions{.seconds_until_back = wait});
            run_until(game, EventKind::drain);
            CHECK(game.drained() == 1);
            const double gone = game.world().time();
            const int away = static_cast<int>(std::lround(wait / step));
            for (int t = 0; t < away; ++t) {
                CHECK(game.world().balls()[0].state == BallState::drained);
                game.step();
            }
            CHECK(game.world().time() == Approx(gone + away * step));
            game.step();
            CHECK(game.world().balls()[0].state == BallState::rolling);
            CHECK(game.world().balls()[0].position.y() == Approx(0.5 - step));
        }
    }
}

TEST_CASE("a game goes on with an edited program: counters stay, the ball comes back where its spawn is by then, inputs stay pressed") {
    const auto text = [](const std::string& nodes, const std::string& inputs) {
        return still + "inputs: {" + inputs + "}\nscene:\n  - drain: {id: out, at: [0.5, 0.25], size: [0.4, 0.1]}\n" + nodes;
    };
    const std::string bat = "  - flipper: {id: bat, at: [0.2, 0.8], input: [left]}\n";
    const Table before(text("  - bumper: {id: pop, at: [0.8, 0.5]}\n  - spawn: {id: start, at: [0.5, 0.5], velocity: [0, -1]}\n" + bat, "left: [Z]"));
    Game game = game_with_ball(before, {0.8, 0.56}, {0, -1});
    game.set_input(0, 1);
    run_until(game, EventKind::drain);
    game.set_input(0, 0);  // waits when the program changes
    REQUIRE(game.bumper_hits() == 1);
    const Table after(text("  - spawn: {id: start, at: [0.4, 0.6], velocity: [0, -1]}\n" + bat, "right: [Slash], left: [Z]"), &before.scene);
    game.set_program(after.program, parents_of(after.scene));
    CHECK(game.bumper_hits() == 1);
    CHECK(game.hits_of(before["pop"]) == 1);
    CHECK(game.drained() == 1);
    REQUIRE(game.world().movers()[0].driven);
    game.step();
    CHECK_FALSE(game.world().movers()[0].driven);
    run(game, 1000);
    CHECK(game.world().balls()[0].position.x() == 0.4);
    CHECK(game.world().balls()[0].state == BallState::rolling);
}

TEST_CASE("the log of the inputs, played again in a fresh game, gives the same game") {
    const auto fresh = [] {
        const auto loaded = load_table(test::source_dir() + "/scenes/tables/first_table.yaml", catalog());
        REQUIRE(loaded);
        WorldOptions options;
        options.seed = 9;
        World world(compiled(*loaded), options);
        world.add_spawned_balls();
        scatter_balls(world, 2, 1, 3);
        return Game(std::move(world), parents_of(loaded->scene));
    };
    constexpr int ticks = 20000;
    Game game = fresh();
    CounterRng player(4);
    for (int t = 0; t < ticks; ++t) {
        press_at_random(game, player);
        game.step();
    }
    CHECK(game.input_log().size() > 50);
    CHECK(game.drained() > 3);
    CHECK(game.bumper_hits() > 0);
    Game again = fresh();
    simulate(again, {.seconds = ticks * game.world().step_length(), .inputs = game.input_log()});
    CHECK(again.world().tick() == ticks);
    CHECK(again.state_hash() == game.state_hash());
    CHECK(again.input_log() == game.input_log());
    // A press that is left out is missed.
    std::vector<InputChange> less = game.input_log();
    less.erase(less.begin() + 3);
    Game other = fresh();
    simulate(other, {.seconds = ticks * game.world().step_length(), .inputs = less});
    CHECK(other.state_hash() != game.state_hash());
}

TEST_CASE("the log holds changes only: no repetition, and no input that the table does not have") {
    const Table table(still + "inputs: {left: [Z]}\nscene:\n  - flipper: {at: [0.5, 0.5], input: [left]}\n");
    Game game = game_with_ball(table, {0.1, 0.9}, {0, 0});
    game.set_input(0, 0);
    game.set_input(1, 1);
    game.set_input(-1, 1);
    game.set_input(0, 1);
    game.set_input(0, 1);
    game.step();
    game.set_input(0, 1);
    game.set_input(0, 0);  // a tap between two ticks counts
    game.set_input(0, 1);
    game.step();
    CHECK(game.input_log() == std::vector<InputChange>{{0, 0, 1}, {1, 0, 0}, {1, 0, 1}});
    CHECK(game.events().at(static_cast<std::size_t>(EventKind::press)) == 2);
}

TEST_CASE("a copy of a game goes on as the original does, with a ball on its way back") {
    const Table table(still + "scene:\n  - spawn: {at: [0.5, 0.5], velocity: [0.2, -1]}\n  - drain: {at: [0.5, 0.25], size: [0.4, 0.1]}\n");
    World world(table.program);
    world.add_spawned_balls();
    Game game(std::move(world));
    run_until(game, EventKind::drain);
    run(game, 300);
    Game copy = game;
    CHECK(copy.state_hash() == game.state_hash());
    for (int t = 0; t < 2000; ++t) {
        game.step();
        copy.step();
        REQUIRE(copy.state_hash() == game.state_hash());
    }
    CHECK(game.drained() >= 2);
}

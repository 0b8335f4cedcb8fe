// What a table's own tests measure.
#include "engine/game/table_test.h"

#include "engine/game/simulation.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

/// What the first test of a table finds wrong, in one line.
std::string failures_of(const std::string& text) {
    const Reading read = read_table(std::make_shared<const SourceText>("test.yaml", text), catalog());
    const ProgramPtr program = compiled(read);
    std::string all;
    for (const TestFailure& failure : run_table_test(program, read.scene, read.scene.tests.at(0))) all += failure.message + ";";
    return all;
}

const std::string pit = "pinfield: 1\ntable: {size: [1, 1]}\nscene:\n  - drain: {id: out, at: [0.5, 0.1], size: [0.9, 0.1]}\n"
                        "  - group: {id: top, children: [bumper: {id: pop, at: [0.5, 0.5]}]}\n";

}  // namespace

TEST_CASE("a launched ball drains once in a test, and the drain's hits count it") {
    const std::string launches = "tests:\n  - {launch: [{at: [0.2, 0.4]}, {at: [0.3, 0.4]}], run: 12s, expect: [drained == 2, out.hits == 2, pop.hits == 0]}\n";
    CHECK(failures_of(pit + launches) == "");
    // A ball of the table's comes back, as in a game: it falls for 0.7 s and is away for 1 s.
    CHECK(failures_of(pit + "  - spawn: {at: [0.2, 0.4]}\ntests:\n  - {run: 12s, expect: [drained > 5, out.hits > 5]}\n") == "");
}

TEST_CASE("a test's hands press and let go at their times: a table's flippers and plunger can be tried") {
    const std::string table =
        "pinfield: 1\ntable: {size: [1, 1]}\ninputs: {shoot: [Space], flip: [Z]}\nscene:\n  - plunger: {id: rod, at: [0.5, 0.1], input: [shoot]}\n"
        "  - spawn: {at: [0.5, 0.114]}\n  - bumper: {id: pop, at: [0.5, 0.8]}\n  - flipper: {id: bat, at: [0.1, 0.1], input: [flip]}\n";
    // Drawn for 0.6 s and let go at 0.9 s, at 3.5 m/s; 0.65 m higher it is at the bumper in less than 0.4 s.
    CHECK(failures_of(table + "tests:\n  - {inputs: {shoot: [0.2s, 0.9s]}, run: 1.3s, expect: [pop.hits >= 1]}\n") == "");
    CHECK(failures_of(table + "tests:\n  - {inputs: {shoot: [0.2s, 0.9s]}, run: 0.9s, expect: [pop.hits == 0]}\n") == "");
    CHECK(failures_of(table + "tests:\n  - {inputs: {shoot: 0.2s, flip: [0s, 0.1s]}, run: 3s, expect: [pop.hits >= 1]}\n") ==
          "expected pop.hits >= 1, but pop.hits is 0;");
    const Reading read = read_table(std::make_shared<const SourceText>("test.yaml", table), catalog());
    for (const double drawn : {0.2, 0.4, 0.6}) {  // as the same game played by hand
        World world(compiled(read));
        world.add_spawned_balls();
        Game game(std::move(world), parents_of(read.scene));
        for (int t = 0; t < 3000; ++t) {
            if (t == 100) game.set_input(0, 1);
            if (t == 100 + static_cast<int>(std::lround(1000 * drawn))) game.set_input(0, 0);
            game.step();
        }
        const std::string hits = std::to_string(game.hits_of(read.scene.find("pop")->id));
        CHECK(failures_of(table + "tests:\n  - {inputs: {shoot: [100ms, " + std::to_string(0.1 + drawn) + "]}, run: 3s, expect: [pop.hits == " + hits +
                          "]}\n") == "");
    }
}

TEST_CASE("a test whose launch cannot start fails, whatever it expects") {
    CHECK(failures_of(pit + "tests:\n  - {launch: {at: [0.5, 0.51]}, expect: [escaped == 0]}\n") ==
          "a ball cannot start here: it would be 27.5 mm deep in pop;");
}

TEST_CASE("what would always be 0 is no quantity, and the hint says what counts instead") {
    const auto told = [](const std::string& quantity) {
        const Reading read = read_table(
            std::make_shared<const SourceText>("test.yaml",
                                               "pinfield: 1\nscene:\n  - domain: {id: air, children: [box: {id: room, at: [0.26, 0.53], size: [0.5, 1]}]}\n"
                                               "  - spawn: {id: start, at: [0.26, 0.5]}\n  - group: {id: starts, children: [spawn: {at: [0.3, 0.5]}]}\n"
                                               "  - union: {id: pair, children: [circle: {id: left}, box: {id: right}]}\n"
                                               "tests:\n  - {expect: [" +
                                                   quantity + " == 0]}\n"),
            catalog());
        return read.diagnostics.empty() ? "" : read.diagnostics[0].code + ": " + read.diagnostics[0].message + ": " + read.diagnostics[0].hint;
    };
    CHECK(told("room.hits") == "E0304: room.hits is always 0: room counts as a part of air: air.hits counts both");
    CHECK(told("start.hits") == "E0304: start.hits is always 0: a spawn has no surface, so that nothing hits it");
    CHECK(told("starts.hits") == "E0304: starts.hits is always 0: a group has no surface, so that nothing hits it");
    for (const std::string measured : {"air.hits", "pair.hits", "left.hits", "right.hits"}) CHECK(told(measured) == "");
}

#include "engine/game/table_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/numbers.h"
#include "engine/game/simulation.h"
#include "engine/game/starts.h"

namespace pinfield {
namespace {

bool compare(double a, const std::string& comparison, double b) {
    if (comparison == "==") return a == b;
    if (comparison == "!=") return a != b;
    if (comparison == "<") return a < b;
    if (comparison == "<=") return a <= b;
    if (comparison == ">") return a > b;
    return a >= b;
}

/// Value of `escaped`, `drained` or `<id>.hits`: what the reader lets pass.
double measure(const std::string& quantity, const SimulationSummary& summary, const Game& game, const Scene& scene) {
    if (quantity == "escaped") return summary.escaped;
    if (quantity == "drained") return static_cast<double>(summary.drained);
    const Node* node = scene.find(std::string_view(quantity).substr(0, quantity.rfind('.')));
    return node ? static_cast<double>(game.hits_of(node->id)) : 0;
}

std::vector<InputChange> edges_of(const TableTest& test, const Program& program, double step) {
    std::vector<InputChange> edges;
    for (const TableTest::Hand& hand : test.inputs) {
        const auto input = std::find(program.inputs.begin(), program.inputs.end(), hand.input) - program.inputs.begin();
        double value = 1;
        for (const double time : hand.times) {
            edges.push_back({std::llround(time / step), static_cast<int>(input), value});
            value = 1 - value;
        }
    }
    std::stable_sort(edges.begin(), edges.end(), [](const InputChange& a, const InputChange& b) { return a.tick < b.tick; });
    return edges;
}

std::vector<TestFailure> impossible_launches(const Program& program, const Scene& scene, const TableTest& test) {
    std::vector<TestFailure> failures;
    for (const TableTest::Launch& launch : test.launches)
        if (const auto found = impossible_start(program, scene, launch.at, ground_layer, launch.where))
            failures.push_back({launch.where, found->message});
    return failures;
}

}  // namespace

std::vector<TestFailure> run_table_test(const ProgramPtr& program, const Scene& scene, const TableTest& test) {
    std::vector<TestFailure> failures = impossible_launches(*program, scene, test);
    if (!failures.empty()) return failures;
    World world(program);
    for (const TableTest::Launch& launch : test.launches) world.add_ball(launch.at, launch.velocity);
    if (test.launches.empty()) world.add_spawned_balls();
    GameOptions options;
    options.launched_come_back = false;
    Game game(std::move(world), parents_of(scene), options);
    SimulationOptions how;
    how.seconds = test.run;
    how.inputs = edges_of(test, *program, game.world().step_length());
    const SimulationSummary summary = simulate(game, how);
    for (const TableTest::Expectation& expected : test.expectations) {
        const double found = measure(expected.quantity, summary, game, scene);
        if (compare(found, expected.comparison, expected.value)) continue;
        failures.push_back({expected.where, fmt::format("expected {}, but {} is {}", expected.text, expected.quantity, to_text(found))});
    }
    return failures;
}

}  // namespace pinfield

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

using namespace pinfield::cli_test;
using nlohmann::json;

namespace {

json summary_of(const std::string& arguments) {
    const Outcome outcome = run_pinfield("simulate " + first_table + " --json " + arguments);
    INFO(outcome.err);
    REQUIRE(outcome.exit == 0);
    return json::parse(outcome.out);
}

std::string beating_flippers(const Scratch& scratch, int ticks) {
    std::string text = "tick,input,value\n";
    for (int tick = 0; tick < ticks; tick += 150)
        for (const char* side : {"left", "right"})
            text += std::to_string(tick) + "," + side + ",1\n" + std::to_string(tick + 60) + "," + side + ",0\n";
    return scratch.write("beating.csv", text);
}

}  // namespace

TEST_CASE("a scripted minute on the first table is a game: launched, bumped, drained, launched again") {
    const Scratch scratch;
    const std::string events = scratch / "events.jsonl";
    const json summary = summary_of("--seconds 60 --inputs scenes/tables/first_table.inputs.csv --events " + events);
    CHECK(summary["escaped"] == 0);
    CHECK(summary["drained"].get<int>() >= 2);
    std::map<std::string, int> kicks;
    for (const std::string& line : lines_of(slurp(events))) {
        const json event = json::parse(line);
        if (event["kind"] == "kick") ++kicks[event["node"].get<std::string>()];
    }
    for (const char* bumper : {"pop_left", "pop_right", "pop_top"}) {
        INFO(bumper);
        CHECK(kicks[bumper] >= 1);
    }
}

TEST_CASE("no ball leaves the first table or passes a wall, at any speed", "[slow]") {
    const Scratch scratch;
    const std::string beating = " --inputs " + beating_flippers(scratch, 2000);
    for (const char* run : {"--speed 1 --balls 100 --seconds 2", "--speed 10 --balls 100 --seconds 2",
                            "--speed 100 --balls 50 --seconds 0.5", "--speed 1000 --balls 20 --seconds 0.2"}) {
        for (const char* bounce : {"", " --restitution 1"}) {
            for (const std::string& inputs : {std::string(), beating}) {
                INFO(run << bounce << inputs);
                const json summary = summary_of(std::string(run) + bounce + inputs + " --audit");
                CHECK(summary["escaped"] == 0);
                CHECK(summary["max_penetration"].get<double>() < 1e-6);
                CHECK(summary["audit"]["crossings"] == 0);
                CHECK(summary["audit"]["worst_depth"].get<double>() < 1e-6);
                CHECK_FALSE(summary["events"].contains("quarantine"));
            }
        }
    }
}

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

using namespace pinfield::cli_test;
using nlohmann::json;

namespace {

json summary_of(const std::string& arguments) {
    const Outcome outcome = run_pinfield("simulate " + arguments + " --json");
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.exit == 0);
    return json::parse(outcome.out);
}

/// All but the clock's part, which differs from run to run.
json timeless(json summary) {
    summary.erase("wall_seconds");
    summary.erase("ball_steps_per_second");
    return summary;
}

const std::string box_table =
    "pinfield: 1\ntable: {name: Box, size: [1, 1], slope: 90}\nphysics: {integrator: ballistic}\n"
    "scene:\n  - domain: {children: [box: {size: [1, 1], at: [0.5, 0.5]}]}\n";

}  // namespace

TEST_CASE("the summary has the members it should, and no others without --audit") {
    const json summary = summary_of(first_table + " --seconds 0.2");
    std::vector<std::string> keys;
    for (const auto& [key, value] : summary.items()) keys.push_back(key);
    CHECK(keys == std::vector<std::string>{"ball_steps_per_second", "balls", "capped_queries", "capped_ticks", "drained", "energy_first",
                                           "energy_last", "escaped", "events", "max_overlap", "max_penetration", "state_hash", "table", "ticks", "wall_seconds"});
    CHECK(summary["table"] == "Moonrise");
    CHECK(summary["ticks"] == 200);
    CHECK(summary["balls"] == 1);
    CHECK(summary["escaped"] == 0);
    CHECK(summary["max_penetration"].get<double>() >= 0);
    CHECK(summary["events"].is_object());
    const std::string hash = summary["state_hash"];
    CHECK(hash.size() == 16);
    CHECK(hash.find_first_not_of("0123456789abcdef") == std::string::npos);
    const json audited = summary_of(first_table + " --seconds 0.05 --audit");
    CHECK(audited["audit"]["segments"].get<long>() >= 50);
    CHECK(audited["audit"]["crossings"] == 0);
    CHECK(audited["audit"]["worst_depth"].get<double>() < 1e-6);
}

TEST_CASE("the same inputs give the same bits, another seed others") {
    const std::string run = first_table + " --seconds 3 --inputs scenes/tables/first_table.inputs.csv";
    CHECK(timeless(summary_of(run)) == timeless(summary_of(run)));
    const std::string scattered = first_table + " --seconds 0.5 --balls 20 --speed 2 --seed ";
    const json one = timeless(summary_of(scattered + "1"));
    CHECK(one == timeless(summary_of(scattered + "1")));
    CHECK(one["balls"] == 20);
    CHECK(one["state_hash"] != summary_of(scattered + "2")["state_hash"]);
    // Watching changes nothing.
    CHECK(one["state_hash"] == summary_of(scattered + "1 --audit --trace /dev/null --events /dev/null")["state_hash"]);
}

TEST_CASE("a launched ball flies the exact parabola, and the trace tells it") {
    const Scratch scratch;
    const std::string table = scratch.write("box.yaml", box_table), trace = scratch / "trace.csv";
    const json summary = summary_of(table + " --launch 0.2,0.3,1,2 --seconds 0.3 --trace " + trace);
    CHECK(summary["energy_last"].get<double>() == Approx(summary["energy_first"].get<double>()).epsilon(1e-12));
    CHECK(summary["energy_first"].get<double>() == Approx(0.08 * (0.5 * 5 + 9.81 * 0.3)).epsilon(1e-12));
    const std::vector<std::string> lines = lines_of(slurp(trace));
    REQUIRE(lines.size() >= 301);
    CHECK(lines[0] == "tick,ball,x,y,vx,vy,spin");
    double tick = 0, ball = 0, x = 0, y = 0, vx = 0, vy = 0, spin = 0;
    REQUIRE(std::sscanf(lines.back().c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf", &tick, &ball, &x, &y, &vx, &vy, &spin) == 7);
    CHECK(tick == 300);
    CHECK(x == Approx(0.5).epsilon(1e-12));
    CHECK(y == Approx(0.3 + 2 * 0.3 - 0.5 * 9.81 * 0.09).epsilon(1e-10));
    CHECK(vx == Approx(1).epsilon(1e-12));
    CHECK(vy == Approx(2 - 9.81 * 0.3).epsilon(1e-10));
    CHECK(spin == 0);
}

TEST_CASE("simulate --restitution 1 makes every wall elastic") {
    const Scratch scratch;
    const std::string table = scratch.write("box.yaml", box_table);
    const json elastic = summary_of(table + " --launch 0.5,0.3,0.3,0 --seconds 2 --restitution 1");
    CHECK(elastic["energy_last"].get<double>() == Approx(elastic["energy_first"].get<double>()).epsilon(1e-9));
    const json dull = summary_of(table + " --launch 0.5,0.3,0.3,0 --seconds 2");
    CHECK(dull["energy_last"].get<double>() < 0.9 * dull["energy_first"].get<double>());
}

TEST_CASE("events are one JSON object a line") {
    const Scratch scratch;
    const std::string table = scratch.write("box.yaml", box_table), events = scratch / "events.jsonl";
    const json summary = summary_of(table + " --launch 0.5,0.5,0,0 --seconds 1 --events " + events);
    const std::vector<std::string> lines = lines_of(slurp(events));
    REQUIRE_FALSE(lines.empty());
    std::map<std::string, int> counted;
    for (const std::string& line : lines) {
        const json event = json::parse(line);
        for (const char* key : {"tick", "time", "ball", "kind", "node", "part", "material", "x", "y", "nx", "ny", "speed"}) CHECK(event.contains(key));
        ++counted[event["kind"].get<std::string>()];
    }
    CHECK(json(counted) == summary["events"]);
    const json first = json::parse(lines[0]);
    CHECK(first["kind"] == "hit");
    CHECK(first["node"] == "domain[0]");
    CHECK(first["part"] == "domain[0]");
    CHECK(first["material"] == "default");
    CHECK(first["nx"].get<double>() == Approx(0).margin(1e-12));
    CHECK(first["ny"].get<double>() == Approx(1));
    CHECK(first["speed"].get<double>() == Approx(std::sqrt(2 * 9.81 * (0.5 - 0.0135))).epsilon(1e-6));
}

TEST_CASE("without the sweep balls tunnel, and the auditor says so") {
    const std::string run = first_table + " --balls 30 --speed 100 --seconds 0.2 --audit";
    const json safe = summary_of(run);
    CHECK(safe["escaped"] == 0);
    CHECK(safe["audit"]["crossings"] == 0);
    const json unsafe = summary_of(run + " --no-sweep");
    CHECK(unsafe["audit"]["crossings"].get<long>() + static_cast<long>(unsafe["audit"]["worst_depth"].get<double>() > 1e-6) > 0);
}

TEST_CASE("inputs come from a file of edges, by name") {
    const Scratch scratch;
    const std::string still = "simulate " + first_table + " --seconds 0.1 --json --inputs ";
    CHECK(run_pinfield(still + scratch.write("a.csv", "tick,input,value\n10,left,1\n20,left,0\n")).exit == 0);
    for (const char* text : {"tick,input\n", "tick,input,value\n10,lift,1\n", "tick,input,value\n-1,left,1\n",
                             "tick,input,value\n1.5,left,1\n", "tick,input,value\n1,left,high\n",
                             "tick,input,value\n1,left,2\n", "tick,input,value\n1,left,0.5\n"}) {
        INFO(text);
        const Outcome outcome = run_pinfield(still + scratch.write("b.csv", text));
        CHECK(outcome.exit == 3);
        CHECK_THAT(outcome.err, Catch::Contains("b.csv:"));
    }
    const json beaten = summary_of(first_table + " --seconds 0.1 --inputs " + (scratch / "a.csv"));
    CHECK(beaten["state_hash"] != summary_of(first_table + " --seconds 0.1")["state_hash"]);
}

TEST_CASE("no command writes over a file that it reads") {
    const Scratch scratch;
    const std::string text = "pinfield: 1\nscene:\n  - circle: {at: [0.1, 0.1]}\n", points = "x,y\n0,0\n";
    const std::string table = scratch.write("t.yaml", text), csv = scratch.write("p.csv", points),
                      same = scratch / "./t.yaml";
    for (const std::string& command :
         {"simulate " + table + " --seconds 0.01 --trace " + table,
          "simulate " + table + " --seconds 0.01 --events " + same, "render " + table + " -o " + table,
          "eval " + table + " --points " + csv + " -o " + table, "eval " + table + " --points " + csv + " -o " + csv}) {
        const Outcome outcome = run_pinfield(command);
        INFO(command << "\n" << outcome.err);
        CHECK(outcome.exit == 2);
        CHECK(slurp(table) == text);
        CHECK(slurp(csv) == points);
    }
    CHECK(run_pinfield("simulate " + table + " --seconds 0.01 --trace " + (scratch / "new.csv")).exit == 0);
    CHECK(run_pinfield("simulate " + table + " --seconds 0.01 --trace " + (scratch / "one") + " --events " + (scratch / "./one")).exit ==
          2);
}

TEST_CASE("simulate --step and --integrator overrule the table") {
    CHECK(summary_of(first_table + " --seconds 0.1 --step 0.0005")["ticks"] == 200);
    CHECK(summary_of(first_table + " --seconds 0.1 --step 2ms")["ticks"] == 50);
    const std::string run = first_table + " --seconds 0.1 --launch 0.2,0.4,0,0 --integrator ";
    CHECK(summary_of(run + "ballistic")["state_hash"] != summary_of(run + "symplectic_euler")["state_hash"]);
}

TEST_CASE("the summary for people says the same as the JSON") {
    const std::string run = first_table + " --seconds 0.1";
    const Outcome text = run_pinfield("simulate " + run);
    CHECK(text.exit == 0);
    CHECK_THAT(text.out, Catch::Contains(summary_of(run)["state_hash"].get<std::string>()));
}

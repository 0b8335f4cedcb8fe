// A table in several files, through every command that reads tables.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run.h"
#include "tests/places.h"

using namespace pinfield::cli_test;
namespace fs = std::filesystem;

namespace {

/// A table of some parts, as all commands would have it.
struct InFiles {
    Scratch scratch;
    std::string table;

    InFiles() {
        fs::create_directory(scratch / "parts");
        scratch.write("parts/board.yaml", "pinfield: 1\nparams: {gap: 3cm}\nmaterials: {wood: {restitution: 0.4}}\ninputs: {left: Z}\n"
                                          "templates: {post: {nodes: [circle: {id: pin, radius: gap / 3, material: wood}]}}\n"
                                          "scene: [domain: {children: [box: {size: [0.5, 1], at: [0.25, 0.5]}]}, use: {template: post, id: a, at: [0.2, 0.4]}]\n");
        table = scratch.write("table.yaml", "pinfield: 1\ninclude: [parts/board.yaml]\n"
                                            "scene:\n  - spawn: {id: ball, at: [0.2, 0.8]}\n  - bumper: {id: pop, at: [0.3, 0.3], radius: gap}\n"
                                            "tests: [{run: 5s, expect: [a.pin.hits >= 1, escaped == 0]}]\n");
    }
};

}  // namespace

TEST_CASE("a table in files does what its expansion in one file does") {
    const InFiles in;
    const Outcome expanded = run_pinfield("expand " + in.table);
    REQUIRE(expanded.exit == 0);
    CHECK_THAT(expanded.out, Catch::Contains("# parts/board.yaml\n") && Catch::Contains("# table.yaml\n") && !Catch::Contains("include"));
    fs::create_directory(in.scratch / "one");
    const std::string one = in.scratch.write("one/table.yaml", expanded.out), points = in.scratch.write("points.csv", "x,y\n0.2,0.45\n0.31,0.6\n");
    for (const std::string& table : {in.table, one}) {
        const Outcome checked = run_pinfield("check " + table);
        CHECK(checked.out.empty());
        CHECK(checked.exit == 0);
        CHECK(run_pinfield("test " + table).exit == 0);
    }
    const auto number = [](const std::string& json) { return nlohmann::json::parse(json).at("state_hash"); };
    const Outcome many_played = run_pinfield("simulate " + in.table + " --seconds 3 --json"), one_played = run_pinfield("simulate " + one + " --seconds 3 --json");
    REQUIRE(many_played.exit == 0);
    CHECK(number(many_played.out) == number(one_played.out));
    const Outcome many_points = run_pinfield("eval " + in.table + " --points " + points), one_points = run_pinfield("eval " + one + " --points " + points);
    REQUIRE(many_points.exit == 0);
    const auto with_plain_ids = [](std::string text) { return text.replace(text.find("a.pin"), 5, "a_pin"); };
    CHECK(with_plain_ids(many_points.out) == one_points.out);
    CHECK(run_pinfield("render " + in.table + " -o " + (in.scratch / "many.png")).exit == 0);
    CHECK(run_pinfield("render " + one + " -o " + (in.scratch / "one.png")).exit == 0);
    CHECK(slurp(in.scratch / "many.png") == slurp(in.scratch / "one.png"));
    CHECK(run_pinfield("upgrade " + in.table).exit == 0);
}

TEST_CASE("format says what is the table's own, and beside its files that is the table again") {
    const InFiles in;
    const Outcome formatted = run_pinfield("format " + in.table);
    REQUIRE(formatted.exit == 0);
    CHECK_THAT(formatted.out, Catch::Contains("include: [parts/board.yaml]\n") && !Catch::Contains("gap: ") && !Catch::Contains("domain"));
    const std::string again = in.scratch.write("again.yaml", formatted.out);
    CHECK(run_pinfield("format " + again).out == formatted.out);
    CHECK(run_pinfield("expand " + again).out.substr(0, 40) == run_pinfield("expand " + in.table).out.substr(0, 40));
}

TEST_CASE("check tells programs the way to a finding, too") {
    const InFiles in;
    in.scratch.write("parts/board.yaml", slurp(in.scratch / "parts/board.yaml") + "walls: []\n");
    const Outcome checked = run_pinfield("check --json " + in.table);
    CHECK(checked.exit == 1);
    const auto findings = nlohmann::json::parse(checked.out);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].at("file") == in.scratch / "parts/board.yaml");
    REQUIRE(findings[0].at("way").size() == 1);
    const auto& step = findings[0].at("way")[0];
    CHECK(step.at("in") == "the file parts/board.yaml");
    CHECK(step.at("how") == "included");
    CHECK(step.at("file") == in.table);
    CHECK(step.at("line") == 2);
    CHECK(step.at("column") == 11);
}

TEST_CASE("no output takes the place of a file that the table includes") {
    const InFiles in;
    const std::string part = in.scratch / "parts/board.yaml", before = slurp(part);
    CHECK(run_pinfield("render " + in.table + " -o " + part).exit == 2);
    CHECK(run_pinfield("simulate " + in.table + " --seconds 1 --trace " + part).exit == 2);
    CHECK(slurp(part) == before);
}

TEST_CASE("the files of the language's document are a table") {
    const std::string text = slurp(fs::path(pinfield::test::source_dir()) / "docs/table-language.md");
    const Scratch scratch;
    fs::create_directory(scratch / "parts");
    for (const std::string name : {"table.yaml", "parts/walls.yaml"}) {
        const std::string begin = "```yaml\n# " + name + "\n";
        const std::size_t at = text.find(begin);
        REQUIRE(at != text.npos);
        scratch.write(name, text.substr(at + 8, text.find("```", at + 8) - at - 8));
    }
    const Outcome checked = run_pinfield("check " + (scratch / "table.yaml"));
    CHECK(checked.out.empty());
    CHECK(checked.exit == 0);
    CHECK_THAT(run_pinfield("expand " + (scratch / "table.yaml")).out, Catch::Contains("id: left_wall") && Catch::Contains("id: pop"));
}

#include <algorithm>
#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/cli/run.h"
#include "tests/places.h"

using namespace pinfield::cli_test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> yaml_files(const std::string& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(fs::path(pinfield::test::source_dir()) / folder))
        if (entry.path().extension() == ".yaml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

TEST_CASE("check is silent about what is right and exits 0") {
    for (const char* folder : {"scenes/tables", "scenes/nodes"}) {
        for (const fs::path& file : yaml_files(folder)) {
            INFO(file);
            const Outcome outcome = run_pinfield("check " + file.string());
            CHECK(outcome.exit == 0);
            CHECK_THAT(outcome.out, !Catch::Contains("error"));
        }
    }
}

TEST_CASE("check says of every wrong table what and where, on stdout, with the source line and a caret, and exits 1 for errors") {
    const std::vector<fs::path> files = yaml_files("scenes/invalid");
    CHECK(files.size() >= 120);
    const std::regex promise(R"(# expect ([EW]\d{4}) (?:(\S+):)?(\d+):(\d+).*)");
    for (const fs::path& file : files) {
        INFO(file);
        std::smatch expected;
        const std::string first = lines_of(slurp(file)).at(0);
        REQUIRE(std::regex_match(first, expected, promise));
        const std::string code = expected[1], place = fmt::format(":{}:{}: ", expected[3].str(), expected[4].str());
        const fs::path there = expected[2].matched ? file.parent_path() / expected[2].str() : file;
        const bool is_error = code[0] == 'E';

        const Outcome outcome = run_pinfield("check " + file.string());
        CHECK(outcome.exit == (is_error ? 1 : 0));
        CHECK(outcome.err.empty());
        CHECK_THAT(outcome.out, Catch::Contains(there.string() + place + (is_error ? "error: " : "warning: ")));
        CHECK_THAT(outcome.out, Catch::Contains("[" + code + "]"));
        CHECK_THAT(outcome.out, Catch::Contains("^\n"));
    }
}

TEST_CASE("check warns with its place of a rounding of what is only a bound, and exits 0") {
    const Scratch scratch;
    const std::string wedge = scratch.write("wedge.yaml",
                                            "pinfield: 1\nscene:\n  - round: {radius: 5mm, children: [intersection: {id: wedge, children: "
                                            "[half_plane: {}, half_plane: {turn: 90}]}]}\n");
    const Outcome outcome = run_pinfield("check " + wedge);
    CHECK(outcome.exit == 0);
    CHECK_THAT(outcome.out, Catch::Contains("wedge.yaml:3:5: warning: round ") && Catch::Contains("wedge is not the true one") &&
                                Catch::Contains("[W0503]") && Catch::Contains("hint: "));
    CHECK_THAT(run_pinfield("eval " + wedge + " --points " + scratch.write("p.csv", "x,y\n0.1,0.1\n")).err, Catch::Contains("[W0503]"));
}

TEST_CASE("check --verbose says of each node how far its distance may be trusted, as text and as JSON") {
    const Scratch scratch;
    const std::string table = scratch.write("t.yaml",
                                            "pinfield: 1\nscene:\n"
                                            "  - union:\n      id: both\n      children:\n"
                                            "        - circle: {id: disc, radius: 20mm, at: [0.1, 0.1]}\n"
                                            "        - smooth_union: {id: goo, children: [half_plane: {id: floor}, ellipse: {id: egg}]}\n"
                                            "  - box: {id: crate, at: [0.3, 0.5]}\n");
    CHECK(run_pinfield("check " + table).out.empty());
    CHECK(json::parse(run_pinfield("check --json " + table).out).empty());

    const Outcome outcome = run_pinfield("check --verbose " + table);
    CHECK(outcome.exit == 0);
    const std::string at = table + ":";
    CHECK(lines_of(outcome.out) == std::vector<std::string>{
        at + "3:5: note: both is bound outside, bound inside, L = 1",
        at + "6:11: note:   disc is exact outside, exact inside, L = 1",
        at + "7:11: note:   goo is bound outside, bound inside, L = 1",
        at + "7:46: note:     floor is exact outside, exact inside, L = 1",
        at + "7:71: note:     egg is exact outside, exact inside, L = 1",
        at + "8:5: note: crate is exact outside, exact inside, L = 1, its boundary is known: exact on both sides"});

    const json notes = json::parse(run_pinfield("check --verbose --json " + table).out);
    REQUIRE(notes.size() == 6);
    CHECK(notes[0]["severity"] == "note");
    CHECK(notes[0]["line"] == 3);
    CHECK(notes[0]["node"] == "both");
    CHECK(notes[0]["outside"] == "bound");
    CHECK(notes[0]["boundary_known"] == false);
    CHECK(notes[5]["inside"] == "exact");
    CHECK(notes[5]["lipschitz"] == 1);
    CHECK(notes[5]["boundary_known"] == true);
}

TEST_CASE("check --verbose names each side by itself, and a boundary that is fitted apart from one that is known") {
    const Scratch scratch;
    const std::string table = scratch.write("t.yaml",
                                            "pinfield: 1\nscene:\n"
                                            "  - smooth_union:\n      id: goo\n      k: 5mm\n      children:\n"
                                            "        - circle: {id: left, radius: 50mm, at: [0.1, 0.1]}\n"
                                            "        - circle: {id: right, radius: 50mm, at: [0.2, 0.1]}\n"
                                            "  - round: {id: soft, radius: 5mm, children: [box: {id: hard, at: [0.3, 0.5]}]}\n");
    const std::vector<std::string> lines = lines_of(run_pinfield("check --verbose " + table).out);
    REQUIRE(lines.size() == 5);
    // The two discs' box is 200 mm by 100 mm and grows by k all round; a ten millionth of its length is 21 nm.
    CHECK_THAT(lines[0],
               Catch::EndsWith("goo is bound outside, bound inside, L = 1, its boundary is fitted: right on both sides within 2e-08 m"));
    CHECK_THAT(lines[3], Catch::EndsWith("soft is exact outside, bound inside, L = 1, its boundary is known: exact on both sides"));

    const json notes = json::parse(run_pinfield("check --verbose --json " + table).out);
    REQUIRE(notes.size() == 5);
    CHECK(notes[0]["boundary_known"] == true);
    CHECK(notes[0]["boundary_fitted"] == true);
    CHECK(notes[0]["fit_error"].get<double>() == Approx(0.21e-7).epsilon(1e-9));
    CHECK(notes[3]["outside"] == "exact");
    CHECK(notes[3]["inside"] == "bound");
    CHECK(notes[3]["boundary_fitted"] == false);
    CHECK(notes[3]["fit_error"] == 0);
}

TEST_CASE("check takes several files, tells all diagnostics of all of them, and an unreadable one is exit 3") {
    const Scratch scratch;
    const std::string wrong = scratch.write("two.yaml", "pinfield: 1\nscene:\n  - circle: {radius: -1}\n  - bxo: {size: [1, 1]}\n");
    const Outcome both = run_pinfield("check " + first_table + " " + wrong);
    CHECK(both.exit == 1);
    CHECK_THAT(both.out, Catch::Contains("two.yaml:3:") && Catch::Contains("two.yaml:4:") && Catch::Contains("box"));
    const Outcome missing = run_pinfield("check " + wrong + " no/such.yaml");
    CHECK(missing.exit == 3);
    CHECK_THAT(missing.out, Catch::Contains("two.yaml:3:"));
    CHECK_THAT(missing.err, Catch::Contains("no/such.yaml"));
}

TEST_CASE("nodes lists every node, as JSON with the members it should have") {
    const Outcome all = run_pinfield("nodes --json");
    REQUIRE(all.exit == 0);
    const json nodes = json::parse(all.out);
    REQUIRE(nodes.is_array());
    std::vector<std::string> keys;
    for (const json& node : nodes) {
        INFO(node.dump());
        for (const char* key : {"key", "kind", "doc", "exactness", "fields", "children"}) CHECK(node.contains(key));
        for (const char* key : {"outside", "inside", "lipschitz"}) CHECK(node["exactness"].contains(key));
        CHECK(node["children"].contains("min"));
        CHECK(node["children"].contains("max"));
        for (const json& field : node["fields"])
            for (const char* key : {"key", "type", "unit", "default", "min", "min_open", "doc"}) CHECK(field.contains(key));
        keys.push_back(node["key"]);
    }
    for (const char* key :
         {"circle",     "box",          "segment",           "capsule", "uneven_capsule", "half_plane",   "triangle",     "polygon",
          "arc",        "ellipse",      "regular_polygon",   "star",    "union",          "intersection", "difference",   "xor",
          "complement", "smooth_union", "smooth_difference", "round",   "onion",          "mirror",       "repeat_polar", "domain",
          "flipper",    "bumper",       "plunger",           "drain",   "spawn"})
        CHECK(std::count(keys.begin(), keys.end(), key) == 1);
    const json circle = json::parse(run_pinfield("nodes circle --json").out);
    REQUIRE(circle.is_array());
    REQUIRE(circle.size() == 1);
    CHECK(circle[0]["key"] == "circle");
    CHECK(circle[0]["fields"][0]["key"] == "radius");
    CHECK(circle[0]["fields"][0]["unit"] == "m");
    CHECK_THAT(run_pinfield("nodes").out, Catch::Contains("circle") && Catch::Contains("radius"));
    CHECK_THAT(run_pinfield("nodes --markdown").out, Catch::Contains("# ") && Catch::Contains("circle"));
}

TEST_CASE("the schema is JSON Schema draft-07") {
    const Outcome outcome = run_pinfield("schema");
    REQUIRE(outcome.exit == 0);
    CHECK_THAT(json::parse(outcome.out)["$schema"].get<std::string>(), Catch::Contains("draft-07"));
}

TEST_CASE("render writes a PNG of the size asked for") {
    const Scratch scratch;
    for (const char* mode : {"shaded", "isolines"}) {
        const std::string path = scratch / mode;
        const Outcome outcome = run_pinfield("render " + first_table + " -o " + path + " --size 120x240 --mode " + mode);
        INFO(outcome.err);
        REQUIRE(outcome.exit == 0);
        const std::string png = slurp(path);
        REQUIRE(png.size() > 1000);
        CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
        const auto big_endian = [&](std::size_t at) {
            unsigned value = 0;
            for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(png[i]);
            return value;
        };
        CHECK(big_endian(16) == 120);
        CHECK(big_endian(20) == 240);
    }
    CHECK(slurp(scratch / "shaded") != slurp(scratch / "isolines"));
}

TEST_CASE("format prints the canonical form, which is its own canonical form, and leaves the file alone") {
    const Scratch scratch;
    const std::string before = slurp(fs::path(pinfield::test::source_dir()) / first_table);
    const Outcome once = run_pinfield("format " + first_table);
    REQUIRE(once.exit == 0);
    CHECK(slurp(fs::path(pinfield::test::source_dir()) / first_table) == before);
    const Outcome twice = run_pinfield("format " + scratch.write("once.yaml", once.out));
    CHECK(twice.exit == 0);
    CHECK(twice.out == once.out);
    // Nothing of the game was lost on the way.
    const std::string run = " --seconds 2 --inputs scenes/tables/first_table.inputs.csv --json";
    const json original = json::parse(run_pinfield("simulate " + first_table + run).out);
    const json formatted = json::parse(run_pinfield("simulate " + (scratch / "once.yaml") + run).out);
    CHECK(original["state_hash"] == formatted["state_hash"]);
}

TEST_CASE("test runs a table's own tests and exits 1 when one fails") {
    std::vector<fs::path> tables = yaml_files("scenes/tables");
    tables.emplace_back("tests/program/moonrise_once.yaml");
    for (const fs::path& table : tables) {
        const Outcome fine = run_pinfield("test " + table.string());
        INFO(fine.out << fine.err);
        CHECK(fine.exit == 0);
    }
    const Scratch scratch;
    const std::string table = scratch.write(
        "t.yaml",
        "pinfield: 1\nscene:\n  - bumper: {id: pop, at: [0.26, 0.5]}\n"
        "tests:\n  - {name: right, launch: {at: [0.26, 0.8], velocity: [0, -1]}, run: 1s, expect: [pop.hits >= 1, escaped == 0]}\n"
        "  - {name: wrong, launch: {at: [0.1, 0.8], velocity: [0, 0]}, run: 0.1s, expect: [pop.hits >= 1]}\n");
    const Outcome half = run_pinfield("test " + table);
    CHECK(half.exit == 1);
    CHECK_THAT(half.out, Catch::Contains("right") && Catch::Contains("wrong") && Catch::Contains("pop.hits >= 1"));
    const json results = json::parse(run_pinfield("test " + table + " --json").out);
    REQUIRE(results.is_object());
    CHECK(results["passed"] == 1);
    CHECK(results["failed"] == 1);
}

TEST_CASE("the reference tells units and events, each kind that a run of the first table writes among them") {
    const std::string reference = run_pinfield("nodes").out;
    CHECK_THAT(reference, Catch::Contains("um, mm, cm, m, in, ft"));
    const Scratch scratch;
    const std::string log = scratch / "events.jsonl";
    REQUIRE(run_pinfield("simulate " + first_table + " --seconds 5 --inputs scenes/tables/first_table.inputs.csv --events " + log).exit == 0);
    for (const std::string& line : lines_of(slurp(log))) CHECK(reference.find("    " + json::parse(line)["kind"].get<std::string>() + " ") != std::string::npos);
}

TEST_CASE("render --parts changes the picture where spawns, drains and swings are, and nowhere else") {
    const Scratch scratch;
    const std::string table = "pinfield: 1\ntable: {size: [0.2, 0.4]}\nscene:\n";
    const auto picture = [&](const std::string& nodes, const std::string& more) {
        const std::string png = scratch / "p.png";
        REQUIRE(run_pinfield("render " + scratch.write("t.yaml", table + nodes) + " -o " + png + more).exit == 0);
        return slurp(png);
    };
    CHECK(picture("  - box: {at: [0.1, 0.1]}\n", "") == picture("  - box: {at: [0.1, 0.1]}\n", " --parts"));
    for (const std::string node : {"  - spawn: {at: [0.1, 0.3]}\n", "  - drain: {at: [0.1, 0.1]}\n", "  - flipper: {at: [0.1, 0.2]}\n"})
        CHECK(picture(node, "") != picture(node, " --parts"));
}

TEST_CASE("check --pockets warns of the two places in the gallery where balls were found to lie") {
    const Outcome found = run_pinfield("check --pockets scenes/tables/gallery.yaml");
    CHECK(found.exit == 0);
    CHECK_THAT(found.out, Catch::Contains("[0.562, 0.961]") && Catch::Contains("[0.217, 0.610]") && Catch::Contains("W0510"));
    CHECK(run_pinfield("check scenes/tables/gallery.yaml").out.empty());
}

TEST_CASE("a launch that is no launch, or cannot start, is told in its own words") {
    CHECK_THAT(run_pinfield("simulate " + first_table + " --launch 1,2,3,4,5").err, Catch::Contains("has 5 numbers; a launch has four: x,y,vx,vy"));
    const Outcome outside = run_pinfield("simulate " + first_table + " --launch 3,3,0,0");
    CHECK(outside.exit == 1);
    CHECK_THAT(outside.err, Catch::Contains("outside of cabinet") && Catch::Contains("with room for a ball"));
    const Scratch scratch;
    const std::string run = "simulate " + scratch.write("t.yaml", "pinfield: 1\nscene: []\n") + " --inputs " + scratch.write("i.csv", "tick,input,value\n1,x,1\n");
    CHECK_THAT(run_pinfield(run).err, Catch::Contains("no input \"x\"; it has none"));
}

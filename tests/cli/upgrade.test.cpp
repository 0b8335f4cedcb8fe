#include <catch2/catch.hpp>

#include "tests/cli/run.h"

using namespace pinfield::cli_test;

TEST_CASE("a table of the newest version needs no upgrade, whatever else is wrong with it, and stays as it is") {
    const Scratch scratch;
    for (const char* body : {"scene: [circle: {}]\n", "scene: [circel: {}]\n", "", "# a comment\nscene:   [ ]\n"}) {
        const std::string text = std::string("pinfield: 1\n") + body, table = scratch.write("t.yaml", text);
        const Outcome outcome = run_pinfield("upgrade " + table);
        CHECK(outcome.exit == 0);
        CHECK(outcome.err.empty());
        CHECK_THAT(outcome.out, Catch::Contains("t.yaml is written for version 1 of the format, the newest: nothing is to be done\n"));
        CHECK(slurp(table) == text);
    }
    CHECK(run_pinfield("upgrade " + first_table).exit == 0);
}

TEST_CASE("a table of a later version, of none, or that is no YAML is refused with its place") {
    const Scratch scratch;
    for (const auto& [text, found] : {std::pair{"pinfield: 2\nscene: [circle: {}]\n", "t.yaml:1:11: error: version 2 of the format is not known [E0205]"},
                                      {"scene: []\npinfield: one\n", "t.yaml:2:11: error: version one of the format is not known [E0205]"},
                                      {"scene: [circle: {}]\n", "t.yaml:1:1: error: the file does not say its version [E0204]"},
                                      {"pinfield: 1\nscene: [circle: {}\n", "[E0105]"},
                                      {"", "[E0101]"},
                                      {"- pinfield: 1\n", "[E0201]"}}) {
        const std::string table = scratch.write("t.yaml", text);
        const Outcome outcome = run_pinfield("upgrade " + table);
        INFO(text << outcome.err);
        CHECK(outcome.exit == 1);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, Catch::Contains(found));
        CHECK(slurp(table) == text);
    }
    CHECK_THAT(run_pinfield("upgrade " + scratch.write("t.yaml", "pinfield: 2\n")).err, Catch::Contains("needs a later program"));
}

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "engine/core/error_codes.h"
#include "tests/cli/run.h"

using namespace pinfield::cli_test;
using nlohmann::json;

TEST_CASE("explain without a code lists all of them, a line each, sorted") {
    const Outcome outcome = run_pinfield("explain");
    CHECK(outcome.exit == 0);
    const std::vector<std::string> lines = lines_of(outcome.out);
    CHECK(lines.size() == pinfield::error_codes().size());
    CHECK(std::is_sorted(lines.begin(), lines.end()));
    for (const pinfield::ErrorCode& code : pinfield::error_codes())
        CHECK_THAT(outcome.out, Catch::Contains(std::string(code.code) + " " + std::string(code.name)) && Catch::Contains(std::string(code.meaning)));
}

TEST_CASE("explain tells of every code, however it is written, within 80 columns and without a control character") {
    for (const pinfield::ErrorCode& code : pinfield::error_codes()) {
        const Outcome outcome = run_pinfield("explain " + std::string(code.code));
        INFO(outcome.out);
        CHECK(outcome.exit == 0);
        CHECK(outcome.err.empty());
        CHECK_THAT(outcome.out, Catch::StartsWith(std::string(code.code) + " " + std::string(code.name) + ": "));
        const std::string prose = outcome.out.substr(0, outcome.out.find("\nwrong:\n"));
        for (const std::string& line : lines_of(prose)) CHECK(line.size() <= 120);
        CHECK(std::none_of(outcome.out.begin(), outcome.out.end(), [](char c) { return c < ' ' && c != '\n' && c != '\t'; }));
    }
    const std::string text = run_pinfield("explain E0203").out;
    CHECK_THAT(text, Catch::Contains("\nwrong:\n\n    - circel: {radius: 3cm}\n") && Catch::Contains("\nright:\n\n    - circle: {radius: 3cm}\n"));
    for (const char* word : {"e0203", "'[E0203]'", "unknown_node"}) CHECK(run_pinfield(std::string("explain ") + word).out == text);
}

TEST_CASE("an unknown code is asked back") {
    CHECK_THAT(run_pinfield("explain E02003").err, Catch::Contains("there is no code \"E02003\"; did you mean E0203?"));
    CHECK_THAT(run_pinfield("explain unknown_nod").err, Catch::Contains("did you mean unknown_node?"));
    CHECK_THAT(run_pinfield("explain W9999").err, Catch::Contains("`pinfield explain` lists all"));
    CHECK(run_pinfield("explain \"\"").exit == 0);
}

TEST_CASE("explain prints JSON for programs") {
    const json all = json::parse(run_pinfield("explain --json").out);
    CHECK(all.size() == pinfield::error_codes().size());
    const json one = json::parse(run_pinfield("explain --json W0507").out);
    REQUIRE(one.size() == 1);
    CHECK(one[0]["severity"] == "warning");
    CHECK(one[0]["wrong"].get<std::string>().starts_with("- domain:"));
}

TEST_CASE("check says once a run where to read more, of the first error before any warning") {
    const Outcome one = run_pinfield("check scenes/invalid/no_scene.yaml scenes/invalid/unknown_node.yaml scenes/invalid/tag.yaml");
    const std::vector<std::string> lines = lines_of(one.out);
    CHECK(lines.back() == "`pinfield explain E0203` tells more, with an example of wrong and of right.");
    CHECK(std::count_if(lines.begin(), lines.end(), [](const std::string& line) { return line.find("pinfield explain") != line.npos; }) == 1);
    CHECK_THAT(run_pinfield("check scenes/invalid/no_scene.yaml").out, Catch::Contains("`pinfield explain W0501`"));
    CHECK(run_pinfield("check " + first_table).out.empty());
    CHECK_THAT(run_pinfield("check --json scenes/invalid/tag.yaml").out, !Catch::Contains("pinfield explain"));
}

#include "engine/io/script_reader.h"

#include <catch2/catch.hpp>

using namespace pinfield;

namespace {

std::string first_code(const std::string& text) {
    const Script script = read_script(SourceText("s.yaml", text));
    return script.diagnostics.empty() ? "" : script.diagnostics.front().code;
}

}  // namespace

TEST_CASE("an empty script has no steps, not no table") {
    const Script script = read_script(SourceText("s.yaml", "# nothing\n"));
    REQUIRE(script.diagnostics.size() == 1);
    CHECK(script.diagnostics[0].message == "the file holds no steps");
}

TEST_CASE("every kind of step reads") {
    const SourceText source("s.yaml",
                            "- {action: file.save}\n"
                            "- {set: {node: pop, field: radius, value: 30mm}}\n"
                            "- {drag: {from: [0.1, 20cm], to: [0.3, 0.4]}}\n"
                            "- {key: {press: Z, ticks: 100}}\n"
                            "- {wait: {ticks: 500}}\n"
                            "- {select: pop}\n"
                            "- {screenshot: out.png}\n"
                            "- {expect: {node: pop, field: at, value: [0.3, 40cm], tolerance: 1mm}}\n");
    const Script script = read_script(source);
    REQUIRE(script.diagnostics.empty());
    REQUIRE(script.steps.size() == 8);
    using Kind = ScriptStep::Kind;
    CHECK(script.steps[0].kind == Kind::action);
    CHECK(script.steps[0].name == "file.save");
    CHECK(script.steps[1].value == "30mm");
    CHECK(script.steps[1].field == "radius");
    CHECK(script.steps[2].from == Vec2(0.1, 0.2));
    CHECK(script.steps[3].name == "Z");
    CHECK(script.steps[3].ticks == 100);
    CHECK(script.steps[4].ticks == 500);
    CHECK(script.steps[5].name == "pop");
    CHECK(script.steps[6].name == "out.png");
    CHECK(script.steps[7].value == "[0.3, 40cm]");
    CHECK(script.steps[7].tolerance == "1mm");
    CHECK(source.line_column(script.steps[7].where.span.begin) == LineColumn{8, 4});
}

TEST_CASE("a script is read as strictly as a table") {
    CHECK(first_code("- {clik: pop}\n") == "E0601");
    CHECK(first_code("- {wait: {tics: 5}}\n") == "E0202");
    CHECK(first_code("- {set: {node: pop, field: radius}}\n") == "E0207");
    CHECK(first_code("- {wait: {ticks: 1.5}}\n") == "E0206");
    CHECK(first_code("- {wait: {ticks: -1}}\n") == "E0208");
    CHECK(first_code("- {wait: 5}\n") == "E0201");
    CHECK(first_code("- {action: }\n") == "E0216");
    CHECK(first_code("- {action: a, select: b}\n") == "E0218");
    CHECK(first_code("wait: {ticks: 5}\n") == "E0201");
    CHECK(first_code("") == "E0101");
}

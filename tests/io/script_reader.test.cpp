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
                            "- {expect: {node: pop, field: at, value: [0.3, 40cm], tolerance: 1mm}}\n"
                            "- {click: {at: [0.1, 0.2], times: 2, with: [LeftShift], button: right}}\n"
                            "- {click: {on: Add to table}}\n"
                            "- {drag: {from: {palette: star}, to: [0.1, 0.1], button: middle}}\n"
                            "- {scroll: {at: [0.1, 0.1], by: -2.5}}\n"
                            "- {type: 30mm + 4}\n"
                            "- {insert: {yaml: 'star: {id: s}', parent: pop, index: 2}}\n"
                            "- {paste: 'star: {}'}\n"
                            "- {remove: [a, b]}\n"
                            "- {move: {node: a, parent: g, index: 0}}\n"
                            "- {wrap: {nodes: [a, b], in: union}}\n"
                            "- {unwrap: g}\n"
                            "- {rename: {node: a, id: b}}\n");
    const Script script = read_script(source);
    REQUIRE(script.diagnostics.empty());
    REQUIRE(script.steps.size() == 20);
    using Kind = ScriptStep::Kind;
    CHECK(script.steps[0].kind == Kind::action);
    CHECK(script.steps[0].name == "file.save");
    CHECK(script.steps[1].value == "30mm");
    CHECK(script.steps[1].field == "radius");
    CHECK(script.steps[2].from.place == Vec2(0.1, 0.2));
    CHECK(script.steps[3].name == "Z");
    CHECK(script.steps[3].ticks == 100);
    CHECK(script.steps[4].ticks == 500);
    CHECK(script.steps[5].nodes == std::vector<std::string>{"pop"});
    CHECK(script.steps[6].name == "out.png");
    CHECK(script.steps[7].value == "[0.3, 40cm]");
    CHECK(script.steps[7].tolerance == "1mm");
    CHECK(source.line_column(script.steps[7].where.span.begin) == LineColumn{8, 4});
    using Names = std::vector<std::string>;
    CHECK(script.steps[8].times == 2);
    CHECK(script.steps[8].with == Names{"LeftShift"});
    CHECK(script.steps[8].button == "right");
    CHECK(script.steps[9].from.words == "Add to table");
    CHECK_FALSE(script.steps[9].from.place);
    CHECK(script.steps[10].from.words == "star");
    CHECK(script.steps[10].from.panel == "palette");
    CHECK(script.steps[10].to.place == Vec2(0.1, 0.1));
    CHECK(script.steps[11].by == -2.5);
    CHECK(script.steps[12].value == "30mm + 4");
    CHECK(script.steps[13].value == "star: {id: s}");
    CHECK(script.steps[13].parent == "pop");
    CHECK(script.steps[13].index == 2);
    CHECK(script.steps[14].kind == Kind::paste);
    CHECK(script.steps[15].nodes == Names{"a", "b"});
    CHECK(script.steps[16].index == 0);
    CHECK(script.steps[17].name == "union");
    CHECK(script.steps[18].nodes == Names{"g"});
    CHECK(script.steps[19].name == "b");
    for (const ScriptStep& step : script.steps) CHECK(source.slice(step.where.span).starts_with(word_of(step.kind)));
}

TEST_CASE("a script is read as strictly as a table") {
    CHECK(first_code("- {clik: pop}\n") == "E0601");
    CHECK(first_code("- {wait: {tics: 5}}\n") == "E0202");
    CHECK(first_code("- {set: {node: pop, field: radius}}\n") == "E0207");
    CHECK(first_code("- {wait: {ticks: 1.5}}\n") == "E0206");
    CHECK(first_code("- {wait: {ticks: -1}}\n") == "E0208");
    CHECK(first_code("- {wait: 5}\n") == "E0201");
    CHECK(first_code("- {click: {times: 2}}\n") == "E0207");
    CHECK(first_code("- {click: {at: here}}\n") == "E0201");
    CHECK(first_code("- {click: {at: [1, 1], button: wheel}}\n") == "E0201");
    CHECK(first_code("- {remove: {a: b}}\n") == "E0201");
    CHECK(first_code("- {action: }\n") == "E0216");
    CHECK(first_code("- {action: a, select: b}\n") == "E0218");
    CHECK(first_code("wait: {ticks: 5}\n") == "E0201");
    CHECK(first_code("") == "E0101");
}

// A table and the files it includes: edited beside them, and read again when one of them changes.
#include <catch2/catch.hpp>

#include "editor/app_state.h"
#include "engine/core/at.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

const std::string table = R"(pinfield: 1
include: [parts.yaml]
scene:
  - use: {template: gear, id: large, at: [0.2, 0.6], with: {r: 3cm}}
  - circle: {id: dot, at: [0.1, 0.3], radius: bloom * 0.5}
)";
const std::string parts = R"(pinfield: 1
params: {bloom: 34mm}
templates:
  gear:
    args: {r: 40mm}
    nodes: [circle: {id: wheel, radius: r, material: brass}]
materials: {brass: {restitution: 0.5}}
scene:
  - circle: {id: theirs, at: [0.4, 0.8], radius: 2cm}
)";

AppState state_of(const Folder& folder) {
    folder.write("table.yaml", table);
    folder.write("parts.yaml", parts);
    return {catalog(), *Document::open(folder.file("table.yaml"), catalog())};
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("what stands in another file is shown and refused with its place, what stands here is changed here, and both files stay whole") {
    const Folder folder;
    AppState state = state_of(folder);
    REQUIRE(state.document.diagnostics().empty());
    CHECK(state.document.scene().find("dot")->get<double>("radius") == 0.017);
    const auto why = state.document.edit(change(state.document, "theirs", "radius", 0.03), "Change");
    REQUIRE(why);
    CHECK_THAT(*why, Catch::Contains("parts.yaml:9"));
    advance(state, 0);
    CHECK_FALSE(state.home);

    CHECK(state.document.edit(change(state.document, "large.wheel", "radius", 0.02), "Change"));
    advance(state, 0);
    REQUIRE(state.home);
    std::vector<std::string> told;
    for (const ValueHome& home : state.home->homes) told.push_back(home.told);
    CHECK(told == std::vector<std::string>{"r of this large", "here only: large is written out"});
    run(state, "home.1");
    CHECK(state.document.source().text() == with(table, "r: 3cm", "r: 2cm"));
    CHECK(state.document.edit(change(state.document, "dot", "radius", 0.02), "Change"));
    advance(state, 0);
    REQUIRE(state.home);
    CHECK(state.home->homes.size() == 1);  // the param is not this file's
    run(state, "home.cancel");
    REQUIRE(state.document.save());
    CHECK(folder.read("parts.yaml") == parts);
}

TEST_CASE("when an included file changes the table follows, without a step, and undo goes on working") {
    const Folder folder;
    AppState state = state_of(folder);
    Document& document = state.document;
    CHECK_FALSE(document.edit(change(document, "dot", "at", Vec2(0.12, 0.3)), "Move"));
    CHECK(document.check_disk() == DiskState::same);
    folder.write("parts.yaml", with(parts, "bloom: 34mm", "bloom: 40mm"));
    CHECK(document.check_disk() == DiskState::reloaded);
    CHECK(document.scene().find("dot")->get<double>("radius") == 0.02);
    CHECK(document.steps() == 1);
    advance(state, 3);
    folder.write("parts.yaml", parts + "  - box: {id: more}\n");
    CHECK(document.check_disk() == DiskState::reloaded);
    CHECK(document.scene().find("more"));
    document.undo();
    CHECK(document.source().text() == table);
    CHECK(document.scene().find("more"));
    advance(state, 3);
    folder.write("parts.yaml", "pinfield: 1\nscene: [circle: {radius: -1}]\n");
    CHECK(document.check_disk() == DiskState::broken);
    CHECK_FALSE(document.diagnostics().empty());
    CHECK(document.scene().find("more"));  // the last that could be used goes on
    folder.write("parts.yaml", parts);
    CHECK(document.check_disk() == DiskState::reloaded);
    CHECK(document.diagnostics().empty());
}

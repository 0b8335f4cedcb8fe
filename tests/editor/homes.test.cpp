// What templates, copies and expressions give is changed where it comes from: the editor asks where, once.
#include <catch2/catch.hpp>

#include "editor/edit_tools.h"
#include "editor/scrub.h"
#include "engine/core/at.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

const std::string table = R"(pinfield: 1
params: {bloom: {value: 34mm, min: 20mm, max: 40mm}}
templates:
  gear:
    args: {r: 40mm}
    nodes:
      - circle: {id: wheel, radius: r}   # the disc
      - box: {id: tooth, size: [5mm, 10mm], at: [0, 60mm]}
scene:
  - use: {template: gear, id: large, at: [0.2, 0.6]}   # alone
  - use: {template: gear, id: small, at: [0.4, 0.6], with: {r: 2cm}}
  - circle: {id: dot, at: [0.1, 0.3], radius: bloom * 0.5}
  - circle: {id: post, at: [0.1, 0.8], radius: 5mm, copies: {count: 3, step: [5cm, 0]}}
)";

AppState state_of(const Folder& folder) {
    folder.write("table.yaml", table);
    return {catalog(), *Document::open(folder.file("table.yaml"), catalog())};
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    INFO(from);
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
}

std::string text_of(const AppState& state) { return state.document.source().text(); }

}  // namespace

TEST_CASE("an edit of what a template made is asked about, and goes where the answer says; the next one goes there by itself") {
    const Folder folder;
    AppState state = state_of(folder);
    CHECK(edit(state, change(state.document, "large.tooth", "size", Vec2(0.006, 0.01)), "Change") == false);
    advance(state, 0);
    REQUIRE(state.home);
    CHECK(asks(state));
    REQUIRE(state.home->homes.size() == 2);
    CHECK(state.home->homes[0].told == "in the template gear");
    CHECK(state.home->homes[0].values == 2);
    CHECK_FALSE(enabled(state, "edit.undo"));
    CHECK_FALSE(enabled(state, "home.3"));
    run(state, "home.1");
    CHECK_FALSE(state.home);
    CHECK(text_of(state) == with(table, "[5mm, 10mm]", "[6mm, 10mm]"));
    CHECK(edit(state, change(state.document, "small.tooth", "turn", 5.0), "Turn"));
    CHECK(text_of(state) == with(with(table, "[5mm, 10mm]", "[6mm, 10mm]"), "at: [0, 60mm]", "at: [0, 60mm], turn: 5"));
    for (int i = 0; i < 2; ++i) run(state, "edit.undo");
    CHECK(text_of(state) == table);
    run(state, "edit.ask_homes");
    CHECK_FALSE(enabled(state, "edit.ask_homes"));
    CHECK_FALSE(edit(state, change(state.document, "small.tooth", "turn", 5.0), "Turn"));
    advance(state, 0);
    REQUIRE(state.home);
    run(state, "home.cancel");
    CHECK(text_of(state) == table);
}

TEST_CASE("once it is known that a param is meant, a drag moves the param, and the running table follows every motion") {
    const Folder folder;
    AppState state = state_of(folder);
    CHECK_FALSE(edit(state, change(state.document, "dot", "radius", 0.018), "Change"));
    advance(state, 0);
    REQUIRE(state.home);
    run(state, "home.1");
    CHECK(text_of(state) == with(table, "34mm", "36mm"));
    state.document.take_changes();
    const NodeId dot = id_of(state.document, "dot");
    const int radius = *state.document.scene().find(dot)->type->find_field("radius");
    Scrub scrub;
    REQUIRE(scrub.begin(state.document, SharedField{{dot, radius}}, 0));
    for (const double pixels : {1.0, 2.0, 500.0, 1.0}) {
        scrub.update(state.document, pixels);
        advance(state, 1);
        CHECK_FALSE(state.home);
        CHECK(state.document.previewing());
        CHECK(text_of(state) == with(table, "34mm", "36mm"));
    }
    CHECK_FALSE(scrub.end(state.document));
    CHECK(text_of(state) == with(table, "34mm", "38mm"));
    CHECK(state.document.steps() == 2);
    run(state, "edit.undo");
    run(state, "edit.undo");
    CHECK(text_of(state) == table);
}

TEST_CASE("a copy is dragged, and its row goes with it") {
    const Folder folder;
    AppState state = state_of(folder);
    const Vec2 hand(0.15, 0.8);
    NodeDrag drag;
    REQUIRE(drag.begin(state.document, id_of(state.document, "post.2"), hand));
    CHECK(drag.update(state.document, hand + Vec2(0.01, 0.02), square_grid(default_grid)));
    advance(state, 0);
    REQUIRE(state.home);
    CHECK(state.home->homes[0].values == 3);
    run(state, "home.1");
    CHECK(text_of(state) == with(table, "at: [0.1, 0.8]", "at: [0.11, 0.82]"));
    drag.cancel(state.document);
    REQUIRE(drag.begin(state.document, id_of(state.document, "post.3"), {0.21, 0.82}));
    CHECK_FALSE(drag.update(state.document, {0.25, 0.82}, square_grid(default_grid)));
    CHECK(state.document.scene().find("post.1")->get<Vec2>("at").x() == Approx(0.15));
    drag.cancel(state.document);
    CHECK(text_of(state) == with(table, "at: [0.1, 0.8]", "at: [0.11, 0.82]"));
    CHECK(state.document.scene().find("post.1")->get<Vec2>("at").x() == Approx(0.11));
}

TEST_CASE("what a template made is written out, and is the author's own then") {
    const Folder folder;
    AppState state = state_of(folder);
    state.selection = Selection({id_of(state.document, "large.wheel")});
    REQUIRE(enabled(state, "edit.write_out"));
    run(state, "edit.write_out");
    CHECK(state.document.scene().find("large_wheel"));
    CHECK(text_of(state).find("# alone") != std::string::npos);
    CHECK(edit(state, change(state.document, "large_wheel", "radius", 0.03), "Change"));
    CHECK(state.document.scene().find("small.wheel")->get<double>("radius") == 0.02);
    CHECK_FALSE(enabled(state, "edit.write_out"));
    run(state, "edit.undo");
    run(state, "edit.undo");
    CHECK(text_of(state) == table);
}

TEST_CASE("neighbours become a template, a number a param, and a param is written out, each as one step") {
    const Folder folder;
    AppState state = state_of(folder);
    state.selection = Selection({id_of(state.document, "dot")});
    REQUIRE(enabled(state, "edit.make_template"));
    run(state, "edit.make_template");
    CHECK_THAT(text_of(state), Catch::Contains("  - use: {template: dot_template}\n") && Catch::Contains("  dot_template:\n    nodes:\n      - circle: {id: dot"));
    CHECK(state.document.scene().find(state.selection.primary())->generator);
    run(state, "edit.undo");
    CHECK(text_of(state) == table);
    state.selection = Selection({id_of(state.document, "large.wheel")});
    CHECK_FALSE(enabled(state, "edit.make_template"));

    const NodeId large = id_of(state.document, "large");
    make_param(state, large, *state.document.scene().find(large)->type->find_field("at"), 1);
    const std::string named = with(with(table, "at: [0.2, 0.6]", "at: [0.2, large_at_y]"), "max: 40mm}}", "max: 40mm}, large_at_y: 0.6}");
    CHECK(text_of(state) == named);
    write_out_param(state, "bloom");
    CHECK(text_of(state) == with(with(named, "bloom: {value: 34mm, min: 20mm, max: 40mm}, ", ""), "bloom * 0.5", "34mm * 0.5"));
    run(state, "edit.undo");
    run(state, "edit.undo");
    CHECK(text_of(state) == table);
}

TEST_CASE("what calls params and templates is duplicated, copied and pasted as its author wrote it") {
    const Folder folder;
    AppState state = state_of(folder);
    state.selection = Selection({id_of(state.document, "dot"), id_of(state.document, "small"), id_of(state.document, "post")});
    run(state, "edit.duplicate");
    const Scene& scene = state.document.scene();
    REQUIRE(scene.find("dot_2"));
    REQUIRE(scene.find("small_2.wheel"));
    REQUIRE(scene.find("post_2.3"));
    CHECK_THAT(text_of(state), Catch::Contains("id: dot_2, at: [") && Catch::Contains("radius: bloom * 0.5"));
    CHECK(scene.find("small_2.wheel")->get<double>("radius") == 0.02);
    run(state, "edit.undo");
    CHECK(text_of(state) == table);
    state.selection = Selection({id_of(state.document, "dot")});
    run(state, "edit.copy");
    run(state, "edit.paste_in_place");
    REQUIRE(state.document.scene().find("dot_2"));
    CHECK(state.document.scene().find("dot_2")->get<double>("radius") == 0.017);
    run(state, "edit.undo");
    CHECK(text_of(state) == table);
}

// What a hand takes hold of, and several nodes in it.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "editor/edit_tools.h"
#include "editor/pick.h"
#include "engine/core/rng.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

const std::string halves = R"(pinfield: 1
table: {size: [1, 1]}
scene:
  - mirror: {id: pair, at: [0.5, 0.5], children: [circle: {id: half, at: [0.2, 0], radius: 50mm}]}
  - union:
      id: both
      children:
        - circle: {id: left, at: [0.2, 0.2], radius: 50mm}
        - box: {id: right, at: [0.26, 0.2], size: [80mm, 40mm]}
)";

AppState state_of(const Folder& folder, const std::string& text) {
    AppState state(catalog(), Document::open(folder.write("table.yaml", text), catalog()).value());
    advance(state, 0);
    return state;
}

Vec2 place(const AppState& state, std::string_view node) { return state.document.scene().find(node)->get<Vec2>("at"); }

}  // namespace

TEST_CASE("an operator is picked whole, and its children once it is entered") {
    const Folder folder;
    const AppState state = state_of(folder, halves);
    const NodeId both = id_of(state.document, "both");
    CHECK(grip_at(state, {}, {0.17, 0.2}, 0).node == both);
    CHECK(grip_at(state, both, {0.17, 0.2}, 0).node == id_of(state.document, "left"));
    CHECK(grip_at(state, both, {0.29, 0.2}, 0).node == id_of(state.document, "right"));
    CHECK(grip_at(state, both, {0.5, 0.9}, 0).node == NodeId{});
}

TEST_CASE("the half under the hand follows the hand, on either side of a mirror") {
    const Folder folder;
    AppState state = state_of(folder, halves);
    const NodeId pair = id_of(state.document, "pair"), half = id_of(state.document, "half");
    const Vec2 moved_by(0.03, 0.02);
    for (const double side : {1.0, -1.0}) {
        const Vec2 hand(0.5 + side * 0.2, 0.5);
        const Hit hit = grip_at(state, pair, hand, 0);
        REQUIRE(hit.node == half);
        const Vec2 before = place(state, "half");
        NodeDrag drag;
        REQUIRE(drag.begin(state.document, std::array{Held{hit.node, hit.own_from_hand}}, hand));
        CHECK_FALSE(drag.update(state.document, hand + moved_by, square_grid(default_grid)));
        const Vec2 delta = place(state, "half") - before;
        CHECK(delta.x() == Approx(side * moved_by.x()));
        CHECK(delta.y() == Approx(moved_by.y()));
        drag.cancel(state.document);
    }
}

TEST_CASE("whatever shows copies of a child or bends it, the one under the hand goes where the hand goes") {
    const std::string child = "children: [circle: {id: disc, at: [0.06, 0.03], radius: 20mm}]";
    const std::string place = "at: [0.5, 0.5], turn: 20, scale: 1.3, ";
    const std::vector<std::string> operators = {
        "mirror: {id: op, " + place + "flip: y, across: y, " + child + "}",
        "repeat: {id: op, " + place + "count: [3, 2], step: [0.15, 0.14], " + child + "}",
        "repeat_polar: {id: op, " + place + "count: 5, " + child + "}",
        "stretch: {id: op, " + place + "by: [1.5, 0.7], " + child + "}",
        "bend: {id: op, " + place + "sag: 40mm, length: 300mm, " + child + "}",
        "twist: {id: op, " + place + "angle: 90, radius: 150mm, " + child + "}",
        "elongate: {id: op, " + place + "by: [20mm, 10mm], " + child + "}",
        "repeat_polar: {" + place + "count: 3, children: [mirror: {id: op, at: [0.12, 0.1], turn: 33, " + child + "}]}",
        "mirror: {" + place + "children: [twist: {id: op, at: [0.1, 0], angle: 60, radius: 120mm, " + child + "}]}",
    };
    CounterRng rng(20);
    for (const std::string& text : operators) {
        INFO(text);
        const Folder folder;
        AppState state = state_of(folder, "pinfield: 1\ntable: {size: [1, 1]}\nscene:\n  - " + text + "\n");
        REQUIRE_FALSE(has_errors(state.document.diagnostics()));
        const NodeId op = id_of(state.document, "op"), disc = id_of(state.document, "disc");
        int tried = 0;
        for (int i = 0; i < 40000 && tried < 40; ++i) {
            const Vec2 hand(rng.in(0, 1), rng.in(0, 1)), delta(rng.in(-4e-4, 4e-4), rng.in(-4e-4, 4e-4));
            const Hit hit = grip_at(state, op, hand, 0);
            if (hit.node != disc) continue;
            ++tried;
            NodeDrag drag;
            REQUIRE(drag.begin(state.document, std::array{Held{disc, hit.own_from_hand}}, hand));
            REQUIRE_FALSE(drag.update(state.document, hand + delta, square_grid(0)));
            advance(state, 0);
            // The disc's own distance at the hand is what it was, up to the grid of the file and what a bent way is not straight.
            const std::vector<Hit> after = hits_within(state, op, hand + delta, 1);
            REQUIRE_FALSE(after.empty());
            CHECK(std::fabs(after.front().distance - hit.distance) < 4e-5);
            drag.cancel(state.document);
            advance(state, 0);
        }
        CHECK(tried == 40);
    }
}

TEST_CASE("several nodes are moved together as one step, and nudges that follow each other are one") {
    const Folder folder;
    AppState state = opened_state(folder);
    const std::string before = state.document.source().text();
    state.selection = Selection({id_of(state.document, "pop"), id_of(state.document, "shelf")});
    const Vec2 pop = place(state, "pop"), shelf = place(state, "shelf");
    for (int i = 0; i < 5; ++i) run(state, "edit.nudge_right");
    run(state, "edit.nudge_far_up");
    CHECK(length(place(state, "pop") - pop - Vec2(0.005, 0.010)) < 1e-12);
    CHECK(length(place(state, "shelf") - shelf - Vec2(0.005, 0.010)) < 1e-12);
    CHECK(state.document.undo_steps() == 1);
    state.document.undo();
    CHECK(state.document.source().text() == before);
    state.document.redo();
    CHECK(length(place(state, "pop") - pop - Vec2(0.005, 0.010)) < 1e-12);
}

TEST_CASE("a nudge and its opposite leave no step") {
    const Folder folder;
    AppState state = opened_state(folder);
    select(state, id_of(state.document, "shelf"));
    run(state, "edit.nudge_right");
    run(state, "edit.nudge_left");
    INFO(state.document.source().text());
    CHECK(state.document.undo_steps() == 0);
    CHECK_FALSE(state.document.dirty());
}

TEST_CASE("a nudge takes back no step but its own") {
    const Folder folder;
    AppState state = opened_state(folder);
    select(state, id_of(state.document, "pop"));
    run(state, "edit.nudge_right");
    run(state, "edit.undo");
    REQUIRE(edit(state, change(state.document, "pop", "kick", 1.25), "Kick harder"));
    run(state, "edit.nudge_right");
    CHECK(state.document.undo_steps() == 2);
    CHECK(state.document.scene().find("pop")->get<double>("kick") == 1.25);
    CHECK(place(state, "pop").x() == Approx(0.251));
}

TEST_CASE("another table is replaced only when it is named twice") {
    const Folder folder;
    AppState state = opened_state(folder);
    const std::string other = folder.write("other.yaml", "precious");
    run(state, "file.save_as");
    state.dialog_path = other;
    run(state, "dialog.accept");
    CHECK(state.message_is_problem);
    CHECK(folder.read("other.yaml") == "precious");
    run(state, "dialog.accept");
    CHECK(folder.read("other.yaml") == state.document.source().text());
}

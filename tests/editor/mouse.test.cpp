// The tree and the table under a person's mouse, in frames without a window.
#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

const std::string pair_of_discs = R"(pinfield: 1
table: {size: [1, 1]}
scene:
  - domain: {id: hall, children: [box: {id: room, size: [0.9, 0.9], at: [0.5, 0.5]}]}
  - circle: {id: a, at: [0.3, 0.7], radius: 40mm}   # first
  - circle: {id: b, at: [0.5, 0.7], radius: 40mm}
  - union:
      id: both
      children:
        - circle: {id: left, at: [0.3, 0.3], radius: 50mm}
        - circle: {id: right, at: [0.36, 0.3], radius: 50mm}
)";

/// Tree to the left, table to the right, and a mouse.
class Desk : public Screen {
public:
    explicit Desk(const std::string& table = pair_of_discs) : Screen({1000, 800}), state_(opened_state(folder_, table)) {
        state_.preferences.snapping = false;
        for (int i = 0; i < 3; ++i) frame();
    }

    AppState& state() { return state_; }
    std::string text() const { return state_.document.source().text(); }
    NodeId id(std::string_view node) const { return id_of(state_.document, node); }
    Vec2 place(std::string_view node) const { return state_.document.scene().find(node)->get<Vec2>("at"); }
    bool selected(std::vector<std::string_view> nodes) const {
        std::vector<NodeId> ids;
        for (const std::string_view node : nodes) ids.push_back(id(node));
        std::vector<NodeId> chosen = state_.selection.nodes();
        std::sort(ids.begin(), ids.end());
        std::sort(chosen.begin(), chosen.end());
        return ids == chosen;
    }

    void frame() {
        frame_of([&] {
            hierarchy_panel(state_, ui_, {0, 0}, {250, 800});
            viewport_panel(state_, ui_, {250, 0}, {750, 800});
            advance(state_, 0);
        });
    }
    void move_to(const Vec2& pixel) {
        ui_.mouse = pixel;
        ImGui::GetIO().MousePos = {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
        frame();
    }
    void button(int which, bool down) {
        ImGui::GetIO().MouseDown[which] = down;
        frame();
    }
    void click(const Vec2& pixel, int which = 0) {
        move_to(pixel);
        button(which, true);
        button(which, false);
        frame();
    }
    void drag(const Vec2& from, const Vec2& to) {
        move_to(from);
        button(0, true);
        for (const double share : {0.3, 0.7, 1.0}) move_to(from + share * (to - from));
        frame();
        button(0, false);
        frame();
    }
    void rest() {  // long enough that the next click is no double one
        for (int i = 0; i < 40; ++i) frame();
    }
    Vec2 on_table(double x, double y) const { return state_.view.pixel_from_world({x, y}); }
    /// A place on the row of this name in the tree: `along` 0 is its upper edge, 1 its lower one.
    Vec2 row(std::string_view name, float along = 0.5f) {
        const auto found = std::find_if(seen_.begin(), seen_.end(), [&](const ScreenText& t) { return t.text == name && t.at.x < 250; });
        REQUIRE(found != seen_.end());
        const float height = ui_.theme.px(25), middle = found->at.y + 0.5f * ImGui::GetIO().Fonts->Fonts[0]->FontSize;
        return {found->at.x + 5, middle + (along - 0.5f) * height};
    }
    /// Clicks the words of an open menu.
    void choose(std::string_view words) {
        frame();
        const auto found = std::find_if(seen_.begin(), seen_.end(), [&](const ScreenText& t) { return t.text.starts_with(words); });
        REQUIRE(found != seen_.end());
        click({found->at.x + 5, found->at.y + 7});
    }

private:
    Folder folder_;
    AppState state_;
};

}  // namespace

TEST_CASE("a box drawn rightwards selects what lies in it, leftwards what it touches, with Shift besides") {
    Desk desk;
    desk.drag(desk.on_table(0.20, 0.80), desk.on_table(0.50, 0.60));
    CHECK(desk.selected({"a"}));
    desk.rest();
    desk.drag(desk.on_table(0.50, 0.60), desk.on_table(0.20, 0.80));
    CHECK(desk.selected({"a", "b"}));
    desk.rest();
    ImGui::GetIO().KeyShift = true;
    desk.drag(desk.on_table(0.20, 0.40), desk.on_table(0.45, 0.20));
    CHECK(desk.selected({"a", "b", "both"}));
    ImGui::GetIO().KeyShift = false;
    desk.rest();
    desk.click(desk.on_table(0.7, 0.5));
    CHECK(desk.selected({}));
    CHECK_FALSE(desk.state().document.can_undo());
}

TEST_CASE("one of several selected nodes takes the others along; a click on it leaves it alone selected") {
    Desk desk;
    desk.state().selection = Selection({desk.id("a"), desk.id("b")});
    desk.drag(desk.on_table(0.3, 0.7), desk.on_table(0.35, 0.75));
    CHECK(length(desk.place("a") - Vec2(0.35, 0.75)) < 2e-3);
    CHECK(length(desk.place("b") - desk.place("a") - Vec2(0.2, 0)) < 1e-9);
    CHECK(desk.state().document.undo_steps() == 1);
    CHECK(desk.selected({"a", "b"}));
    desk.rest();
    desk.click(desk.on_table(0.35, 0.75));
    CHECK(desk.selected({"a"}));
}

TEST_CASE("a drag with Alt leaves the original and moves a copy, as one step; Esc takes both back") {
    Desk desk;
    const std::string before = desk.text();
    ImGui::GetIO().KeyAlt = true;
    desk.drag(desk.on_table(0.3, 0.7), desk.on_table(0.3, 0.5));
    CHECK(desk.place("a") == Vec2(0.3, 0.7));
    CHECK(length(desk.place("a_2") - Vec2(0.3, 0.5)) < 2e-3);
    CHECK(desk.state().document.undo_steps() == 1);
    CHECK(*desk.state().document.undo_label() == "Duplicate a");
    const std::string after = desk.text();
    desk.state().document.undo();
    CHECK(desk.text() == before);
    desk.state().document.redo();
    CHECK(desk.text() == after);
    desk.state().document.undo();
    desk.rest();

    desk.move_to(desk.on_table(0.5, 0.7));
    desk.button(0, true);
    desk.move_to(desk.on_table(0.5, 0.6));
    desk.move_to(desk.on_table(0.5, 0.5));
    REQUIRE(desk.state().document.scene().find("b_2"));
    CHECK(cancel_drag(desk.state(), desk.ui()));
    CHECK(desk.text() == before);
    desk.button(0, false);
    CHECK(desk.text() == before);
}

TEST_CASE("a double click goes into an operator, whose children are then dragged; elsewhere leads out") {
    Desk desk;
    desk.click(desk.on_table(0.28, 0.3));
    CHECK(desk.selected({"both"}));
    desk.click(desk.on_table(0.28, 0.3));
    CHECK(desk.selected({"left"}));
    CHECK(desk.state().entered == desk.id("both"));
    desk.rest();
    desk.drag(desk.on_table(0.39, 0.3), desk.on_table(0.39, 0.35));
    CHECK(desk.selected({"right"}));
    CHECK(desk.place("right").y() == Approx(0.35).margin(2e-3));
    CHECK(desk.place("left") == Vec2(0.3, 0.3));
    desk.rest();
    desk.click(desk.on_table(0.3, 0.7));
    CHECK(desk.selected({"a"}));
    CHECK_FALSE(desk.state().entered);
}

TEST_CASE("a double click on the wall takes hold of its piece, and the table can still be clicked") {
    Desk desk;
    for (int i = 0; i < 2; ++i) desk.click(desk.on_table(0.02, 0.5));
    CHECK(desk.selected({"room"}));
    desk.rest();
    desk.click(desk.on_table(0.5, 0.7));
    CHECK(desk.selected({"b"}));
    select(desk.state(), desk.id("room"));
    desk.rest();
    desk.click(desk.on_table(0.7, 0.5));
    CHECK(desk.selected({}));
}

TEST_CASE("the menu of a row does what it says, and the tree is drawn on") {
    Desk desk;
    desk.click(desk.row("a"), 1);
    CHECK(desk.selected({"a"}));
    desk.choose("Delete");
    CHECK_FALSE(desk.state().document.scene().find("a"));
    desk.frame();
    desk.state().document.undo();
    desk.rest();
    desk.click(desk.on_table(0.5, 0.7), 1);
    CHECK(desk.selected({"b"}));
    desk.choose("Duplicate");
    CHECK(desk.state().document.scene().find("b_2"));
}

TEST_CASE("rows are dragged before, behind and into others") {
    Desk desk;
    desk.drag(desk.row("b"), desk.row("a", 0.1f));
    CHECK(desk.state().document.scene().index_of(desk.id("b")) == 1);
    CHECK(desk.state().document.scene().index_of(desk.id("a")) == 2);
    desk.rest();
    desk.drag(desk.row("b"), desk.row("a", 0.9f));
    CHECK(desk.state().document.scene().index_of(desk.id("b")) == 2);
    desk.rest();
    desk.drag(desk.row("a"), desk.row("both"));
    CHECK(desk.state().document.scene().find("a")->parent == desk.id("both"));
    CHECK_THAT(desk.text(), Catch::Contains("# first"));
}

TEST_CASE("F2 types an id in the tree, also where the filter hid the row") {
    Desk desk;
    desk.ui().filter = "nothing like it";
    select(desk.state(), desk.id("b"));
    run(desk.state(), "edit.rename");
    desk.frame();
    desk.frame();
    CHECK(desk.ui().renaming.node == desk.id("b"));
    for (const char c : std::string("bumper")) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
    desk.frame();
    ImGui::GetIO().KeyMap[ImGuiKey_Enter] = 257;
    ImGui::GetIO().KeysDown[257] = true;
    desk.frame();
    ImGui::GetIO().KeysDown[257] = false;
    desk.frame();
    CHECK(desk.state().document.scene().find("bumper"));
    CHECK_FALSE(desk.ui().renaming.node);
}

TEST_CASE("a handle is dragged before the node it lies on, as one step; Esc takes it back") {
    Desk desk;
    const std::string before = desk.text();
    desk.click(desk.on_table(0.3, 0.7));
    desk.rest();
    desk.drag(desk.on_table(0.34, 0.7), desk.on_table(0.37, 0.7));
    CHECK(desk.place("a") == Vec2(0.3, 0.7));
    CHECK(desk.state().document.scene().find("a")->get<double>("radius") == Approx(0.07).margin(2e-3));
    CHECK(desk.state().document.undo_steps() == 1);
    desk.state().document.undo();
    CHECK(desk.text() == before);
    desk.rest();
    desk.move_to(desk.on_table(0.34, 0.7));
    desk.button(0, true);
    desk.move_to(desk.on_table(0.4, 0.7));
    CHECK(desk.state().document.previewing());
    CHECK(cancel_drag(desk.state(), desk.ui()));
    desk.button(0, false);
    CHECK(desk.text() == before);
    CHECK_FALSE(desk.state().document.previewing());
}

TEST_CASE("with the move tool no handle is in the way; the turn tool turns what is selected, wherever the hand is") {
    Desk desk;
    desk.click(desk.on_table(0.3, 0.7));
    desk.rest();
    run(desk.state(), "tool.move");
    desk.drag(desk.on_table(0.34, 0.7), desk.on_table(0.37, 0.7));
    CHECK(desk.place("a").x() == Approx(0.33).margin(2e-3));
    desk.rest();
    run(desk.state(), "tool.turn");
    const Vec2 centre = desk.place("a");
    desk.drag(desk.on_table(centre.x(), 0.9), desk.on_table(centre.x() - 0.2, 0.7));
    CHECK(desk.state().document.scene().find("a")->get<double>("turn") == Approx(90).margin(1));
    CHECK(desk.place("a") == centre);
    CHECK(desk.selected({"a"}));
    desk.rest();
    run(desk.state(), "tool.scale");
    desk.drag(desk.on_table(centre.x(), 0.8), desk.on_table(centre.x(), 0.85));
    CHECK(desk.state().document.scene().find("a")->get<double>("scale") == Approx(1.5).margin(0.02));
    CHECK(desk.state().document.undo_steps() == 3);
    desk.rest();
    desk.click(desk.on_table(0.8, 0.5));
    CHECK(desk.selected({}));
}

TEST_CASE("a drag snaps to what stands in line, unless Ctrl is held or snapping is off") {
    const auto dropped_at = [](bool snapping, bool control) {
        Desk desk;
        desk.state().preferences.snapping = snapping;
        ImGui::GetIO().KeyCtrl = control;
        desk.drag(desk.on_table(0.3, 0.7), desk.on_table(0.3 + 0.0432, 0.7 - 0.1 + 0.0033));
        ImGui::GetIO().KeyCtrl = false;
        return desk.place("a");
    };
    // Disc b stands at 0.5, 0.7; the lower discs' middles lie at 0.3, 0.3; the middle of the table at 0.5, 0.5.
    const Vec2 free = dropped_at(false, true);
    CHECK(free.y() == Approx(0.6033).margin(1e-3));
    const auto dropped_near = [](bool snapping) {
        Desk desk;
        desk.state().preferences.snapping = snapping;
        desk.drag(desk.on_table(0.3, 0.7), desk.on_table(0.6, 0.504));
        return desk.place("a");
    };
    CHECK(dropped_near(true).y() == 0.5);
    CHECK(dropped_near(false).y() == Approx(0.504).margin(1e-3));
}

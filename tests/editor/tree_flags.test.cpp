// The eye and the lock at the end of a row of the tree; and what the tree and the status bar say of size and place.
#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

constexpr float width = 320;

class Tree : public Screen {
public:
    explicit Tree(AppState& state) : Screen({width, 700}), state_(state) { frame(); }

    void frame() {
        frame_of([&] { hierarchy_panel(state_, ui_, {0, 0}, {width, 700}); });
    }
    const ScreenText* find(std::string_view words) const {
        const auto found = std::find_if(seen_.begin(), seen_.end(), [&](const ScreenText& t) { return t.text == words; });
        return found == seen_.end() ? nullptr : &*found;
    }
    /// In the row with this name, so far from the panel's right edge.
    void click(std::string_view name, float from_right) {
        const ScreenText* row = find(name);
        INFO(name);
        REQUIRE(row);
        ImGui::GetIO().MousePos = {width - from_right, row->at.y + 3};
        for (const bool down : {false, true, false}) {
            ImGui::GetIO().MouseDown[0] = down;
            frame();
        }
        frame();
    }

private:
    AppState& state_;
};

/// Pixels from the panel's right edge to the middle of the lock, and of the eye.
constexpr float lock = 22, eye = 40;

bool flag(const AppState& state, const std::string& id, std::string_view key) {
    return std::get<bool>(state.document.scene().find(id_of(state.document, id))->value(key));
}

}  // namespace

TEST_CASE("the eye and the lock of a row are switched by a click, undone as one step, and switched back leave the file as it was") {
    const Folder folder;
    AppState state = opened_state(folder);
    const std::string before = state.document.source().text();
    Tree tree(state);
    tree.click("pop", lock);
    CHECK(flag(state, "pop", "locked"));
    tree.click("pop", eye);
    CHECK_FALSE(flag(state, "pop", "visible"));
    CHECK(flag(state, "pop", "locked"));
    CHECK(state.selection.empty());  // a flag's click chooses nothing
    tree.click("pop", eye);
    tree.click("pop", lock);
    CHECK(state.document.source().text() == before);
    for (int i = 0; i < 3; ++i) run(state, "edit.undo");
    CHECK(flag(state, "pop", "locked"));
    CHECK(flag(state, "pop", "visible"));
}

TEST_CASE("the eye of one of several that are selected switches all of them, of another one it alone") {
    const Folder folder;
    AppState state = opened_state(folder);
    Tree tree(state);
    const NodeId pop = id_of(state.document, "pop"), other = state.document.scene().roots().front();
    const std::string other_id = state.document.scene().find(other)->name;
    REQUIRE(other != pop);
    state.selection = Selection({pop, other});
    tree.frame();
    tree.click("pop", eye);
    CHECK_FALSE(flag(state, "pop", "visible"));
    CHECK_FALSE(std::get<bool>(state.document.scene().find(other)->value("visible")));
    run(state, "edit.undo");
    CHECK(flag(state, "pop", "visible"));
    CHECK(std::get<bool>(state.document.scene().find(other)->value("visible")));
    state.selection = Selection({other});
    tree.frame();
    tree.click("pop", eye);
    CHECK_FALSE(flag(state, "pop", "visible"));
    CHECK(std::get<bool>(state.document.scene().find(other)->value("visible")));
}

TEST_CASE("a box is told by its sides and its middle in millimetres, and what has neither by nothing") {
    const Box2 box = Box2{}.merged({{0.226, 0.69}, {0.274, 0.7101}});
    CHECK(size_in_words(box) == "48 \u00d7 20.1 mm");
    CHECK(place_in_words(box) == "at 250, 700");
    CHECK(size_in_words(Box2{}).empty());
    CHECK(place_in_words(Box2{}).empty());
}

TEST_CASE("a viewport of another size still shows the whole table where it did, and otherwise as much of its height") {
    const Box2 table{{0, 0}, {0.52, 1.06}};
    View view;
    view.size = {600, 800};
    view.frame_table(table);
    for (const Vec2& size : {Vec2(300, 500), Vec2(1200, 300), Vec2(200, 900), Vec2(640, 810)}) {
        view.resize(size, table);
        View fresh = view;
        fresh.frame_table(table);
        CHECK(view.pixels_per_metre == Approx(fresh.pixels_per_metre).epsilon(1e-12));
    }
    view.zoom_at({320, 405}, 2);
    const double height = view.size.y() / view.pixels_per_metre;
    view.resize({500, 400}, table);
    CHECK(view.size.y() / view.pixels_per_metre == Approx(height));
}

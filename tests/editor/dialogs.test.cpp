// Questions answered by the keyboard alone, in frames without a window.
#include <catch2/catch.hpp>

#include "editor/keep_work.h"
#include "editor/starters.h"
#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

/// The dialogs of an editor, and its keys.
class Desk : public Screen {
public:
    explicit Desk(AppState& state) : Screen({1000, 800}), state_(state) {}

    void frame() {
        frame_of([&] {
            starter_dialog(state_, ui_);
            path_dialog(state_, ui_);
            prompt_dialog(state_, ui_);
            recovery_dialog(state_, ui_);
        });
    }
    void press(ImGuiKey key) {
        for (const bool down : {true, false}) {
            ImGui::GetIO().KeysDown[key] = down;
            frame();
        }
    }
    bool shows(const std::string& text) const {
        return std::any_of(seen_.begin(), seen_.end(), [&](const ScreenText& t) { return t.text.find(text) != std::string::npos; });
    }

private:
    AppState& state_;
};

/// An editor that finds the work of one that died.
AppState finding_state(const Folder& folder) {
    folder.write("table.yaml", pen);
    for (int i = 0; i < 2; ++i) {
        AppState state(catalog(), *Document::open(folder.file("table.yaml"), catalog()));
        keep_work(state, folder.file("journals"));
        if (i == 1) return state;
        REQUIRE(edit(state, change(state.document, "pop", "kick", 3.0), "Kick"));
        advance(state, 0);
    }
    FAIL();
    std::abort();
}

}  // namespace

TEST_CASE("the offer of unsaved work shows the lines and is answered by keys: Enter restores, Esc puts it off, discarding needs a way to go") {
    const Folder folder;
    AppState state = finding_state(folder);
    Desk desk(state);
    for (int i = 0; i < 3; ++i) desk.frame();
    REQUIRE(state.recovery);
    CHECK(desk.shows("Unsaved work was found"));
    CHECK(desk.shows("1 edit since the last save"));
    CHECK(desk.shows("kick: 3"));
    SECTION("Enter") {
        desk.press(ImGuiKey_Enter);
        CHECK(state.document.dirty());
    }
    SECTION("Escape") {
        desk.press(ImGuiKey_Escape);
        CHECK_FALSE(state.document.dirty());
        CHECK(find_orphans(folder.file("journals")).found.size() == 1);
    }
    SECTION("Left, Left, Space") {
        desk.press(ImGuiKey_LeftArrow);
        desk.press(ImGuiKey_LeftArrow);
        REQUIRE(state.recovery);
        desk.press(ImGuiKey_Space);
        CHECK_FALSE(state.document.dirty());
        CHECK(find_orphans(folder.file("journals")).found.empty());
    }
    CHECK_FALSE(state.recovery);
    desk.frame();
    CHECK_FALSE(desk.shows("Unsaved work was found"));
}

TEST_CASE("where the file has changed since, Enter leaves both as they are") {
    const Folder folder;
    AppState state = finding_state(folder);
    folder.write("table.yaml", pen + "# theirs\n");
    look_at_disk(state);
    Desk desk(state);
    for (int i = 0; i < 3; ++i) desk.frame();
    REQUIRE(desk.shows("The file has changed since"));
    desk.press(ImGuiKey_Enter);
    CHECK_FALSE(state.recovery);
    CHECK_FALSE(state.document.dirty());
    CHECK(find_orphans(folder.file("journals")).found.size() == 1);
}

TEST_CASE("a key that is down while a question appears does not answer it") {
    const Folder folder;
    AppState state = finding_state(folder);
    Desk desk(state);
    desk.press(ImGuiKey_Enter);
    CHECK(state.recovery);
}

TEST_CASE("unsaved changes are saved by Enter, kept by Esc, and discarded by Tab and Space") {
    const Folder folder;
    AppState state = opened_state(folder);
    REQUIRE(edit(state, change(state.document, "pop", "kick", 3.0), "Kick"));
    run(state, "app.quit");
    Desk desk(state);
    for (int i = 0; i < 3; ++i) desk.frame();
    REQUIRE(desk.shows("Unsaved changes"));
    SECTION("Enter") {
        desk.press(ImGuiKey_Enter);
        CHECK(state.quit);
        CHECK(folder.read("table.yaml") != pen);
    }
    SECTION("Escape") {
        desk.press(ImGuiKey_Escape);
        CHECK_FALSE(state.quit);
        CHECK(state.document.dirty());
    }
    SECTION("Tab, Space") {
        desk.press(ImGuiKey_Tab);
        desk.press(ImGuiKey_Space);
        CHECK(state.quit);
        CHECK(folder.read("table.yaml") == pen);
    }
    CHECK_FALSE(state.prompt);
}

TEST_CASE("the tables to begin with keep a picture each, under the name that chooses them") {
    AppState state = untitled_state();
    run(state, "file.new");
    Desk desk(state);
    for (int i = 0; i < 3; ++i) desk.frame();
    const auto& pictures = desk.ui().palette.pictures;
    CHECK(pictures.size() == starters().size());
    for (const Starter& starter : starters()) {
        const auto found = pictures.find(action_of(starter));
        REQUIRE(found != pictures.end());
        CHECK_FALSE(found->second.lines.empty());
    }
}

// The file and the table are changed at once: both changes are had, and a question is asked only about what both have touched.
#include "editor/follow_disk.h"

#include <catch2/catch.hpp>

#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

std::string with(std::string text, const std::string& from, const std::string& to) {
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
}

double kick(const AppState& state) { return state.document.scene().find("pop")->get<double>("kick"); }

/// An editor with an edit, and the file changed by somebody else.
AppState both_changed(const Folder& folder, const std::string& theirs) {
    AppState state = opened_state(folder);
    REQUIRE(edit(state, change(state.document, "pop", "kick", 0.9), "Kick"));
    folder.write("table.yaml", theirs);
    return state;
}

class Desk : public Screen {
public:
    explicit Desk(AppState& state) : Screen({1000, 800}), state_(state) {
        for (int i = 0; i < 3; ++i) frame();
    }
    void frame() {
        frame_of([&] { merge_dialog(state_, ui_); });
    }
    void press(ImGuiKey key) {
        for (const bool down : {true, false}) {
            ImGui::GetIO().KeysDown[key] = down;
            frame();
        }
    }
    void type(char letter) {
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(letter));
        frame();
    }
    bool shows(const std::string& text) const {
        return std::any_of(seen_.begin(), seen_.end(), [&](const ScreenText& t) { return t.text.find(text) != std::string::npos; });
    }

private:
    AppState& state_;
};

}  // namespace

TEST_CASE("changes of both are had as one step, in each one's words; undo brings mine back, and a save writes both") {
    const Folder folder;
    const std::string theirs = with(pen, "size: [200mm, 0.02]}", "size: [21cm, 0.02]}   # wider");
    AppState state = both_changed(folder, theirs);
    const std::string mine = state.document.source().text();
    const NodeId pop = id_of(state.document, "pop");
    look_at_disk(state);
    CHECK_FALSE(state.merge);
    CHECK(state.document.source().text() == with(theirs, "kick: 0.8", "kick: 0.9"));
    CHECK(state.document.undo_steps() == 2);
    CHECK(id_of(state.document, "pop") == pop);
    CHECK(state.document.dirty());
    CHECK(state.document.saved_text() == theirs);
    CHECK(state.document.unsaved_steps() == 1);
    CHECK_FALSE(state.document.saved_after());
    CHECK_THAT(state.message, Catch::Contains("Merged with table.yaml"));
    SECTION("undone") {
        run(state, "edit.undo");
        CHECK(state.document.source().text() == mine);
        look_at_disk(state);
        CHECK(state.document.source().text() == mine);
        run(state, "edit.redo");
        CHECK(state.document.source().text() == with(theirs, "kick: 0.8", "kick: 0.9"));
    }
    SECTION("saved") {
        run(state, "file.save");
        CHECK(folder.read("table.yaml") == with(theirs, "kick: 0.8", "kick: 0.9"));
        CHECK_FALSE(state.document.dirty());
    }
    SECTION("and once more") {
        folder.write("table.yaml", with(theirs, "radius: 10mm", "radius: 11mm"));
        look_at_disk(state);
        CHECK(state.document.source().text() == with(with(theirs, "kick: 0.8", "kick: 0.9"), "radius: 10mm", "radius: 11mm"));
    }
}

TEST_CASE("a save takes in what others have saved meanwhile") {
    const Folder folder;
    const std::string theirs = with(pen, "# the walls", "# the four walls");
    AppState state = both_changed(folder, theirs);
    run(state, "file.save");
    CHECK(folder.read("table.yaml") == with(theirs, "kick: 0.8", "kick: 0.9"));
    CHECK_FALSE(state.document.dirty());
}

TEST_CASE("the running table follows a merge, a renamed node is still the same one, and the balls roll on") {
    const Folder folder;
    AppState state = opened_state(folder);
    const NodeId pop = id_of(state.document, "pop");
    REQUIRE_FALSE(rename_node(state.document, pop, "bang").refusal);
    folder.write("table.yaml", with(pen, "kick: 0.8", "kick: 0.7"));
    for (int i = 0; i < 100; ++i) advance(state, 1);
    const Vec2 ball = state.session.world().balls()[0].position;
    look_at_disk(state);
    advance(state, 0);
    CHECK(state.document.scene().find("bang")->get<double>("kick") == 0.7);
    CHECK(id_of(state.document, "bang") == pop);
    CHECK(state.session.world().balls()[0].position == ball);
    CHECK_FALSE(state.document.scene().find("pop"));
}

TEST_CASE("what both changed is asked about, everything else waits for no answer, and each answer does what it says") {
    const Folder folder;
    const std::string theirs = with(with(pen, "kick: 0.8", "kick: 0.7"), "radius: 10mm", "radius: 11mm");
    AppState state = both_changed(folder, theirs);
    const std::string mine = state.document.source().text();
    look_at_disk(state);
    REQUIRE(state.merge);
    REQUIRE(state.merge->merge->conflicts.size() == 1);
    const ToldConflict& conflict = state.merge->merge->conflicts[0];
    CHECK(conflict.what == "pop: kick");
    CHECK((conflict.base == "0.8" && conflict.mine == "0.9" && conflict.theirs == "0.7"));
    CHECK(state.document.source().text() == mine);
    CHECK_FALSE(enabled(state, "file.save"));
    const auto is_merged = [&](double expected) {
        CHECK_FALSE(state.merge);
        CHECK(kick(state) == expected);
        CHECK(state.document.scene().find("post")->get<double>("radius") == 0.011);
        run(state, "edit.undo");
        CHECK(state.document.source().text() == mine);
    };
    SECTION("mine") {
        run(state, "merge.mine");
        is_merged(0.9);
    }
    SECTION("theirs") {
        run(state, "merge.theirs");
        is_merged(0.7);
    }
    SECTION("one by one") {
        run(state, "merge.theirs_here");
        run(state, "merge.accept");
        is_merged(0.7);
    }
    SECTION("later") {
        run(state, "merge.later");
        CHECK_FALSE(state.merge);
        CHECK(state.document.source().text() == mine);
        look_at_disk(state);
        CHECK_FALSE(state.merge);
        run(state, "merge.ask");
        REQUIRE(state.merge);
        run(state, "merge.later");
        folder.write("table.yaml", with(theirs, "kick: 0.7", "kick: 0.6"));
        look_at_disk(state);
        REQUIRE(state.merge);
        CHECK(state.merge->merge->conflicts[0].theirs == "0.6");
        folder.write("table.yaml", pen);
        look_at_disk(state);
        CHECK_FALSE(state.merge);
    }
    SECTION("a save asks, too, and writes nothing") {
        run(state, "merge.later");
        state.merge_put_off.clear();
        run(state, "file.save");
        CHECK(state.merge);
        CHECK(folder.read("table.yaml") == theirs);
    }
}

TEST_CASE("a file that does not read is no merge: the table stays, and what reads again is merged") {
    const Folder folder;
    AppState state = both_changed(folder, with(pen, "kick: 0.8", "kick: {"));
    look_at_disk(state);
    CHECK_FALSE(state.merge);
    CHECK(state.disk == DiskState::conflict);
    CHECK(kick(state) == 0.9);
    CHECK_THAT(state.message, Catch::Contains("cannot be read"));
    folder.write("table.yaml", with(pen, "radius: 10mm", "radius: 11mm"));
    look_at_disk(state);
    CHECK(kick(state) == 0.9);
    CHECK(state.document.scene().find("post")->get<double>("radius") == 0.011);
}

TEST_CASE("changes that do not go together are taken whole from one side or the other") {
    const Folder folder;
    AppState state = opened_state(folder);
    REQUIRE(edit(state, change(state.document, "shelf", "material", std::string("rubber")), "Rubber"));
    const std::string mine = state.document.source().text();
    const std::string theirs = with(with(pen, ", material: rubber", ""), "  rubber: {restitution: 0.8, color: crimson}   # bouncy\n", "");
    folder.write("table.yaml", theirs);
    look_at_disk(state);
    REQUIRE(state.merge);
    CHECK_THAT(state.merge->merge->refusal, Catch::Contains("rubber"));
    CHECK_FALSE(enabled(state, "merge.accept"));
    SECTION("mine") {
        run(state, "merge.mine");
        CHECK(state.document.source().text() == mine);
        CHECK(state.document.dirty());
        run(state, "file.save");
        CHECK(folder.read("table.yaml") == mine);
    }
    SECTION("the file's") {
        run(state, "merge.theirs");
        CHECK(state.document.source().text() == theirs);
        CHECK_FALSE(state.document.dirty());
        run(state, "edit.undo");
        CHECK(state.document.source().text() == mine);
    }
}

TEST_CASE("the question shows all three values and is answered by keys: arrows, M and T choose, Enter merges, Esc puts it off") {
    const Folder folder;
    AppState state = both_changed(folder, with(with(pen, "kick: 0.8", "kick: 0.7"), "[200mm, 0.02]", "[190mm, 0.02]"));
    REQUIRE(edit(state, change(state.document, "shelf", "size", Vec2(0.21, 0.02)), "Widen"));
    look_at_disk(state);
    REQUIRE(state.merge);
    Desk desk(state);
    for (const char* words : {"table.yaml changed on disk too", "pop: kick", "shelf: size", "0.8", "0.9", "0.7", "[190mm, 0.02]"}) {
        INFO(words);
        CHECK(desk.shows(words));
    }
    SECTION("Enter takes mine, as it is at first") {
        desk.press(ImGuiKey_Enter);
        CHECK(kick(state) == 0.9);
        CHECK_FALSE(state.document.disk_merge());
    }
    SECTION("T takes the first of theirs, and goes to the next") {
        desk.type('t');
        CHECK(state.merge->row == 1);
        desk.press(ImGuiKey_UpArrow);
        CHECK(state.merge->row == 0);
        desk.press(ImGuiKey_DownArrow);
        desk.type('M');
        desk.press(ImGuiKey_Enter);
        const bool first_is_kick = kick(state) == 0.7;
        CHECK(state.document.scene().find("shelf")->get<Vec2>("size").x() == (first_is_kick ? 0.21 : 0.19));
    }
    SECTION("Escape") {
        desk.press(ImGuiKey_Escape);
        CHECK_FALSE(state.merge);
        CHECK(kick(state) == 0.9);
        CHECK(state.document.disk_merge());
    }
}

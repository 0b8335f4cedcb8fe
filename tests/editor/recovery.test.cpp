#include "editor/recovery.h"

#include <catch2/catch.hpp>

#include "editor/keep_work.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

namespace fs = std::filesystem;

/// An editor whose journals are in the folder too.
AppState keeping_state(const Folder& folder) {
    AppState state(catalog(), *Document::open(folder.file("table.yaml"), catalog()));
    keep_work(state, folder.file("journals"));
    return state;
}

void kick(AppState& state, double how) {
    REQUIRE(edit(state, change(state.document, "pop", "kick", how), "Kick " + std::to_string(static_cast<int>(how))));
    advance(state, 1);
}

/// Leaves three edits behind, as a killed editor would; returns their text.
std::string leave_work(const Folder& folder) {
    AppState state = keeping_state(folder);
    for (const double how : {1.0, 2.0, 3.0}) kick(state, how);
    return state.document.source().text();
}

std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t journals_in(const Folder& folder) {
    std::error_code none;
    std::size_t count = 0;
    for (fs::directory_iterator it(folder.file("journals"), none), end; !none && it != end; ++it) ++count;
    return count;
}

}  // namespace

TEST_CASE("a clean document has no journal, an edited one has, a saved one has none again") {
    const Folder folder;
    folder.write("table.yaml", pen);
    AppState state = keeping_state(folder);
    advance(state, 1);
    CHECK(journals_in(folder) == 0);
    kick(state, 1);
    REQUIRE(journals_in(folder) == 1);
    SECTION("saved") { run(state, "file.save"); }
    SECTION("undone") { run(state, "edit.undo"); }
    SECTION("reloaded") { run(state, "file.reload"); }
    SECTION("discarded for another table") {
        run(state, "new.blank");
        CHECK(journals_in(folder) == 1);
        run(state, "prompt.discard");
    }
    SECTION("saved on leaving") {
        run(state, "app.quit");
        run(state, "prompt.save");
        CHECK(state.quit);
    }
    SECTION("discarded for good") {
        run(state, "app.quit");
        run(state, "prompt.discard");
        CHECK(state.quit);
    }
    advance(state, 1);
    CHECK(journals_in(folder) == 0);
}

TEST_CASE("the steps since the last save are counted through undo, redo and saves between") {
    const Folder folder;
    Document document = opened(folder);
    const auto kick_by = [&](double how) { REQUIRE_FALSE(document.edit(change(document, "pop", "kick", how), "Kick")); };
    CHECK(document.unsaved_steps() == 0);
    for (const double how : {1.0, 2.0, 3.0}) kick_by(how);
    CHECK(document.unsaved_steps() == 3);
    document.undo();
    CHECK(document.unsaved_steps() == 2);
    document.redo();
    REQUIRE(document.save());
    CHECK(document.unsaved_steps() == 0);
    document.undo();
    document.undo();
    CHECK(document.unsaved_steps() == 2);
    kick_by(4);
    CHECK(document.unsaved_steps() == 3);  // two back, one another way
    document.undo();
    CHECK(document.unsaved_steps() == 2);
    kick_by(3);  // the text of the disk again
    CHECK_FALSE(document.dirty());
    CHECK(document.unsaved_steps() == 0);
    kick_by(5);
    CHECK(document.unsaved_steps() == 1);
}

TEST_CASE("steps that become one count as one, also around a save between them") {
    const Folder folder;
    Document document = opened(folder);
    const auto kick_by = [&](double how) { REQUIRE_FALSE(document.edit(change(document, "pop", "kick", how), "Kick")); };
    kick_by(1);
    kick_by(2);
    document.join_steps();
    CHECK(document.unsaved_steps() == 1);
    kick_by(3);
    REQUIRE(document.save());
    kick_by(4);
    document.join_steps();  // the saved text is in the middle of that step
    CHECK(document.dirty());
    CHECK(document.unsaved_steps() == 1);
    REQUIRE(document.save());
    kick_by(5);
    kick_by(6);
    REQUIRE(document.save());
    document.join_steps();
    CHECK(document.unsaved_steps() == 0);
    kick_by(7);
    CHECK(document.unsaved_steps() == 1);
}

TEST_CASE("work left behind is offered with its edits, its last step, its age and its lines") {
    const Folder folder;
    folder.write("table.yaml", pen);
    leave_work(folder);
    const AppState state = keeping_state(folder);
    REQUIRE(state.recovery);
    CHECK_FALSE(state.recovery->file_changed);
    CHECK(summary(*state.recovery, state.recovery->orphan.work.time + 130) ==
          "table.yaml: 3 edits since the last save, 2 minutes ago; the last one: Kick 3.");
    CHECK(state.recovery->diff.added == 1);
    CHECK(state.recovery->diff.removed == 1);
    CHECK(state.document.source().text() == pen);
    CHECK(enabled(state, "recover.restore"));
    CHECK_FALSE(enabled(state, "file.save"));
}

TEST_CASE("restored work is one step over the file, is unsaved, and is kept anew") {
    const Folder folder;
    folder.write("table.yaml", pen);
    const std::string work = leave_work(folder);
    AppState state = keeping_state(folder);
    run(state, "recover.restore");
    CHECK_FALSE(state.recovery);
    CHECK(state.document.source().text() == work);
    CHECK(folder.read("table.yaml") == pen);
    CHECK(state.document.dirty());
    CHECK(state.document.undo_steps() == 1);
    CHECK(state.document.unsaved_steps() == 3);
    CHECK(journals_in(folder) == 1);  // its own: the orphan is gone
    CHECK(find_orphans(folder.file("journals")).found.empty());
    advance(state, 1);
    run(state, "edit.undo");
    advance(state, 1);
    CHECK(state.document.source().text() == pen);
    CHECK(journals_in(folder) == 0);
    run(state, "edit.redo");
    run(state, "file.save");
    CHECK(folder.read("table.yaml") == work);
}

TEST_CASE("restored work that cannot be kept anew stays where it was found") {
    const Folder folder;
    folder.write("table.yaml", pen);
    const std::string work = leave_work(folder);
    AppState state = keeping_state(folder);
    state.keeper.emplace(folder.write("in_the_way", "a file"));
    run(state, "recover.restore");
    CHECK(state.document.source().text() == work);
    CHECK_THAT(state.message, Catch::Contains("not protected"));
    CHECK(find_orphans(folder.file("journals")).found.size() == 1);
}

TEST_CASE("whoever dies between a save and the end of the journal leaves the same text in both") {
    const Folder folder;
    folder.write("table.yaml", pen);
    {
        AppState state = keeping_state(folder);
        kick(state, 1);
        REQUIRE(edit(state, change(state.document, "pop", "kick", 2.0), "Kick"));
        run(state, "file.save");
        CHECK(read_journal(bytes_of(state.keeper->path())).work.text == folder.read("table.yaml"));
    }
    CHECK_FALSE(keeping_state(folder).recovery);
    CHECK(journals_in(folder) == 0);
}

TEST_CASE("discarded work is gone, work put off is offered again") {
    const Folder folder;
    folder.write("table.yaml", pen);
    leave_work(folder);
    for (int i = 0; i < 2; ++i) {
        AppState state = keeping_state(folder);
        REQUIRE(state.recovery);
        run(state, "recover.later");
        CHECK_FALSE(state.recovery);
        CHECK_FALSE(state.document.dirty());
    }
    AppState state = keeping_state(folder);
    run(state, "recover.discard");
    CHECK_FALSE(state.recovery);
    CHECK(journals_in(folder) == 0);
    CHECK_FALSE(keeping_state(folder).recovery);
}

TEST_CASE("a file that changed since is named so, and restoring goes over what it holds now") {
    const Folder folder;
    folder.write("table.yaml", pen);
    const std::string work = leave_work(folder);
    folder.write("table.yaml", pen + "# theirs\n");
    AppState state = keeping_state(folder);
    REQUIRE(state.recovery);
    CHECK(state.recovery->file_changed);
    CHECK(state.recovery->diff.removed == 2);  // theirs, and the kick
    run(state, "recover.restore");
    CHECK(state.document.source().text() == work);
    CHECK(folder.read("table.yaml") == pen + "# theirs\n");
    run(state, "edit.undo");
    CHECK(state.document.source().text() == pen + "# theirs\n");
}

TEST_CASE("work that was saved after all is not offered, and its journal goes") {
    const Folder folder;
    folder.write("table.yaml", pen);
    folder.write("table.yaml", leave_work(folder));
    CHECK_FALSE(keeping_state(folder).recovery);
    CHECK(journals_in(folder) == 0);
}

TEST_CASE("work of one table is offered with that table only, whatever its path is called") {
    const Folder folder;
    folder.write("table.yaml", pen);
    folder.write("other.yaml", pen);
    fs::create_symlink(folder.file("table.yaml"), folder.file("link.yaml"));
    leave_work(folder);
    AppState state(catalog(), untitled());
    keep_work(state, folder.file("journals"));
    CHECK_FALSE(state.recovery);
    open_file(state, folder.file("other.yaml"));
    CHECK_FALSE(state.recovery);
    open_file(state, folder.file("link.yaml"));
    CHECK(state.recovery);
}

TEST_CASE("work on another table is named, and left alone") {
    const Folder folder;
    folder.write("table.yaml", pen);
    leave_work(folder);
    AppState state(catalog(), untitled());
    keep_work(state, folder.file("journals"));
    CHECK_FALSE(state.recovery);
    CHECK_THAT(state.message, Catch::Contains("unsaved work on") && Catch::Contains("table.yaml"));
    CHECK(journals_in(folder) == 1);
}

TEST_CASE("an offer stands in nobody's way: the window can be closed, and the work is offered again") {
    const Folder folder;
    folder.write("table.yaml", pen);
    leave_work(folder);
    AppState state = keeping_state(folder);
    CHECK(enabled(state, "view.all"));
    run(state, "app.quit");
    CHECK(state.quit);
    CHECK(keeping_state(folder).recovery);
}

TEST_CASE("a file that changes while its work is on offer changes what is shown") {
    const Folder folder;
    folder.write("table.yaml", pen);
    leave_work(folder);
    AppState state = keeping_state(folder);
    REQUIRE(state.recovery->diff.removed == 1);
    folder.write("table.yaml", pen + "# theirs\n");
    look_at_disk(state);
    REQUIRE(state.recovery);
    CHECK(state.recovery->file_changed);
    CHECK(state.recovery->diff.removed == 2);
}

TEST_CASE("a journal that cannot be read is named and kept, and the table opens") {
    const Folder folder;
    folder.write("table.yaml", pen);
    leave_work(folder);
    const std::string journal = fs::directory_iterator(folder.file("journals"))->path().string();
    fs::resize_file(journal, 40);
    const AppState state = keeping_state(folder);
    CHECK_FALSE(state.recovery);
    CHECK(state.message_is_problem);
    CHECK_THAT(state.message, Catch::Contains(journal));
    CHECK(fs::file_size(journal) == 40);
    CHECK(state.document.source().text() == pen);
}

TEST_CASE("a file that is gone is told apart from edits") {
    const Folder folder;
    folder.write("table.yaml", pen);
    {
        AppState state = keeping_state(folder);
        fs::remove(folder.file("table.yaml"));
        for (int i = 0; i < 2; ++i) look_at_disk(state);
        advance(state, 1);
    }
    AppState state(catalog(), untitled());
    keep_work(state, folder.file("journals"));
    REQUIRE(state.recovery);
    CHECK(state.recovery->orphan.work.text == pen);
    CHECK(summary(*state.recovery, state.recovery->orphan.work.time) == "table.yaml: its file was gone, less than a minute ago.");
}

TEST_CASE("a new table's work, and that of a file that is gone, is offered with a new table") {
    const Folder folder;
    folder.write("table.yaml", pen);
    {
        AppState state(catalog(), untitled());
        keep_work(state, folder.file("journals"));
        kick(state, 3);
        CHECK(unsaved_work(state.document).table.empty());
    }
    leave_work(folder);
    fs::remove(folder.file("table.yaml"));
    AppState state(catalog(), untitled());
    keep_work(state, folder.file("journals"));
    REQUIRE(state.recovery);
    CHECK(state.more_to_recover.size() == 1);
    const bool gone_first = state.recovery->file_gone;
    run(state, "recover.later");
    REQUIRE(state.recovery);
    CHECK(state.recovery->file_gone != gone_first);
    if (!state.recovery->file_gone) run(state, "recover.later");
    else run(state, "recover.restore");
    CHECK_FALSE(state.recovery);
    CHECK(journals_in(folder) == 2);
}

TEST_CASE("editors that live are offered nothing of each other") {
    const Folder folder;
    folder.write("table.yaml", pen);
    AppState a = keeping_state(folder), b = keeping_state(folder);
    kick(a, 1);
    kick(b, 2);
    CHECK(journals_in(folder) == 2);
    CHECK_FALSE(keeping_state(folder).recovery);
}

TEST_CASE("a journal that cannot be kept is said once and never stops editing; it is tried again") {
    const Folder folder;
    const Document clean = opened(folder);
    folder.write("journals", "a file in the way");
    Document document = opened(folder);
    WorkKeeper keeper(folder.file("journals"));
    const auto kick_by = [&](double how) { REQUIRE_FALSE(document.edit(change(document, "pop", "kick", how), "Kick")); };
    CHECK_FALSE(keeper.follow(document, 0));
    kick_by(1);
    const std::optional<std::string> complaint = keeper.follow(document, 1);
    REQUIRE(complaint);
    CHECK_THAT(*complaint, Catch::Contains("not protected"));
    kick_by(2);
    for (const double now : {1.1, 3.0, 7.0, 13.0}) CHECK_FALSE(keeper.follow(document, now));
    CHECK_FALSE(keeper.sync());
    fs::remove(folder.file("journals"));
    CHECK_FALSE(keeper.follow(document, 14));  // not yet
    CHECK_FALSE(keeper.sync());
    CHECK_FALSE(keeper.follow(document, 19));
    CHECK(keeper.sync());
    CHECK(journals_in(folder) == 1);
    CHECK_FALSE(keeper.follow(clean, 20));
    CHECK(journals_in(folder) == 0);
}

TEST_CASE("without a folder for journals, or where nobody asked for them, editing goes on") {
    const Folder folder;
    AppState state = opened_state(folder);
    kick(state, 1);
    CHECK_FALSE(state.message_is_problem);
    keep_work(state, "");
    advance(state, 1);
    CHECK_THAT(state.message, Catch::Contains("HOME"));
    kick(state, 2);
    CHECK_FALSE(state.message_is_problem);
}

TEST_CASE("an edit is on disk before the next frame, a drag in progress is not yet one") {
    const Folder folder;
    folder.write("table.yaml", pen);
    AppState state = keeping_state(folder);
    REQUIRE_FALSE(state.document.preview(change(state.document, "pop", "kick", 3.0)));
    advance(state, 1);
    CHECK(journals_in(folder) == 0);
    REQUIRE_FALSE(state.document.commit("Kick"));
    advance(state, 1);
    REQUIRE(journals_in(folder) == 1);
    const std::string bytes = bytes_of(state.keeper->path());
    CHECK(read_journal(bytes).work.text == state.document.source().text());
    CHECK(read_journal(bytes).work.base == pen);
}

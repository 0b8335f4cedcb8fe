#include "editor/document.h"

#include <catch2/catch.hpp>

#include "editor/edit_tools.h"
#include "engine/io/same_content.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

TEST_CASE("a drag is one undo step and one changed line, and comments stay") {
    const Folder folder;
    Document document = opened(folder);
    REQUIRE(document.diagnostics().empty());
    const std::string before = document.source().text();
    for (int i = 1; i <= 20; ++i) {
        REQUIRE_FALSE(document.preview(change(document, "pop", "at", Vec2(0.25 + 0.001 * i, 0.70))));
        CHECK(document.source().text() == before);
        CHECK_FALSE(document.dirty());
    }
    REQUIRE_FALSE(document.commit("Move pop"));
    CHECK(document.dirty());
    CHECK(changed_lines(before, document.source().text()) == 1);
    CHECK_THAT(document.source().text(), Catch::Contains("# the middle one"));
    CHECK(document.scene().find("pop")->get<Vec2>("at").x() == 0.25 + 0.001 * 20);
    REQUIRE(*document.undo_label() == "Move pop");
    document.undo();
    CHECK_FALSE(document.can_undo());
    CHECK(document.source().text() == before);
}

TEST_CASE("undoing everything restores every byte, and doing it again every byte of that") {
    const Folder folder;
    // With a byte order mark and CRLF line ends, which no edit may touch.
    std::string text = "\xEF\xBB\xBF";
    for (const char c : pen) text += c == '\n' ? "\r\n" : std::string(1, c);
    Document document = opened(folder, text);
    REQUIRE(document.diagnostics().empty());
    REQUIRE_FALSE(document.edit(change(document, "pop", "radius", 0.031), "a"));
    REQUIRE_FALSE(document.edit(change(document, "pop", "id", std::string("bang")), "b"));
    REQUIRE_FALSE(document.edit(change(document, "bang", "threshold", 0.1), "c"));  // not in the text until now
    REQUIRE_FALSE(document.edit(change(document, "post", "at", Vec2(0.015, 0.02)), "d"));
    REQUIRE_FALSE(document.edit(change(document, "shelf", "size", Vec2(0.21, 0.02)), "e"));
    REQUIRE_FALSE(document.edit({document.scene().table().id, 0, std::string("Pen two"), true}, "f"));
    const std::string after = document.source().text();
    CHECK_THAT(after, Catch::Contains("radius: 31mm"));
    const NodeId post = id_of(document, "post");
    while (document.can_undo()) document.undo();
    CHECK(document.source().text() == text);
    CHECK_FALSE(document.dirty());
    while (document.can_redo()) document.redo();
    CHECK(document.source().text() == after);
    CHECK(id_of(document, "post") == post);
    CHECK(document.scene().find("bang")->get<double>("threshold") == 0.1);
    // What the scene holds is what the text says.
    REQUIRE(document.save());
    CHECK(same_content(document.scene(), Document::open(document.path(), catalog())->scene()));
}

TEST_CASE("nodes keep their ids when they are renamed, and back again") {
    const Folder folder;
    Document document = opened(folder);
    const NodeId corner = id_of(document, "corner"), post = id_of(document, "post");
    REQUIRE_FALSE(document.edit(change(document, "corner", "id", std::string("nook")), "Rename"));
    CHECK(id_of(document, "nook") == corner);
    CHECK(id_of(document, "post") == post);
    document.undo();
    CHECK(id_of(document, "corner") == corner);
    document.redo();
    CHECK(id_of(document, "nook") == corner);
}

TEST_CASE("nodes keep their ids through undo and redo when an outside change has taken a node away before them") {
    const Folder folder;
    Document document = opened(folder);
    const NodeId shelf = id_of(document, "shelf"), pop = id_of(document, "pop");
    std::string without = pen;
    const std::size_t begin = without.find("  - bumper");
    without.erase(begin, without.find('\n', begin) + 1 - begin);
    folder.write("table.yaml", without);
    REQUIRE(document.check_disk() == DiskState::reloaded);
    REQUIRE_FALSE(document.edit(change(document, "shelf", "at", Vec2(0.3, 0.3)), "Move shelf"));
    CHECK(id_of(document, "shelf") == shelf);
    document.undo();
    CHECK(id_of(document, "shelf") == shelf);
    document.redo();
    CHECK(id_of(document, "shelf") == shelf);
    document.undo();
    document.undo();  // the outside change too
    CHECK(document.source().text() == pen);
    CHECK(id_of(document, "pop") == pop);
    CHECK(id_of(document, "shelf") == shelf);
}

TEST_CASE("a preview that is taken back or ends where it began leaves no trace") {
    const Folder folder;
    Document document = opened(folder);
    const Vec2 at = document.scene().find("pop")->get<Vec2>("at");
    REQUIRE_FALSE(document.preview(change(document, "pop", "at", Vec2(0.1, 0.1))));
    CHECK(document.previewing());
    SECTION("by undo") { document.undo(); }
    SECTION("by cancelling") { document.cancel_preview(); }
    SECTION("by coming back") {
        REQUIRE_FALSE(document.preview(change(document, "pop", "at", at)));
        REQUIRE_FALSE(document.commit("Move pop"));
    }
    CHECK_FALSE(document.previewing());
    CHECK_FALSE(document.can_undo());
    CHECK_FALSE(document.dirty());
    CHECK(identical(document.scene().find("pop")->value("at"), Value(at)));
}

TEST_CASE("several fields previewed together are one undo step") {
    const Folder folder;
    Document document = opened(folder);
    REQUIRE_FALSE(document.preview(change(document, "pop", "at", Vec2(0.2, 0.6))));
    REQUIRE_FALSE(document.preview(change(document, "shelf", "at", Vec2(0.2, 0.35))));
    REQUIRE_FALSE(document.commit("Move both"));
    CHECK(changed_lines(pen, document.source().text()) == 2);
    document.undo();
    CHECK(document.source().text() == pen);
    CHECK_FALSE(document.can_undo());
}

TEST_CASE("an edit that a value's range forbids is refused and changes nothing") {
    const Folder folder;
    Document document = opened(folder);
    CHECK_THAT(*document.edit(change(document, "pop", "radius", -1.0), "Shrink"), Catch::Contains("radius must be above 0"));
    CHECK_THAT(*document.edit(change(document, "pop", "id", std::string("post")), "Rename"), Catch::Contains("taken"));
    CHECK(document.source().text() == pen);
    CHECK_FALSE(document.can_undo());
}

TEST_CASE("an edit whose text is shared through an anchor is refused with a reason, and the preview is taken back") {
    const Folder folder;
    std::string text = pen;
    text.replace(text.find("radius: 24mm"), 12, "radius: &r 24mm");
    text.replace(text.find("radius: 2mm"), 11, "radius: *r");
    Document document = opened(folder, text);
    REQUIRE_FALSE(has_errors(document.diagnostics()));
    REQUIRE_FALSE(document.preview(change(document, "nail", "radius", 0.003)));
    const auto why = document.commit("Change nail");
    REQUIRE(why);
    CHECK_FALSE(why->empty());
    CHECK(document.scene().find("nail")->get<double>("radius") == 0.024);
    CHECK(document.source().text() == text);
    CHECK_FALSE(document.previewing());
}

TEST_CASE("saving an untouched file leaves it byte for byte, and saving an edit changes one line of it") {
    const Folder folder;
    Document document = opened(folder);
    REQUIRE(document.save());
    CHECK(folder.read("table.yaml") == pen);
    REQUIRE_FALSE(document.edit(change(document, "pop", "at", Vec2(0.3, 0.71)), "Move pop"));
    REQUIRE(document.save());
    CHECK_FALSE(document.dirty());
    CHECK(folder.read("table.yaml") == document.source().text());
    CHECK(changed_lines(pen, folder.read("table.yaml")) == 1);
    document.undo();
    CHECK(document.dirty());
}

TEST_CASE("saving is refused when the file was changed outside") {
    const Folder folder;
    Document document = opened(folder);
    REQUIRE_FALSE(document.edit(change(document, "pop", "kick", 1.0), "Kick"));
    std::string theirs = pen;
    theirs.replace(theirs.find("kick: 0.8"), 9, "kick: 0.7");
    folder.write("table.yaml", theirs);
    CHECK_FALSE(document.save());
    CHECK(folder.read("table.yaml") == theirs);
    CHECK(document.check_disk() == DiskState::conflict);
    CHECK(document.dirty());
    SECTION("another name keeps both") {
        REQUIRE(document.save_as(folder.file("mine.yaml")));
        CHECK(folder.read("table.yaml") == theirs);
        CHECK(document.path() == folder.file("mine.yaml"));
        CHECK_FALSE(document.dirty());
        CHECK(document.check_disk() == DiskState::same);
    }
    SECTION("reloading takes theirs, and undo gives mine back") {
        const std::string mine = document.source().text();
        REQUIRE(document.reload());
        CHECK(document.source().text() == theirs);
        CHECK_FALSE(document.dirty());
        document.undo();
        CHECK(document.source().text() == mine);
        document.undo();
        CHECK(document.source().text() == pen);
        document.redo();
        document.redo();
        CHECK(document.source().text() == theirs);
    }
}

TEST_CASE("a clean document follows the disk, and its nodes keep their ids") {
    const Folder folder;
    Document document = opened(folder);
    const NodeId pop = id_of(document, "pop");
    CHECK(document.check_disk() == DiskState::same);
    std::string theirs = pen;
    theirs.replace(theirs.find("radius: 24mm"), 12, "radius: 40mm");
    folder.write("table.yaml", theirs);
    CHECK(document.check_disk() == DiskState::reloaded);
    CHECK(document.check_disk() == DiskState::same);
    CHECK_FALSE(document.dirty());
    CHECK(id_of(document, "pop") == pop);
    CHECK(document.scene().find("pop")->get<double>("radius") == 0.04);
    const auto changes = document.take_changes();
    REQUIRE(changes.size() == 1);
    CHECK(changes[0].everything);
}

TEST_CASE("a file broken outside leaves the last good table and reports the line, until it is mended") {
    const Folder folder;
    Document document = opened(folder);
    document.take_changes();
    std::string theirs = pen;
    theirs.replace(theirs.find("radius: 24mm"), 12, "radios: 24mm");
    folder.write("table.yaml", theirs);
    CHECK(document.check_disk() == DiskState::broken);
    CHECK(document.check_disk() == DiskState::broken);
    REQUIRE(has_errors(document.diagnostics()));
    CHECK(document.diagnosed().line_column(document.diagnostics()[0].where).line == 8);
    CHECK(document.scene().find("pop")->get<double>("radius") == 0.024);
    CHECK(document.take_changes().empty());
    SECTION("mended as it was") {
        folder.write("table.yaml", pen);
        CHECK(document.check_disk() == DiskState::same);
    }
    SECTION("mended otherwise") {
        folder.write("table.yaml", pen + "# mended\n");
        CHECK(document.check_disk() == DiskState::reloaded);
    }
    CHECK(document.diagnostics().empty());
    CHECK_FALSE(document.dirty());
}

TEST_CASE("a file with errors opens and says what is wrong") {
    const Folder folder;
    const Document document = opened(folder, "pinfield: 1\nscene:\n  - circle: {radius: 5 parsecs}\n");
    REQUIRE(has_errors(document.diagnostics()));
    CHECK(document.diagnosed().line_column(document.diagnostics()[0].where).line == 3);
}

TEST_CASE("a new table is whole and clean, and has no file to save to") {
    Document document = untitled();
    CHECK(document.diagnostics().empty());
    CHECK_FALSE(document.dirty());
    CHECK_FALSE(document.save());
    const Folder folder;
    REQUIRE(document.save_as(folder.file("new.yaml")));
    CHECK(folder.read("new.yaml") == document.source().text());
}

TEST_CASE("a file that is not there does not open") { CHECK_FALSE(Document::open("/nowhere/table.yaml", catalog())); }

TEST_CASE("an edit of shared text is asked about: everywhere or here only, one step each, or nothing") {
    const Folder folder;
    std::string text = pen;
    text.replace(text.find("radius: 24mm"), 12, "radius: &r 24mm");
    text.replace(text.find("radius: 2mm"), 11, "radius: *r");
    AppState state = opened_state(folder, text);
    const auto radius = [&](const char* node) { return state.document.scene().find(node)->get<double>("radius"); };
    CHECK_FALSE(edit(state, change(state.document, "nail", "radius", 0.03), "Change nail"));
    advance(state, 0);
    REQUIRE(state.shared);
    CHECK(state.shared->places == 2);
    CHECK(state.shared->anchor == "r");
    CHECK(state.document.source().text() == text);
    CHECK_FALSE(enabled(state, "file.save"));
    SECTION("everywhere") {
        run(state, "shared.everywhere");
        CHECK((radius("nail") == 0.03 && radius("pop") == 0.03));
    }
    SECTION("here") {
        run(state, "shared.here");
        CHECK((radius("nail") == 0.03 && radius("pop") == 0.024));
    }
    SECTION("not at all") {
        run(state, "shared.cancel");
        CHECK(state.document.source().text() == text);
        CHECK_FALSE(state.document.can_undo());
        return;
    }
    CHECK_FALSE(state.shared);
    CHECK(state.document.undo_steps() == 1);
    CHECK(changed_lines(text, state.document.source().text()) == 1);
    run(state, "edit.undo");
    CHECK(state.document.source().text() == text);
}

TEST_CASE("a slider shows its param while it is dragged, is one step when let go, and leaves no trace when taken back") {
    const std::string text =
        "pinfield: 1\n"
        "params:\n"
        "  gap: {value: 46mm, min: 40mm, max: 60mm}  # between lanes\n"
        "  count: 3\n"
        "scene:\n"
        "  - circle: {id: a, radius: gap / 2}\n"
        "  - circle: {id: b, radius: 1cm, copies: {count: count, step: [gap, 0]}}\n";
    const Folder folder;
    Document document = opened(folder, text);
    INFO((document.diagnostics().empty() ? "" : document.diagnostics().front().message));
    REQUIRE(document.diagnostics().empty());
    const NodeId a = id_of(document, "a");
    const auto radius = [&] { return document.scene().find("a")->get<double>("radius"); };
    document.take_changes();
    for (const double gap : {0.047, 0.05, 0.055}) {
        REQUIRE_FALSE(document.preview_param("gap", gap));
        CHECK(radius() == gap / 2);
        CHECK(document.source().text() == text);
        const std::vector<SceneChange> changes = document.take_changes();
        CHECK(std::none_of(changes.begin(), changes.end(), [](const SceneChange& change) { return change.everything; }));
        CHECK(std::any_of(changes.begin(), changes.end(), [&](const SceneChange& change) { return change.node == a; }));
    }
    CHECK(document.preview_param("gap", 0.07));  // more than it may be: it stays where it was
    CHECK(radius() == 0.055 / 2);
    document.cancel_preview();
    CHECK(radius() == 0.046 / 2);
    CHECK_FALSE(document.can_undo());

    REQUIRE_FALSE(document.preview_param("gap", 0.0525));
    REQUIRE_FALSE(document.commit("Change gap"));
    CHECK(document.source().text() == std::string(text).replace(text.find("46mm"), 4, "52.5mm"));
    CHECK(id_of(document, "a") == a);
    REQUIRE_FALSE(document.preview_param("count", 5));  // more nodes: the running table is made anew
    CHECK(document.scene().find("b.5"));
    REQUIRE_FALSE(document.commit("Change count"));
    document.undo();
    CHECK_FALSE(document.scene().find("b.5"));
    document.undo();
    CHECK(document.source().text() == text);
    CHECK(radius() == 0.046 / 2);
    document.redo();
    CHECK(radius() == 0.0525 / 2);
}

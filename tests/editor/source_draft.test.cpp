#include "editor/source_draft.h"

#include <catch2/catch.hpp>

#include "editor/session.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

/// The pen with its source under somebody's fingers.
struct Desk {
    explicit Desk(const std::string& text = pen) : document(opened(folder, text)) {}

    std::string shown() const { return draft.text(document)->text(); }
    std::string text() const { return document.source().text(); }
    /// Types in place of the first such words.
    void replace(const std::string& words, const std::string& by) {
        const std::size_t at = shown().find(words);
        REQUIRE(at != std::string::npos);
        draft.type(document, {{at, at + words.size()}, by});
    }
    void rest() { draft.pass(document, SourceDraft::pause); }
    double radius(std::string_view node = "pop") const { return document.scene().find(node)->get<double>("radius"); }

    Folder folder;
    Document document;
    SourceDraft draft;
};

std::string replaced(std::string text, const std::string& words, const std::string& by) {
    return text.replace(text.find(words), words.size(), by);
}

}  // namespace

TEST_CASE("typing that rests and reads becomes one step of the history; before that the table is as it was") {
    Desk desk;
    desk.replace("24mm", "3mm");
    CHECK(desk.draft.waiting());
    desk.draft.pass(desk.document, 0.5 * SourceDraft::pause);
    CHECK(desk.radius() == 0.024);
    desk.replace("3mm", "31mm");
    desk.draft.pass(desk.document, 0.6 * SourceDraft::pause);  // the rest begins anew with each key
    CHECK(desk.radius() == 0.024);
    desk.rest();
    CHECK(desk.radius() == 0.031);
    CHECK_FALSE(desk.draft.pending());
    CHECK(desk.text() == replaced(pen, "24mm", "31mm"));
    CHECK(desk.document.undo_steps() == 1);
    CHECK(*desk.document.undo_label() == "Edit source");
    desk.document.undo();
    CHECK(desk.text() == pen);
}

TEST_CASE("a text that does not read is kept, with what is wrong at its place, and the document is not touched") {
    Desk desk;
    desk.replace("bumper:", "bumpr:");
    desk.rest();
    CHECK(desk.draft.pending());
    CHECK_FALSE(desk.draft.waiting());
    CHECK(desk.text() == pen);
    CHECK(desk.document.undo_steps() == 0);
    REQUIRE(desk.draft.problems().size() == 1);
    const Diagnostic& problem = desk.draft.problems().front();
    CHECK(desk.draft.diagnosed().slice(problem.where) == "bumpr");
    CHECK_THAT(problem.hint, Catch::Contains("bumper"));
    desk.replace("bumpr", "bumper");  // as it was
    CHECK_FALSE(desk.draft.pending());
    CHECK(desk.draft.problems().empty());
    CHECK(desk.document.undo_steps() == 0);
}

TEST_CASE("typing that goes on joins its step; typing elsewhere, after a save or after something else does not") {
    Desk desk;
    for (const auto* digits : {"25mm", "26mm", "27mm"}) {
        const std::size_t at = desk.shown().find("mm, kick");
        desk.draft.type(desk.document, {{at - 2, at}, std::string(digits).substr(0, 2)});
        desk.rest();
    }
    CHECK(desk.document.undo_steps() == 1);
    desk.replace("10mm", "11mm");
    desk.rest();
    CHECK(desk.document.undo_steps() == 2);
    desk.document.undo();
    desk.document.redo();
    desk.replace("11mm", "12mm");
    desk.rest();
    CHECK(desk.document.undo_steps() == 2);
    CHECK(desk.document.save());
    desk.replace("12mm", "13mm");
    desk.rest();
    CHECK(desk.document.undo_steps() == 3);
    desk.document.undo();
    CHECK(desk.radius("post") == 0.012);
}

TEST_CASE("typing that comes back to where it began leaves no step") {
    Desk desk;
    desk.replace("24mm", "25mm");
    desk.rest();
    desk.replace("25mm", "24mm");
    desk.rest();
    CHECK(desk.text() == pen);
    CHECK(desk.document.undo_steps() == 0);
    CHECK_FALSE(desk.document.dirty());
}

TEST_CASE("a pending text has an undo of its own, which ends at the document's text") {
    Desk desk;
    desk.replace("radius: 24mm", "radius: 24m!");
    desk.replace("24m!", "24x!");
    desk.rest();
    const std::string latest = desk.shown();
    CHECK(desk.draft.undo(desk.document));
    CHECK(desk.shown() == replaced(pen, "24mm", "24m!"));
    CHECK(desk.draft.redo(desk.document));
    CHECK(desk.shown() == latest);
    CHECK_FALSE(desk.draft.redo(desk.document));
    CHECK(desk.draft.undo(desk.document));
    CHECK(desk.draft.undo(desk.document));
    CHECK_FALSE(desk.draft.pending());
    CHECK_FALSE(desk.draft.undo(desk.document));
    CHECK(desk.text() == pen);
}

TEST_CASE("characters typed without a rest are taken back together, others one by one") {
    Desk desk;
    const std::size_t at = desk.shown().find("24mm");
    for (std::size_t i = 0; i < 3; ++i) desk.draft.type(desk.document, {{at + i, at + i}, "x"});
    desk.rest();
    desk.draft.type(desk.document, {{at + 3, at + 3}, "y"});
    desk.draft.type(desk.document, {{at + 3, at + 4}, ""});
    CHECK(desk.draft.undo(desk.document));
    CHECK(desk.shown() == replaced(pen, "24mm", "xxxy24mm"));
    CHECK(desk.draft.undo(desk.document));
    CHECK(desk.shown() == replaced(pen, "24mm", "xxx24mm"));
    CHECK(desk.draft.redo(desk.document));
    CHECK(desk.draft.undo(desk.document));
    CHECK(desk.draft.undo(desk.document));
    CHECK_FALSE(desk.draft.pending());
}

TEST_CASE("what changes elsewhere meanwhile never takes a pending text away; tried again, both are had") {
    Desk desk;
    desk.replace("bumper:", "bumpr:");
    desk.rest();
    const std::string typed = desk.shown();
    REQUIRE_FALSE(desk.document.edit(change(desk.document, "post", "radius", 0.012), "Change radius"));
    CHECK(desk.draft.stale(desk.document));
    CHECK(desk.shown() == typed);
    desk.replace("bumpr:", "bumper:");  // reads now, but waits for its author's word
    desk.replace("kick: 0.8", "kick: 0.9");
    desk.rest();
    CHECK(desk.draft.pending());
    CHECK(desk.document.scene().find("pop")->get<double>("kick") == 0.8);
    desk.draft.try_again(desk.document);
    CHECK_FALSE(desk.draft.pending());
    CHECK(desk.text() == replaced(replaced(pen, "10mm", "12mm"), "kick: 0.8", "kick: 0.9"));
    CHECK(desk.document.undo_steps() == 2);
}

TEST_CASE("where both changed the same, the pending text is taken as it stands, and undo gives the other back") {
    Desk desk;
    desk.replace("24mm", "2x4mm");
    desk.rest();
    REQUIRE_FALSE(desk.document.edit(change(desk.document, "pop", "radius", 0.03), "Change radius"));
    const std::string other = desk.text();
    desk.draft.try_again(desk.document);
    CHECK(desk.draft.pending());
    CHECK_FALSE(desk.draft.stale(desk.document));
    CHECK(desk.shown() == replaced(pen, "24mm", "2x4mm"));
    desk.replace("2x4mm", "28mm");
    desk.rest();
    CHECK(desk.radius() == 0.028);
    desk.document.undo();
    CHECK(desk.text() == other);
}

TEST_CASE("a discarded text is gone, and the document's stands there") {
    Desk desk;
    desk.replace("24mm", "2x4mm");
    desk.rest();
    desk.document.undo();
    desk.draft.discard();
    CHECK(desk.shown() == pen);
    CHECK_FALSE(desk.draft.pending());
}

TEST_CASE("bytes that were not typed at stay: byte order mark, line breaks of two bytes, an end without one") {
    std::string text = "\xEF\xBB\xBF";
    for (const char c : pen) text += c == '\n' ? "\r\n" : std::string(1, c);
    text.resize(text.size() - 2);
    Desk desk(text);
    desk.replace("24mm", "25mm");
    desk.rest();
    CHECK(desk.text() == replaced(text, "24mm", "25mm"));
    desk.replace("  # the middle one", "");
    desk.rest();
    CHECK(desk.document.save());
    CHECK(desk.folder.read("table.yaml") == replaced(replaced(text, "24mm", "25mm"), "  # the middle one", ""));
}

TEST_CASE("a table that was opened broken is mended by typing") {
    Desk desk(replaced(pen, "bumper:", "bumpr:"));
    REQUIRE(has_errors(desk.document.diagnostics()));
    desk.replace("bumpr:", "bumper:");
    desk.rest();
    CHECK_FALSE(has_errors(desk.document.diagnostics()));
    CHECK(desk.text() == pen);
    CHECK(desk.radius() == 0.024);
}

TEST_CASE("balls roll on through what is typed, and only what changed is compiled") {
    Desk desk;
    Session session(desk.document);
    desk.document.take_changes();
    session.advance(120);
    const Vec2 before = session.world().balls().front().position;
    CHECK(length(before - Vec2(0.25, 0.90)) > 1e-3);
    desk.replace("# the walls", "# the four walls");
    desk.rest();
    const std::vector<SceneChange> comment = changes_between(desk.document.read(pen).scene, desk.document.scene());
    REQUIRE(comment.size() == 1);
    CHECK_FALSE(comment.front().everything);
    session.follow(desk.document);
    desk.replace("radius: 24mm", "radius: 26mm");
    desk.rest();
    std::vector<SceneChange> changes = desk.document.take_changes();
    REQUIRE(changes.size() == 1);
    CHECK_FALSE(changes.front().everything);
    CHECK(changes.front().node == id_of(desk.document, "pop"));
    desk.replace("  - spawn", "  - circle: {at: [0.4, 0.4], radius: 5mm}\n  - spawn");
    desk.rest();
    changes = desk.document.take_changes();
    REQUIRE(changes.size() == 1);
    CHECK(changes.front().everything);
    CHECK(length(session.world().balls().front().position - before) < 1e-12);
}

TEST_CASE("changes besides fields are never taken for fields") {
    const auto changed = [](const std::string& words, const std::string& by) {
        Desk desk;
        desk.replace(words, by);
        desk.rest();
        REQUIRE_FALSE(desk.draft.pending());
        return desk.document.take_changes().front().everything;
    };
    CHECK_FALSE(changed("restitution: 0.8", "restitution: 0.7"));
    CHECK_FALSE(changed("slope: 6.5", "slope: 7"));
    CHECK(changed("[Z, LeftShift]", "[X]"));
    CHECK(changed("circle: {id: nail, at: [0.03, 0.02], radius", "hexagon: {id: nail, at: [0.03, 0.02], apothem"));
    CHECK(changed("id: shelf", "id: rack"));
    CHECK(changed("  rubber: {", "  gum: {}\n  rubber: {"));
}

// A table of several files in the editor: played as one, edited in its own, read again when any of them changes.
#include <catch2/catch.hpp>

#include <filesystem>

#include "editor/structure_tools.h"
#include "engine/io/same_content.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

const std::string board = "pinfield: 1\nparams: {gap: 2cm}\nmaterials: {wood: {}}\nscene:\n  - circle: {id: disc, radius: gap}\ninputs: {left: Z}\n";
const std::string table =
    "pinfield: 1\ninclude: [board.yaml]\nscene:\n  - box: {id: shelf, size: [gap, 1cm], at: [0.2, 0.3], material: wood}\n  - flipper: {id: bat, input: left}\n";

struct Desk {
    Folder folder;
    Document document;

    explicit Desk(const std::string& text = table) : document(opened(folder, text)) {}

private:
    static Document opened(const Folder& folder, const std::string& text) {
        folder.write("board.yaml", board);
        return *Document::open(folder.write("table.yaml", text), catalog());
    }
};

SetField setting(const Document& document, const char* id, const char* key, const Value& value) {
    const Node& node = *document.scene().find(id);
    return {node.id, *node.type->find_field(key), value, true};
}

std::string with(std::string text, const std::string& from, const std::string& to) { return text.replace(text.find(from), from.size(), to); }

}  // namespace

TEST_CASE("an edit beside what is included changes the table's own text; one of what is included is refused with its place") {
    Desk desk;
    Document& document = desk.document;
    REQUIRE(document.diagnostics().empty());
    CHECK_FALSE(document.edit(setting(document, "shelf", "at", Vec2(0.25, 0.3)), "Move shelf"));
    CHECK(document.source().text() == with(table, "[0.2, 0.3]", "[0.25, 0.3]"));
    CHECK(document.scene().find("disc")->get<double>("radius") == 0.02);
    const std::string there = desk.folder.file("board.yaml");
    CHECK(document.edit(setting(document, "disc", "radius", 0.03), "Change disc") == "disc stands in " + there + ":5: change it there");
    CHECK(document.edit(setting(document, "shelf", "at", Vec2(0.2, 0.3)), "Move shelf") == std::nullopt);
    const NodeId wood = document.scene().materials().front();
    CHECK(document.edit(SetField{wood, 0, 0.5, true}, "Change wood") == "materials/wood stands in " + there + ":3: change it there");
    CHECK(document.preview_param("gap", 0.03) == "gap stands in " + there + ":2: change it there");
    const Edit keys = SetKeys{0, {"X"}}, remove = Remove{document.scene().find("disc")->id};
    CHECK(document.edit(std::span(&keys, 1), "Change left") == "left stands in " + there + ":6: change it there");
    CHECK(document.edit(std::span(&remove, 1), "Delete disc") == "disc stands in " + there + ":5: change it there");
    CHECK(desk.folder.read("board.yaml") == board);
    document.undo();
    CHECK(document.scene().find("disc"));
}

TEST_CASE("when a file that is included changes, the table is read with it, whether or not it is edited") {
    Desk desk;
    Document& document = desk.document;
    CHECK(document.check_disk() == DiskState::same);
    const NodeId shelf = document.scene().find("shelf")->id;
    if (GENERATE(false, true)) REQUIRE_FALSE(document.edit(setting(document, "shelf", "at", Vec2(0.25, 0.3)), "Move shelf"));
    const bool dirty = document.dirty();
    const std::size_t steps = document.undo_steps();
    document.take_changes();
    desk.folder.write("board.yaml", with(board, "2cm", "3cm"));
    CHECK(document.check_disk() == DiskState::reloaded);
    CHECK(document.check_disk() == DiskState::same);
    CHECK(document.scene().find("disc")->get<double>("radius") == 0.03);
    CHECK(document.scene().find("shelf")->id == shelf);
    CHECK(document.dirty() == dirty);
    CHECK(document.undo_steps() == steps);
    const auto changes = document.take_changes();
    CHECK(std::any_of(changes.begin(), changes.end(), [](const SceneChange& change) { return change.everything; }));
    while (document.can_undo()) document.undo();
    CHECK(document.source().text() == table);
    CHECK(document.scene().find("disc")->get<double>("radius") == 0.03);
}

TEST_CASE("an undo of what came before a node was added to an included file keeps that node") {
    Desk desk;
    Document& document = desk.document;
    REQUIRE_FALSE(document.edit(setting(document, "shelf", "at", Vec2(0.25, 0.3)), "Move shelf"));
    desk.folder.write("board.yaml", with(board, "scene:\n", "scene:\n  - circle: {id: second, radius: 1cm}\n"));
    REQUIRE(document.check_disk() == DiskState::reloaded);
    document.undo();
    CHECK(document.source().text() == table);
    CHECK(document.scene().find("second"));
    document.redo();
    CHECK(document.scene().find("shelf")->get<Vec2>("at") == Vec2(0.25, 0.3));
}

TEST_CASE("an included file that is broken or gone leaves the last good table and says so, until it is back") {
    Desk desk;
    Document& document = desk.document;
    if (GENERATE(false, true)) desk.folder.write("board.yaml", with(board, "radius", "radios"));
    else std::filesystem::remove(desk.folder.file("board.yaml"));
    CHECK(document.check_disk() == DiskState::broken);
    CHECK(document.check_disk() == DiskState::broken);
    CHECK(has_errors(document.diagnostics()));
    CHECK(document.scene().find("disc")->get<double>("radius") == 0.02);
    CHECK_FALSE(document.edit(setting(document, "shelf", "at", Vec2(0.25, 0.3)), "Move shelf"));
    desk.folder.write("board.yaml", board);
    CHECK(document.check_disk() == DiskState::same);
    CHECK(document.diagnostics().empty());
}

TEST_CASE("a table that was opened without a file it includes takes it when it comes") {
    Desk desk(with(table, "[board.yaml]", "[board.yaml, late.yaml]"));
    Document& document = desk.document;
    CHECK(has_errors(document.diagnostics()));
    CHECK(document.check_disk() == DiskState::same);
    desk.folder.write("late.yaml", "pinfield: 1\nscene: [circle: {id: late, at: [0.4, 0.4]}]\n");
    CHECK(document.check_disk() == DiskState::reloaded);
    CHECK(document.diagnostics().empty());
    CHECK(document.scene().find("late"));
    CHECK(document.files().size() == 3);
}

TEST_CASE("what is included is copied as its file has it, and pasted behind all that is included") {
    Desk desk;
    Document& document = desk.document;
    const NodeId disc = document.scene().find("disc")->id;
    const std::vector<NodeId> chosen{disc};
    const Result<std::string> text = copied_text(document, chosen);
    REQUIRE(text);
    CHECK(*text == "- circle: {id: disc, radius: gap}\n");
    CHECK_FALSE(duplicate_nodes(document, chosen, Vec2(0, 0)).refusal);  // the copy is the table's own, and calls the same param
    CHECK_THAT(document.source().text(), Catch::Contains("- circle: {id: disc_2, radius: gap}"));
    document.undo();
    const Outcome pasted = paste_text(document, "- circle: {id: other, radius: 1cm}\n", spot_after(document.scene(), chosen), {});
    CHECK_FALSE(pasted.refusal);
    CHECK(document.scene().roots()[1] == document.scene().find("other")->id);
    CHECK_THAT(document.source().text(), Catch::Contains("scene:\n  - circle: {id: other, radius: 1cm}\n  - box: {id: shelf"));
    CHECK(desk.folder.read("board.yaml") == board);
}

TEST_CASE("a new table has no folder until it is saved") {
    const Folder folder;
    folder.write("board.yaml", board);
    Document document = Document::untitled(catalog(), table);
    CHECK(has_errors(document.diagnostics()));
    REQUIRE(document.save_as(folder.file("table.yaml")));
    CHECK(document.diagnostics().empty());
    CHECK(document.scene().find("disc"));
}

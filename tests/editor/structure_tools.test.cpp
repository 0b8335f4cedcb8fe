// Adding, deleting, copying, wrapping: each one step of the history, in the author's text, and taken back byte for byte.
#include "editor/structure_tools.h"

#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

Vec2 place_of(const Document& document, NodeId node) { return world_from_local(document.scene(), node).offset; }

std::vector<NodeId> ids_of(const Document& document, std::initializer_list<std::string_view> paths) {
    std::vector<NodeId> out;
    for (const std::string_view path : paths) out.push_back(id_of(document, path));
    return out;
}

void take_all_back(Document& document, const std::string& text) {
    while (document.can_undo()) document.undo();
    CHECK(document.source().text() == text);
}

}  // namespace

TEST_CASE("deleting takes nodes out with their lines, as one step that undo takes back") {
    const Folder folder;
    AppState state = opened_state(folder);
    const NodeId pop = id_of(state.document, "pop");
    state.selection = Selection(ids_of(state.document, {"shelf", "pop", "post"}));
    run(state, "edit.delete");
    CHECK(state.message == "Delete 3 nodes");
    CHECK(state.selection.empty());
    CHECK(state.document.undo_steps() == 1);
    CHECK(state.document.source().text().find("the middle one") == std::string::npos);
    advance(state, 10);
    CHECK(state.session.problems().empty());
    run(state, "edit.undo");
    CHECK(state.document.source().text() == pen);
    CHECK(id_of(state.document, "pop") == pop);
}

TEST_CASE("a duplicate has a name of its own, lies beside, and keeps the comment") {
    const Folder folder;
    AppState state = opened_state(folder);
    state.selection.set(id_of(state.document, "pop"));
    run(state, "edit.duplicate");
    REQUIRE(id_of(state.document, "pop_2"));
    CHECK(state.selection.primary() == id_of(state.document, "pop_2"));
    CHECK(place_of(state.document, state.selection.primary()) == Vec2(0.27, 0.68));
    CHECK(state.document.source().text().find(
              "  - bumper: {id: pop_2, at: [0.27, 0.68], radius: 24mm, kick: 0.8, material: rubber}  # the middle one\n") != std::string::npos);
    run(state, "edit.duplicate");
    CHECK(id_of(state.document, "pop_3"));
    advance(state, 10);
    CHECK(state.session.problems().empty());
    take_all_back(state.document, pen);
}

TEST_CASE("what is copied is YAML that can be pasted elsewhere; what does not read says where") {
    const Folder folder;
    AppState state = opened_state(folder);
    state.selection.set(id_of(state.document, "corner"));
    run(state, "edit.copy");
    CHECK(state.clipboard.starts_with("- group:\n    id: corner\n    at: [0.1, 0.1]\n"));
    CHECK(state.clipboard.find("# inside the group") != std::string::npos);
    run(state, "edit.paste_in_place");
    REQUIRE(id_of(state.document, "corner_2"));
    CHECK(id_of(state.document, "post_2"));
    CHECK(place_of(state.document, id_of(state.document, "post_2")) == place_of(state.document, id_of(state.document, "post")));
    state.clipboard = "circle: {radius: 1cm, colour: red}";
    run(state, "edit.paste");
    CHECK(state.message.starts_with("The text cannot be pasted: line 1, column"));
    CHECK(state.message_is_problem);
    take_all_back(state.document, pen);
}

TEST_CASE("nodes of several parents go into an operator and come out of it, and stay where they are in the world") {
    const Folder folder;
    Document document = opened(folder);
    const NodeId post = id_of(document, "post"), shelf = id_of(document, "shelf");
    const Vec2 post_place = place_of(document, post), shelf_place = place_of(document, shelf);
    const Outcome in = wrap_nodes(document, ids_of(document, {"post", "shelf"}), *catalog()->find("union"));
    INFO(in.refusal.value_or("") << document.source().text());
    REQUIRE_FALSE(in.refusal);
    CHECK(document.scene().find(shelf)->parent == in.nodes.front());
    CHECK(document.scene().find(post)->parent == in.nodes.front());
    CHECK(length(place_of(document, post) - post_place) < 1e-9);
    CHECK(length(place_of(document, shelf) - shelf_place) < 1e-9);
    const Outcome out = unwrap_nodes(document, in.nodes);
    REQUIRE_FALSE(out.refusal);
    CHECK(out.nodes.size() == 2);
    CHECK(length(place_of(document, post) - post_place) < 1e-9);
    const Outcome corner = unwrap_nodes(document, ids_of(document, {"corner"}));
    INFO(corner.refusal.value_or(""));
    REQUIRE_FALSE(corner.refusal);
    CHECK(place_of(document, id_of(document, "nail")) == Vec2(0.06, 0.16));
    take_all_back(document, pen);
}

TEST_CASE("an edit that changes nothing leaves no step") {
    const Folder folder;
    Document document = opened(folder);
    const NodeId pop = id_of(document, "pop");
    const Edit same[] = {Rename{pop, "pop", "pop", true}, Move{pop, {}, document.scene().index_of(pop)}};
    for (const Edit& edit : same) {
        CHECK_FALSE(document.edit(std::span(&edit, 1), "nothing"));
        CHECK(document.undo_steps() == 0);
        CHECK(document.take_changes().empty());
        CHECK(document.source().text() == pen);
    }
}

TEST_CASE("every type of node can be added to a table, one step each") {
    const Folder folder;
    for (const NodeType& type : catalog()->types()) {
        if (type.meta.kind == NodeKind::record || type.key() == "domain") continue;
        INFO(type.key());
        AppState state = opened_state(folder);
        add_node(state, type);
        INFO(state.message);
        CHECK_FALSE(state.message_is_problem);
        CHECK(state.document.undo_steps() == 1);
        REQUIRE(state.selection.nodes().size() == 1);
        CHECK(state.document.scene().find(state.selection.primary())->type->key() == type.key());
        run(state, "edit.undo");
        CHECK(state.document.source().text() == pen);
    }
}

TEST_CASE("a node moves up and down among its neighbours, and is renamed with all that refers to it") {
    const Folder folder;
    AppState state = opened_state(folder);
    state.selection.set(id_of(state.document, "pop"));
    const int index = state.document.scene().index_of(state.selection.primary());
    run(state, "edit.move_down");
    CHECK(state.document.scene().index_of(state.selection.primary()) == index + 1);
    run(state, "edit.move_up");
    CHECK(state.document.scene().index_of(state.selection.primary()) == index);
    CHECK_FALSE(rename_node(state.document, state.selection.primary(), "thumper").refusal);
    CHECK(id_of(state.document, "thumper") == state.selection.primary());
    CHECK(rename_node(state.document, state.selection.primary(), "bat").refusal == "the id bat is taken");
    take_all_back(state.document, pen);
}

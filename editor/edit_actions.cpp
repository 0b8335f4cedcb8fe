// The actions of the Edit and Select menus: what they do to the selection and to the document.
#include <fmt/format.h>

#include <functional>
#include <utility>

#include "editor/edit_tools.h"
#include "editor/handlers.h"
#include "editor/handles.h"
#include "editor/structure_tools.h"
#include "engine/core/at.h"
#include "engine/core/numbers.h"

namespace pinfield::editor {
namespace {

/// Of a polygon or path one point, where one was clicked; else the selected nodes.
void delete_selection(AppState& state) {
    const std::optional<PickedPoint> point = std::exchange(state.point, std::nullopt);
    if (point && state.selection.primary() == point->node && state.selection.nodes().size() == 1) {
        const std::optional<SetField> fewer = without_point(state.document.scene(), point->node, point->field, point->component);
        if (fewer) edit(state, *fewer, fmt::format("Delete a point of {}", state.document.scene().path(point->node)));
        else say(state, "the node needs this point: select the node alone to delete it", true);
        return;
    }
    take(state, remove_nodes(state.document, state.selection.nodes()));
}

/// Copies lie a little beside what they were made of, so that both are seen.
constexpr double beside = 0.02;  // metres

void duplicate(AppState& state) {
    take(state, duplicate_nodes(state.document, state.selection.nodes(), {beside, -beside}));
}

bool copy(AppState& state) {
    Result<std::string> text = copied_text(state.document, state.selection.nodes());
    if (!text) return say(state, text.error().message, true), false;
    state.clipboard = std::move(*text);
    if (state.give_clipboard) state.give_clipboard(state.clipboard);
    say(state, "Copied");
    return true;
}

void cut(AppState& state) {
    if (copy(state)) take(state, remove_nodes(state.document, state.selection.nodes()));
}

/// `centre`: where the middle of it goes; none: where the text says.
void paste(AppState& state, const std::optional<Vec2>& centre) {
    if (state.ask_clipboard) state.clipboard = state.ask_clipboard();
    const Spot spot = spot_after(state.document.scene(), state.selection.nodes());
    take(state, paste_text(state.document, state.clipboard, spot, centre));
}

void select_all(AppState& state) { select(state, state.document.scene().roots()); }

void group(AppState& state) { wrap_selection(state, *state.catalog->find("group")); }
void unwrap(AppState& state) { take(state, unwrap_nodes(state.document, state.selection.nodes())); }

/// One place up or down among its siblings.
void shift_selection(AppState& state, int by) {
    const Scene& scene = state.document.scene();
    const std::vector<NodeId> chosen = outermost(scene, state.selection.nodes());
    if (chosen.size() != 1) return say(state, "Select one node to move it", true);
    const int index = scene.index_of(chosen[0]) + by;
    if (index < 0 || index >= static_cast<int>(scene.siblings(chosen[0]).size())) return;
    take(state, move_nodes(state.document, chosen, {scene.find(chosen[0])->parent, index + (by > 0 ? 1 : 0)}, true));
}

/// By the grid of the table's frame. Nudges that follow each other are one step, made anew from where the first began: there and back leaves
/// the author's spelling.
void nudge(AppState& state, const Vec2& steps) {
    Document& document = state.document;
    const auto text = [&] { return document.scene().sources.shared_main(); };
    const std::vector<NodeId> chosen = outermost(document.scene(), state.selection.nodes());
    const double grid = state.preferences.grid > 0 ? state.preferences.grid : default_grid;
    const bool goes_on = document.can_undo() && !document.can_redo() && state.nudge.left == text() && state.nudge.nodes == chosen && state.nudge.grid == grid;
    const Vec2 all_steps = goes_on ? Vec2(state.nudge.steps + steps) : steps;
    if (goes_on) document.undo();
    if (const auto why = move_by(document, chosen, grid * all_steps, grid)) {
        if (goes_on) document.redo();
        return say(state, *why, true);
    }
    state.nudge = {chosen, all_steps, grid, text()};
    say(state, move_label(document.scene(), chosen));
}

void select_parent(AppState& state) {
    const Node* node = state.document.scene().find(state.selection.primary());
    if (node && node->parent) select(state, node->parent);
}

void select_child(AppState& state) {
    const Node* node = state.document.scene().find(state.selection.primary());
    if (node && !node->children.empty()) select(state, node->children.front());
}

void select_sibling(AppState& state, int by) {
    const Scene& scene = state.document.scene();
    const Node* node = scene.find(state.selection.primary());
    if (!node || node->is_record()) return;
    const auto& siblings = scene.siblings(node->id);
    const int count = static_cast<int>(siblings.size());
    select(state, at(siblings, (scene.index_of(node->id) + by + count) % count));
}

void select_where(AppState& state, const std::function<bool(const Node&)>& wanted) {
    std::vector<NodeId> nodes;
    for (const NodeId id : state.document.scene().all())
        if (const Node& node = *state.document.scene().find(id); !node.is_record() && wanted(node)) nodes.push_back(id);
    select(state, std::move(nodes));
}

/// The selected node of the table, or null, with a word about it, where that is a record or gone.
const Node* selected_node(AppState& state) {
    const Node* node = state.document.scene().find(state.selection.primary());
    if (node && !node->is_record()) return node;
    say(state, "Select a node of the table", true);
    return nullptr;
}

void select_same_type(AppState& state) {
    const Node* chosen = selected_node(state);
    if (!chosen) return;
    select_where(state, [type = chosen->type](const Node& node) { return node.type == type; });
}

void select_same_material(AppState& state) {
    const Node* chosen = selected_node(state);
    if (!chosen) return;
    select_where(state, [material = chosen->value("material")](const Node& node) { return identical(node.value("material"), material); });
}

const Node* chosen(const AppState& s) { return has_selection(s) ? s.document.scene().find(s.selection.primary()) : nullptr; }
bool has_parent(const AppState& s) { return chosen(s) && chosen(s)->parent; }
bool has_children(const AppState& s) { return chosen(s) && !chosen(s)->children.empty(); }

bool can_paste(const AppState& s) { return !s.document.previewing() && (!s.clipboard.empty() || s.ask_clipboard); }

}  // namespace

std::span<const Handler> edit_handlers() {
    static const Handler handlers[] = {
        {"edit.cut", has_selection, cut},
        {"edit.copy", has_selection, [](AppState& s) { copy(s); }},
        {"edit.paste", can_paste, [](AppState& s) { paste(s, s.pointer.value_or(s.view.centre)); }},
        {"edit.paste_in_place", can_paste, [](AppState& s) { paste(s, {}); }},
        {"edit.duplicate", has_selection, duplicate},
        {"edit.delete", has_selection, delete_selection},
        {"edit.select_all", always, select_all},
        {"edit.add_material", [](const AppState& s) { return !s.document.previewing(); }, [](AppState& s) { take(s, new_material(s.document)); }},
        {"edit.group", has_selection, group},
        {"edit.unwrap", has_children, unwrap},
        {"edit.rename", has_selection, [](AppState& s) { s.renaming = s.selection.primary(); }},
        {"edit.move_up", has_selection, [](AppState& s) { shift_selection(s, -1); }},
        {"edit.move_down", has_selection, [](AppState& s) { shift_selection(s, 1); }},
        {"edit.nudge_left", has_selection, [](AppState& s) { nudge(s, {-1, 0}); }},
        {"edit.nudge_right", has_selection, [](AppState& s) { nudge(s, {1, 0}); }},
        {"edit.nudge_up", has_selection, [](AppState& s) { nudge(s, {0, 1}); }},
        {"edit.nudge_down", has_selection, [](AppState& s) { nudge(s, {0, -1}); }},
        {"edit.nudge_far_left", has_selection, [](AppState& s) { nudge(s, {-10, 0}); }},
        {"edit.nudge_far_right", has_selection, [](AppState& s) { nudge(s, {10, 0}); }},
        {"edit.nudge_far_up", has_selection, [](AppState& s) { nudge(s, {0, 10}); }},
        {"edit.nudge_far_down", has_selection, [](AppState& s) { nudge(s, {0, -10}); }},
        {"select.parent", has_parent, select_parent},
        {"select.child", has_children, select_child},
        {"select.previous", has_selection, [](AppState& s) { select_sibling(s, -1); }},
        {"select.next", has_selection, [](AppState& s) { select_sibling(s, 1); }},
        {"select.same_type", has_selection, select_same_type},
        {"select.same_material", has_selection, select_same_material},
    };
    return handlers;
}

}  // namespace pinfield::editor

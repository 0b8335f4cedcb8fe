// Menus about nodes, wherever they open: what can be added, what the selection can be put into, what it can become.
#include <algorithm>

#include "editor/panels/ui.h"
#include "editor/widgets/widgets.h"

namespace pinfield::editor {
namespace {

/// Every node type of these kinds, by name.
std::vector<const NodeType*> types_of(const Catalog& catalog, NodeKind kind) {
    std::vector<const NodeType*> out;
    for (const NodeType& type : catalog.types())
        if (type.meta.kind == kind) out.push_back(&type);
    std::sort(out.begin(), out.end(), [](const NodeType* a, const NodeType* b) { return a->key() < b->key(); });
    return out;
}

/// A row of the menu for a node type, with its documentation; whether it was chosen.
bool type_item(const Theme& theme, const NodeType& type) {
    const bool chosen = ImGui::MenuItem(std::string(type.key()).c_str());
    tooltip(theme, type.meta.doc);
    return chosen;
}

/// The types that the selected node can become with what it holds.
void change_type_menu(AppState& state, const Theme& theme) {
    const Node* node = state.document.scene().find(state.selection.primary());
    if (!node || node->is_record() || !ImGui::BeginMenu("Change to")) return;
    const NodeId id = node->id;
    for (const NodeType* type : types_of(*state.catalog, node->type->meta.kind)) {
        if (type == state.document.scene().find(id)->type) continue;
        const Edit edit = retyped(state.document.scene(), id, *type);
        if (why_invalid(state.document.scene(), edit)) continue;
        if (!type_item(theme, *type)) continue;
        take(state, change_type(state.document, id, *type));
        break;
    }
    ImGui::EndMenu();
}

}  // namespace

void action_item(AppState& state, const Theme& theme, std::string_view name) {
    const Action& action = *find_action(name);
    std::string label(action.label);
    const std::string* step = action.name == "edit.undo"   ? state.document.undo_label()
                              : action.name == "edit.redo" ? state.document.redo_label()
                                                           : nullptr;
    if (step) label += ": " + *step;
    const std::string id = label + "##" + std::string(action.name), shortcut(action.shortcut);
    if (ImGui::MenuItem(id.c_str(), shortcut.c_str(), false, enabled(state, action.name))) run(state, action.name);
    tooltip(theme, action.doc);
}

void wrap_menu(AppState& state, const Theme& theme) {
    if (!ImGui::BeginMenu("Put the selection in", !state.selection.empty())) return;
    for (const NodeType* type : types_of(*state.catalog, NodeKind::operation))
        if (type_item(theme, *type)) wrap_selection(state, *type);
    ImGui::EndMenu();
}

void add_menu(AppState& state, const Theme& theme) {
    const std::pair<const char*, NodeKind> kinds[] = {
        {"Part", NodeKind::part}, {"Shape", NodeKind::shape}, {"Operator", NodeKind::operation}};
    for (const auto& [title, kind] : kinds) {
        if (!ImGui::BeginMenu(title)) continue;
        for (const NodeType* type : types_of(*state.catalog, kind))
            if (type_item(theme, *type)) add_node(state, *type);
        ImGui::EndMenu();
    }
}

void node_menu(AppState& state, Ui& ui) {
    const Theme& theme = ui.theme;
    if (ImGui::BeginMenu("Add")) {
        add_menu(state, theme);
        ImGui::EndMenu();
    }
    wrap_menu(state, theme);
    change_type_menu(state, theme);
    for (const std::string_view name : {"edit.group", "edit.unwrap", "edit.rename"}) action_item(state, theme, name);
    ImGui::Separator();
    for (const std::string_view name : {"edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.delete"}) action_item(state, theme, name);
    ImGui::Separator();
    for (const std::string_view name : {"select.parent", "select.same_type", "select.same_material", "view.frame"})
        action_item(state, theme, name);
}

}  // namespace pinfield::editor

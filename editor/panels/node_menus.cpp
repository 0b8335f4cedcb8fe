// Menus about nodes, wherever they open: what can be added, what the selection can be put into, what it can become.
#include "editor/panels/ui.h"
#include "editor/widgets/widgets.h"

namespace pinfield::editor {
namespace {

/// A row of the menu for a node type, with its documentation; whether it was chosen.
bool type_item(const Theme& theme, const NodeType& type) {
    const bool chosen = ImGui::MenuItem(std::string(type.key()).c_str());
    tooltip(theme, type.meta.doc);
    return chosen;
}

void change_type_menu(AppState& state, const Theme& theme) {
    const NodeId id = state.selection.primary();
    const Node* node = state.document.scene().find(id);
    if (!node || node->is_record() || !ImGui::BeginMenu("Change to")) return;
    for (const NodeType* type : types_for(state.document.scene(), *state.catalog, id)) {
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
    const bool can = enabled(state, action.name);
    if (!can) ImGui::PushStyleColor(ImGuiCol_Text, palette::faint);
    if (ImGui::MenuItem(id.c_str(), shortcut.c_str(), is_on(state, action.name), can)) run(state, action.name);
    if (!can) ImGui::PopStyleColor();
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
    for (const std::string_view name : {"edit.group", "edit.unwrap", "edit.write_out", "edit.make_template", "edit.rename"}) action_item(state, theme, name);
    ImGui::Separator();
    for (const std::string_view name : {"edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.delete"}) action_item(state, theme, name);
    ImGui::Separator();
    for (const std::string_view name : {"select.parent", "select.same_type", "select.same_material", "view.frame"})
        action_item(state, theme, name);
}

}  // namespace pinfield::editor

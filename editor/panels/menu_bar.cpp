#include <algorithm>

#include "editor/panels/ui.h"
#include "editor/widgets/widgets.h"

namespace pinfield::editor {

namespace {

std::vector<std::string_view> menus_in_order() {
    std::vector<std::string_view> menus;
    for (const Action& action : all_actions())
        if (!action.menu.empty() && std::find(menus.begin(), menus.end(), action.menu) == menus.end())
            menus.push_back(action.menu);
    return menus;
}

void menu_item(AppState& state, const Theme& theme, const Action& action) {
    std::string label(action.label);
    const std::string* step = action.name == "edit.undo"   ? state.document.undo_label()
                              : action.name == "edit.redo" ? state.document.redo_label()
                                                           : nullptr;
    if (step) label += ": " + *step;
    const std::string id = label + "##" + std::string(action.name), shortcut(action.shortcut);
    if (ImGui::MenuItem(id.c_str(), shortcut.c_str(), false, enabled(state, action.name))) run(state, action.name);
    tooltip(theme, action.doc);
}

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

/// What can be added to the table, and what the selection can be put into.
void add_menu(AppState& state, const Theme& theme) {
    const std::pair<const char*, NodeKind> kinds[] = {
        {"Part", NodeKind::part}, {"Shape", NodeKind::shape}, {"Operator", NodeKind::operation}};
    for (const auto& [title, kind] : kinds) {
        if (!ImGui::BeginMenu(title)) continue;
        for (const NodeType* type : types_of(*state.catalog, kind))
            if (type_item(theme, *type)) add_node(state, *type);
        ImGui::EndMenu();
    }
    ImGui::Separator();
    if (!ImGui::BeginMenu("Put the selection in", !state.selection.empty())) return;
    for (const NodeType* type : types_of(*state.catalog, NodeKind::operation))
        if (type_item(theme, *type)) wrap_selection(state, *type);
    ImGui::EndMenu();
}

/// File name and whether it has unsaved changes, in the middle of the bar.
void document_title(const AppState& state, const Theme& theme) {
    const std::string& path = state.document.path();
    const std::size_t slash = path.find_last_of('/');
    const std::string name = path.empty() ? "Untitled" : path.substr(slash == std::string::npos ? 0 : slash + 1);
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    const float x = 0.5f * (ImGui::GetIO().DisplaySize.x - width);
    if (x < ImGui::GetCursorPosX() + theme.px(20)) return;
    ImGui::SetCursorPosX(x);
    text_in(theme.body, palette::quiet, name);
    tooltip(theme, path.empty() ? "Not saved yet" : path);
    if (state.document.dirty()) {
        const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddCircleFilled({hi.x + theme.px(11), 0.5f * (lo.y + hi.y) + theme.px(1)}, theme.px(4),
                                                    ink(palette::amber));
    }
}

}  // namespace

float menu_bar(AppState& state, Ui& ui) {
    const Theme& theme = ui.theme;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(theme.px(8), theme.px(7)));
    float height = 0;
    if (ImGui::BeginMainMenuBar()) {
        height = ImGui::GetWindowSize().y;
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(8), theme.px(8)));
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(theme.px(12), theme.px(7)));
        for (const std::string_view menu : menus_in_order()) {
            if (ImGui::BeginMenu(std::string(menu).c_str())) {
                for (const Action& action : all_actions())
                    if (action.menu == menu) menu_item(state, theme, action);
                ImGui::EndMenu();
            }
            if (menu != "Edit" || !ImGui::BeginMenu("Add")) continue;
            add_menu(state, theme);
            ImGui::EndMenu();
        }
        ImGui::PopStyleVar(2);
        document_title(state, theme);
        ImGui::EndMainMenuBar();
    }
    ImGui::PopStyleVar();
    return height;
}

}  // namespace pinfield::editor

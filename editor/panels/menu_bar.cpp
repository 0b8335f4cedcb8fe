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

/// A click opens one, after asking about unsaved work.
void recent_menu(AppState& state, const Theme& theme) {
    if (!ImGui::BeginMenu("Open recent")) return;
    const std::vector<std::string> paths = state.recent.paths();
    if (paths.empty()) text_in(theme.body, palette::quiet, "No other table yet");
    for (const std::string& path : paths) {
        ImGui::PushID(path.c_str());
        const std::size_t slash = path.find_last_of('/');
        if (ImGui::MenuItem(path.substr(slash + 1).c_str())) open_file(state, path);
        tooltip(theme, path);
        ImGui::PopID();
    }
    ImGui::EndMenu();
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
                for (const Action& action : all_actions()) {
                    if (action.menu == menu) action_item(state, theme, action.name);
                    if (action.name == "file.open") recent_menu(state, theme);
                }
                ImGui::EndMenu();
            }
            if (menu != "Edit" || !ImGui::BeginMenu("Add")) continue;
            add_menu(state, theme);
            ImGui::Separator();
            wrap_menu(state, theme);
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

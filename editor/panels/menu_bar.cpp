#include <algorithm>
#include <utility>

#include "editor/panels/ui.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"

namespace pinfield::editor {

namespace {

constexpr std::string_view add_word = "Add";

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

void draw_menu(AppState& state, const Theme& theme, std::string_view menu) {
    for (const Action& action : all_actions()) {
        if (action.menu == menu) action_item(state, theme, action.name);
        if (action.name == "file.open" && action.menu == menu) recent_menu(state, theme);
    }
    if (menu != add_word) return;
    add_menu(state, theme);
    ImGui::Separator();
    wrap_menu(state, theme);
}

/// One after the other; by Left and Right, which Dear ImGui takes for a way out of the open one, to the next.
void draw_menus(AppState& state, Ui& ui) {
    std::vector<std::string_view> menus = menus_in_order();
    menus.insert(std::find(menus.begin(), menus.end(), "Edit") + 1, add_word);
    const int count = static_cast<int>(menus.size());
    const auto open = [&](int i) { ImGui::OpenPopup(std::string(at(menus, (i + count) % std::max(count, 1))).c_str()); };
    if (std::exchange(state.open_menus, false)) open(0);
    const int before = std::exchange(ui.open_menu, -1);
    for (int i = 0; i < count; ++i) {
        if (!ImGui::BeginMenu(std::string(at(menus, i)).c_str())) continue;
        ui.open_menu = i;
        draw_menu(state, ui.theme, at(menus, i));
        ImGui::EndMenu();
    }
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)) ? 1 : 0; };
    const int way = std::exchange(ui.menu_way, pressed(ImGuiKey_RightArrow) - pressed(ImGuiKey_LeftArrow));
    if (ui.open_menu < 0 && before >= 0 && way != 0) open(before + way);
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
        draw_menus(state, ui);
        ImGui::PopStyleVar(2);
        document_title(state, theme);
        ImGui::EndMainMenuBar();
    }
    ImGui::PopStyleVar();
    return height;
}

}  // namespace pinfield::editor

#include "editor/widgets/modal.h"

#include <imgui.h>

#include <algorithm>

#include "editor/widgets/widgets.h"
#include "engine/core/at.h"

namespace pinfield::editor {

bool begin_modal(const Theme& theme, const char* title, float width) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    ImGui::SetNextWindowPos({0.5f * window.x, 0.46f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(theme.px(width), 0.94f * window.x), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(20), theme.px(18)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    const bool open = ImGui::BeginPopupModal(
        title, nullptr,
        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar(3);
    return open;
}

void align_right(float width) { ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, ImGui::GetContentRegionAvail().x - width)); }

bool escape_pressed() { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false); }

std::string_view answered(const Theme& theme, std::span<const Answer> answers, int preferred, int& chosen, std::string_view on_escape) {
    const int count = static_cast<int>(answers.size());
    const bool appears = ImGui::IsWindowAppearing();
    if (appears) chosen = preferred;
    const auto pressed = [&](ImGuiKey key) { return !appears && ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); };
    const bool back = pressed(ImGuiKey_LeftArrow) || (pressed(ImGuiKey_Tab) && ImGui::GetIO().KeyShift);
    const bool on = pressed(ImGuiKey_RightArrow) || (pressed(ImGuiKey_Tab) && !ImGui::GetIO().KeyShift);
    chosen = (chosen + (on ? 1 : 0) + (back ? count - 1 : 0)) % count;

    const float gap = ImGui::GetStyle().ItemSpacing.x;
    align_right(static_cast<float>(count) * theme.px(92) + static_cast<float>(count - 1) * gap);
    std::string_view answer;
    for (int i = 0; i < count; ++i) {
        if (i > 0) ImGui::SameLine();
        if (dialog_button(theme, at(answers, i).label, i == preferred)) answer = at(answers, i).action;
        if (i != chosen) continue;
        const ImVec2 least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddRect({least.x - 2, least.y - 2}, {most.x + 2, most.y + 2}, ink(palette::accent),
                                            ImGui::GetStyle().FrameRounding + 2, 0, theme.px(1.5f));
    }
    if (pressed(ImGuiKey_Escape)) return on_escape;
    if (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter) || pressed(ImGuiKey_Space)) return at(answers, chosen).action;
    return answer;
}

}  // namespace pinfield::editor

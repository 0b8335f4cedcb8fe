// Asks where a value is to be written that does not stand at its node.
#include <fmt/format.h>

#include "editor/edit_tools.h"
#include "editor/panels/ui.h"
#include "editor/widgets/modal.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

/// A line for each place, with what else changes there; the number of the one that was clicked, or -1.
int places(const Theme& theme, const std::vector<ValueHome>& homes, int chosen) {
    int clicked = -1;
    for (int i = 0; i < static_cast<int>(homes.size()); ++i) {
        const ValueHome& home = at(homes, i);
        const ImVec2 place = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, theme.px(32)}, end{place.x + size.x, place.y + size.y};
        ImGui::PushID(i);
        if (ImGui::InvisibleButton("place", size)) clicked = i;
        const bool hot = ImGui::IsItemHovered();
        ImGui::PopID();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled(place, end, ink(hot ? palette::field_hot : palette::field), ImGui::GetStyle().FrameRounding);
        if (i == chosen) list.AddRect(place, end, ink(palette::accent), ImGui::GetStyle().FrameRounding, 0, theme.px(1.5f));
        const std::string others = home.values > 1 ? fmt::format("{} values", home.values) : "";
        const float y = place.y + 0.5f * (size.y - ImGui::GetFontSize()), pad = theme.px(12), width = ImGui::CalcTextSize(others.c_str()).x;
        list.AddText({place.x + pad, y}, ink(palette::text), fitted(home.told, size.x - width - 3 * pad).c_str());
        list.AddText({end.x - pad - width, y}, ink(palette::quiet), others.c_str());
    }
    return clicked;
}

}  // namespace

void home_dialog(AppState& state, Ui& ui) {
    if (!state.home || state.prompt || !state.dialog_action.empty()) return;
    const Theme& theme = ui.theme;
    if (!begin_modal(theme, "##home", 520)) return;
    const HomeQuestion question = *state.home;
    const int count = static_cast<int>(question.homes.size());
    const auto pressed = [](ImGuiKey key) { return !ImGui::IsWindowAppearing() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); };
    if (ImGui::IsWindowAppearing()) ui.answer = 0;
    ui.answer = (ui.answer + (pressed(ImGuiKey_DownArrow) || pressed(ImGuiKey_Tab) ? 1 : 0) + (pressed(ImGuiKey_UpArrow) ? count - 1 : 0)) % count;

    text_in(theme.large, palette::text, change_label(state.document.scene(), question.edit.node, question.edit.field) + ": where?");
    ImGui::PushTextWrapPos(0);
    text_in(theme.body, palette::quiet, "The value does not stand at the node itself. What is chosen holds until the table is closed.");
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, theme.px(4)});
    int answer = places(theme, question.homes, ui.answer);
    if (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter)) answer = ui.answer;
    ImGui::Dummy({0, theme.px(4)});
    align_right(theme.px(92));
    if (dialog_button(theme, "Cancel", false) || escape_pressed()) run(state, "home.cancel");
    else if (answer >= 0) run(state, fmt::format("home.{}", answer + 1));
    if (!state.home) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace pinfield::editor

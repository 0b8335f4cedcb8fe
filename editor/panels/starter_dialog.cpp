// File > New: which table to begin with.
#include <algorithm>
#include <cmath>
#include <memory>

#include "editor/panels/ui.h"
#include "editor/starters.h"
#include "editor/widgets/modal.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"
#include "engine/io/table_reader.h"

namespace pinfield::editor {
namespace {

const Picture& picture_for(const AppState& state, Ui& ui, const Starter& starter) {
    const auto [found, is_new] = ui.palette.pictures.try_emplace(action_of(starter));
    if (is_new)
        found->second = picture_of(read_table(std::make_shared<const SourceText>("", std::string(starter.text)), state.catalog).scene);
    return found->second;
}

/// A picture with its name; true when it was clicked.
bool card(const AppState& state, Ui& ui, const Starter& starter, ImVec2 size, bool chosen) {
    const Theme& theme = ui.theme;
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(action_of(starter).c_str(), size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(place, {place.x + size.x, place.y + size.y}, ink(ImGui::IsItemHovered() ? palette::field_hot : palette::field),
                       theme.px(6));
    if (chosen) list.AddRect(place, {place.x + size.x, place.y + size.y}, ink(palette::accent), theme.px(6), 0, theme.px(2));
    const float margin = theme.px(12), words = theme.px(30);
    draw_picture(list, picture_for(state, ui, starter), {place.x + margin, place.y + margin},
                 {size.x - 2 * margin, size.y - margin - words - theme.px(6)}, ink(chosen ? palette::accent : palette::quiet),
                 std::max(1.0f, theme.px(1.3f)));
    const std::string title(starter.title);
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    list.AddText({std::round(place.x + 0.5f * (size.x - width)), place.y + size.y - words}, ink(palette::text), title.c_str());
    return clicked;
}

}  // namespace

void starter_dialog(AppState& state, Ui& ui) {
    if (!state.choosing || state.prompt) return;
    const Theme& theme = ui.theme;
    if (!begin_modal(theme, "##starters", 640)) return;
    const int count = static_cast<int>(starters().size());
    const bool appears = ImGui::IsWindowAppearing();
    if (appears) ui.starter = 0;
    const auto pressed = [&](ImGuiKey key) { return !appears && ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    if (pressed(ImGuiKey_RightArrow)) ui.starter = (ui.starter + 1) % count;
    if (pressed(ImGuiKey_LeftArrow)) ui.starter = (ui.starter + count - 1) % count;
    text_in(theme.large, palette::text, "New table");
    ImGui::Dummy({0, theme.px(4)});
    const float gap = theme.px(10),
                width = (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
    std::string answer;
    for (int i = 0; i < count; ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        if (card(state, ui, at(starters(), i), {width, theme.px(220)}, i == ui.starter)) answer = action_of(at(starters(), i));
        if (ImGui::IsItemHovered()) ui.starter = i;
    }
    ImGui::Dummy({0, theme.px(2)});
    text_in(theme.body, palette::quiet, at(starters(), ui.starter).doc);
    align_right(theme.px(92));
    if (dialog_button(theme, "Cancel", false)) answer = "new.cancel";
    if (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter)) answer = action_of(at(starters(), ui.starter));
    if (escape_pressed() && !appears) answer = "new.cancel";
    if (!answer.empty()) run(state, answer);
    if (!state.choosing || state.prompt) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace pinfield::editor

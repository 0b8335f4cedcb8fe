// Edit > Preferences: every row is an action or a choice of some, so that scripts and the command palette do the same.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "editor/panels/ui.h"
#include "editor/widgets/modal.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

struct Choice {
    std::string_view action;
    const char* word;
};

/// One of several choices; or, of a single one, a switch.
struct Row {
    const char* label;
    std::vector<Choice> choices;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        {"Theme", {{"theme.dark", "Dark"}, {"theme.light", "Light"}}},
        {"Text", {{"font.smaller", "Smaller"}, {"font.usual", "Usual"}, {"font.larger", "Larger"}}},
        {"Grid",
         {{"grid.off", "None"}, {"grid.tenth", "0.1"}, {"grid.1mm", "1"}, {"grid.2mm", "2"}, {"grid.5mm", "5"}, {"grid.10mm", "10 mm"}}},
        {"Snap to others", {{"tool.snap", ""}}},
        {"Rulers", {{"view.rulers", ""}}},
        {"Guides", {{"view.guides", ""}}},
        {"Warnings of narrow gaps", {{"view.gaps", ""}}},
        {"Palette of nodes", {{"view.palette", ""}}},
        {"History", {{"view.history", ""}}},
        {"Source", {{"view.source", ""}}},
        {"Changes in the source", {{"view.changes", ""}}},
    };
    return all;
}

/// The row that arrows change is marked at its left edge.
void mark_row(const Theme& theme, ImVec2 place, float height) {
    ImGui::GetWindowDrawList()->AddRectFilled({place.x - theme.px(10), place.y}, {place.x - theme.px(7), place.y + height},
                                              ink(palette::accent), theme.px(1.5f));
}

/// A switch: its knob's place shows the state without any color. True when it was clicked.
bool switch_of(const Theme& theme, const char* id, bool on) {
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight(), w = theme.px(32), h = theme.px(18), r = 0.5f * h, top = place.y + 0.5f * (height - h);
    const bool clicked = ImGui::InvisibleButton(id, {w, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Tint off = ImGui::IsItemHovered() ? palette::field_active : palette::field_hot;
    list.AddRectFilled({place.x, top}, {place.x + w, top + h}, ink(on ? Tint(Role::primary) : off), r);
    list.AddCircleFilled({place.x + (on ? w - r : r), top + r}, r - theme.px(3), ink(on ? Tint(Role::on_primary) : palette::quiet));
    return clicked;
}

/// The action that was clicked, or none.
std::string_view draw_row(const AppState& state, const Theme& theme, const Row& row, bool marked, float column) {
    const ImVec2 place = ImGui::GetCursorScreenPos();
    if (marked) mark_row(theme, place, ImGui::GetFrameHeight());
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    text_in(theme.body, marked ? palette::text : palette::quiet, row.label);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + column);
    std::string_view action;
    if (row.choices.size() == 1) {
        if (switch_of(theme, row.label, is_on(state, row.choices.front().action))) action = row.choices.front().action;
        tooltip(theme, find_action(row.choices.front().action)->doc);
        return action;
    }
    for (const Choice& choice : row.choices) {
        const bool on = is_on(state, choice.action), can = enabled(state, choice.action);
        ImGui::PushStyleColor(ImGuiCol_Button, on ? palette::accent_deep : palette::field);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, on ? palette::accent_deep : palette::field_hot);
        ImGui::PushStyleColor(ImGuiCol_Text, can ? palette::text : palette::faint);
        if (ImGui::Button(choice.word) && can) action = choice.action;
        ImGui::PopStyleColor(3);
        tooltip(theme, find_action(choice.action)->doc);
        ImGui::SameLine(0, theme.px(4));
    }
    if (row.choices.front().action.starts_with("font."))
        text_in(theme.body, palette::quiet, fmt::format("  {:g}", state.preferences.font_size));
    else
        ImGui::NewLine();
    return action;
}

/// What Left (-1), Right (1) and Space (0) do to a row.
std::string_view stepped(const AppState& state, const Row& row, int by) {
    const int count = static_cast<int>(row.choices.size());
    if (count == 1) return row.choices.front().action;
    if (row.choices.front().action.starts_with("font."))
        return by < 0 ? row.choices.front().action : by > 0 ? row.choices.back().action : "font.usual";
    int now = 0;
    for (int i = 0; i < count; ++i)
        if (is_on(state, at(row.choices, i).action)) now = i;
    return at(row.choices, std::clamp(now + by, 0, count - 1)).action;
}

/// By the keys: the action they ask for, or none.
std::string_view keyed(const AppState& state, Ui& ui) {
    if (ImGui::IsWindowAppearing()) return {};
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    const int count = static_cast<int>(rows().size());
    const bool back = pressed(ImGuiKey_UpArrow) || (pressed(ImGuiKey_Tab) && ImGui::GetIO().KeyShift);
    const bool on = pressed(ImGuiKey_DownArrow) || (pressed(ImGuiKey_Tab) && !ImGui::GetIO().KeyShift);
    ui.preference = (ui.preference + (on ? 1 : 0) + (back ? count - 1 : 0)) % count;
    const Row& row = at(rows(), ui.preference);
    if (pressed(ImGuiKey_LeftArrow)) return stepped(state, row, -1);
    if (pressed(ImGuiKey_RightArrow)) return stepped(state, row, 1);
    if (pressed(ImGuiKey_Space)) return stepped(state, row, 0);
    return escape_pressed() || pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter) ? "preferences.close" : std::string_view();
}

}  // namespace

void preferences_dialog(AppState& state, Ui& ui) {
    if (!state.show_preferences || state.prompt) return;
    const Theme& theme = ui.theme;
    if (!begin_modal(theme, "##preferences", 560)) return;
    text_in(theme.large, palette::text, "Preferences");
    ImGui::Dummy({0, theme.px(4)});
    std::string_view action = keyed(state, ui);
    for (std::size_t i = 0; i < rows().size(); ++i) {
        const std::string_view clicked = draw_row(state, theme, rows()[i], static_cast<int>(i) == ui.preference, theme.px(180));
        if (clicked.empty()) continue;
        action = clicked;
        ui.preference = static_cast<int>(i);
    }
    ImGui::Dummy({0, theme.px(4)});
    constexpr const char* usual = "All as at first";
    align_right(theme.px(92) + ImGui::GetStyle().ItemSpacing.x + dialog_button_width(theme, usual));
    if (dialog_button(theme, usual, false)) action = "preferences.usual";
    ImGui::SameLine();
    if (dialog_button(theme, "Close", true)) action = "preferences.close";
    if (!action.empty() && enabled(state, action)) run(state, action);
    if (!state.show_preferences) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace pinfield::editor

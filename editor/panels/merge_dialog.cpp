// The question where the file and the table have changed the same: each value as it was, as it is here, and as the file has it.
#include <algorithm>
#include <array>

#include "editor/panels/ui.h"
#include "editor/widgets/modal.h"
#include "editor/widgets/widgets.h"

namespace pinfield::editor {
namespace {
/// Where columns begin.
struct Places {
    float what = 0, base = 0, mine = 0, theirs = 0, end = 0;
    static float width(float begin, float next) { return next - begin - 12; }
};

Places columns_of(float left, float width) {
    return {left, left + 0.26f * width, left + 0.44f * width, left + 0.72f * width, left + width};
}

void cell(const Theme& theme, float x, float y, float width, const Tint& color, const std::string& text) {
    ImGui::PushFont(theme.body);
    ImGui::GetWindowDrawList()->AddText({x, y}, ink(color), fitted(text, width).c_str());
    ImGui::PopFont();
}

/// One of both versions, which a click takes.
bool choice(const Theme& theme, const char* id, float x, float y, float width, const std::string& text, bool taken) {
    const float height = theme.px(24);
    ImGui::SetCursorScreenPos({x, y});
    const bool clicked = ImGui::InvisibleButton(id, {width, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool hot = ImGui::IsItemHovered();
    if (taken || hot)
        list.AddRectFilled({x, y}, {x + width, y + height}, ink(taken ? palette::accent_deep : palette::field_hot), theme.px(4));
    if (taken) draw_icon(list, Icon::play, {x + theme.px(10), y + 0.5f * height}, theme.px(8), ink(palette::text));
    cell(theme, x + theme.px(20), y + 0.5f * (height - theme.body->FontSize), width - theme.px(26), taken ? palette::text : palette::quiet,
         text);
    return clicked;
}

void row(AppState& state, const Theme& theme, std::size_t index) {
    MergeQuestion& question = *state.merge;
    const ToldConflict& conflict = question.merge->conflicts[index];
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = theme.px(28);
    const Places at = columns_of(place.x + theme.px(6), width - theme.px(12));
    if (question.row == index)
        ImGui::GetWindowDrawList()->AddRect({place.x, place.y}, {place.x + width, place.y + height}, ink(palette::accent), theme.px(4), 0,
                                            theme.px(1.2f));
    const float y = place.y + 0.5f * (height - theme.body->FontSize);
    cell(theme, at.what, y, at.width(at.what, at.base), palette::text, conflict.what);
    cell(theme, at.base, y, at.width(at.base, at.mine), palette::quiet, conflict.base);
    ImGui::PushID(static_cast<int>(index));
    for (const Whose side : {Whose::mine, Whose::theirs}) {
        const bool mine = side == Whose::mine;
        const float x = mine ? at.mine : at.theirs, next = mine ? at.theirs : at.end;
        if (!choice(theme, mine ? "mine" : "theirs", x, place.y + theme.px(2), at.width(x, next), mine ? conflict.mine : conflict.theirs,
                    question.taken[index] == side))
            continue;
        question.row = index;
        question.taken[index] = side;
    }
    ImGui::PopID();
    ImGui::SetCursorScreenPos({place.x, place.y + height + theme.px(2)});
}

void head(const Theme& theme) {
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const Places at = columns_of(place.x + theme.px(16), ImGui::GetContentRegionAvail().x - theme.px(32));
    cell(theme, at.base, place.y, at.width(at.base, at.mine), palette::quiet, "It was");
    cell(theme, at.mine + theme.px(20), place.y, at.width(at.mine, at.theirs), palette::quiet, "Mine");
    cell(theme, at.theirs + theme.px(20), place.y, at.width(at.theirs, at.end), palette::quiet, "In the file");
    ImGui::Dummy({0, theme.body->FontSize});
}

void rows(AppState& state, const Theme& theme) {
    const std::size_t count = state.merge->taken.size();
    const float height = static_cast<float>(count) * theme.px(30) + theme.px(20);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::panel);
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, theme.px(5));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(10), theme.px(10)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    ImGui::BeginChild("##values", {0, std::min(height, 0.5f * ImGui::GetIO().DisplaySize.y)}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding);
    for (std::size_t i = 0; i < count; ++i) {
        row(state, theme, i);
        if (state.merge->row == i && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) ImGui::SetScrollHereY();
    }
    ImGui::EndChild();
    ImGui::PopStyleVar(3);
    ImGui::PopStyleColor();
}

/// Up and down go from value to value, M and T take one.
void value_keys(AppState& state) {
    MergeQuestion& question = *state.merge;
    if (question.taken.empty() || ImGui::IsWindowAppearing()) return;
    const auto pressed = [](int key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    if (pressed(ImGuiKey_DownArrow) && question.row + 1 < question.taken.size()) ++question.row;
    if (pressed(ImGuiKey_UpArrow) && question.row > 0) --question.row;
    for (const ImWchar letter : ImGui::GetIO().InputQueueCharacters) {
        if (letter == 'm' || letter == 'M') run(state, "merge.mine_here");
        if (letter == 't' || letter == 'T') run(state, "merge.theirs_here");
    }
}

void question(AppState& state, Ui& ui) {
    const Theme& theme = ui.theme;
    const std::string& path = state.document.path();
    const std::string name = path.substr(path.find_last_of('/') + 1), refusal = state.merge->merge->refusal;
    const bool whole = !refusal.empty();
    text_in(theme.large, palette::text, name + " changed on disk too");
    ImGui::PushTextWrapPos(0);
    text_in(theme.body, palette::quiet,
            whole ? "Both changes cannot be in one table. Undo brings yours back, whatever you take."
                  : "What only one of you changed is taken from each. Here both changed the same: "
                    "choose by a click, or with M (mine) and T (the file's).");
    if (whole) text_in(theme.body, palette::amber, "Together: " + refusal);
    if (state.message_is_problem && !whole) text_in(theme.body, palette::amber, state.message);
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, theme.px(4)});
    if (!whole) {
        value_keys(state);
        head(theme);
        rows(state, theme);
        ImGui::Dummy({0, theme.px(4)});
    }
    constexpr std::array<Answer, 4> by_value{
        {{"Later", "merge.later"}, {"All mine", "merge.mine"}, {"All theirs", "merge.theirs"}, {"Merge", "merge.accept"}}};
    constexpr std::array<Answer, 3> as_a_whole{{{"Later", "merge.later"}, {"Mine", "merge.mine"}, {"The file's", "merge.theirs"}}};
    const std::string_view answer =
        whole ? answered(theme, as_a_whole, 0, ui.answer, "merge.later") : answered(theme, by_value, 3, ui.answer, "merge.later");
    if (!answer.empty()) run(state, answer);
}

}  // namespace

void merge_dialog(AppState& state, Ui& ui) {
    const bool asks = state.merge && !state.prompt && state.dialog_action.empty();
    if (!asks && !ImGui::IsPopupOpen("##merge")) return;
    if (!begin_modal(ui.theme, "##merge", 760)) return;
    if (asks) question(state, ui);
    if (!asks || !state.merge) ImGui::CloseCurrentPopup();  // the file may have changed back between frames
    ImGui::EndPopup();
}

}  // namespace pinfield::editor

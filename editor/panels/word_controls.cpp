#include <algorithm>
#include <cmath>

#include "editor/panels/field_row.h"
#include "editor/widgets/widgets.h"

namespace pinfield::editor {
namespace {

/// A word of the field's choices, when the user takes another than `now`.
std::optional<std::string> other_choice(const Row& row, const std::string& now, float width) {
    std::optional<std::string> taken;
    if (!begin_combo(row.theme(), "##choice", now.c_str(), width)) return taken;
    for (const std::string_view word : row.field().choices) {
        const std::string text(word);
        if (ImGui::Selectable(text.c_str(), text == now) && text != now) taken = text;
    }
    ImGui::EndCombo();
    return taken;
}

bool fit_side_by_side(const Row& row) {
    const auto& words = row.field().choices;
    return words.size() <= 4 && segmented_width(row.theme(), words) <= row.width;
}

/// Do all nodes have this name among theirs?
bool all_name(const Row& row, const std::string& name) {
    return std::all_of(row.all.begin(), row.all.end(), [&](const FieldOf& f) {
        const auto& names = std::get<std::vector<std::string>>(at(row.state.document.scene().find(f.node)->fields, f.field).value);
        return std::find(names.begin(), names.end(), name) != names.end();
    });
}

/// A list of names with one more, or without it; those it has keep their order.
Value with_name(const Value& before, const std::string& name, bool on) {
    std::vector<std::string> names = std::get<std::vector<std::string>>(before);
    const auto there = std::find(names.begin(), names.end(), name);
    if (on && there == names.end()) names.push_back(name);
    else if (!on && there != names.end()) names.erase(there);
    return names;
}

}  // namespace

void choice_control(const Row& row) {
    const std::string now = row.mixed() ? mixed_word : std::get<std::string>(row.value());
    if (!fit_side_by_side(row)) {
        if (const auto taken = other_choice(row, now, row.width)) row.set(*taken);
        return;
    }
    const auto& words = row.field().choices;
    const auto there = std::find(words.begin(), words.end(), now);
    const int clicked = segmented(row.theme(), "choice", words, there == words.end() ? -1 : static_cast<int>(there - words.begin()));
    if (clicked >= 0 && at(words, clicked) != now) row.set(std::string(at(words, clicked)));
}

void choices_control(const Row& row) {
    if (row.mixed()) return text_control(row, row.width, mixed_word, "none");
    std::vector<std::string> words = std::get<std::vector<std::string>>(row.value());
    const float gap = row.theme().px(6), half = std::floor(0.5f * (row.width - gap));
    bool changed = false;
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < words.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (i % 2 == 1) ImGui::SameLine(0, gap);
        if (const auto taken = other_choice(row, words[i], words.size() == 1 ? row.width : half)) words[i] = *taken, changed = true;
        ImGui::PopID();
    }
    if (small_button(row.theme(), "+", "One more, like the last.") && !words.empty()) words.push_back(words.back()), changed = true;
    if (words.size() > 1) {
        ImGui::SameLine(0, gap);
        if (small_button(row.theme(), "\u2212", "One less.")) words.pop_back(), changed = true;
    }
    ImGui::EndGroup();
    if (changed) row.set(words);
}

void text_control(const Row& row, float width, const std::string& text, const char* hint) {
    const Theme& theme = row.theme();
    const ImVec2 place = ImGui::GetCursorScreenPos(), size{width, ImGui::GetFrameHeight()};
    if (ImGui::InvisibleButton("text", size)) begin_typing(row, -1);
    const bool hot = ImGui::IsItemHovered();
    if (hot) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(place, {place.x + size.x, place.y + size.y}, ink(hot ? palette::field_hot : palette::field),
                       ImGui::GetStyle().FrameRounding);
    const std::string fits = fitted(text.empty() ? hint : text, width - theme.px(16));
    list.AddText({place.x + theme.px(8), place.y + 0.5f * (size.y - ImGui::GetFontSize())},
                 ink(text.empty() ? palette::faint : palette::text), fits.c_str());
}

void names_control(const Row& row) {
    const auto& names = std::get<std::vector<std::string>>(row.value());
    const auto& inputs = row.state.document.scene().inputs;
    if (row.field().meta.meaning != Meaning::input || inputs.empty()) {
        std::string text;
        for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
        return text_control(row, row.width, row.mixed() ? mixed_word : text, "none");
    }
    const Theme& theme = row.theme();
    std::optional<std::pair<std::string, bool>> toggled;  // changed behind the loop: a change replaces the list that it walks
    ImGui::BeginGroup();
    float x = 0;
    for (const InputBinding& input : inputs) {
        const bool on = all_name(row, input.name);
        const float width = ImGui::CalcTextSize(input.name.c_str()).x + theme.px(18);
        if (x > 0 && x + width <= row.width) ImGui::SameLine(0, theme.px(5));
        else x = 0;
        x += width + theme.px(5);
        ImGui::PushStyleColor(ImGuiCol_Button, on ? palette::accent_deep : palette::field);
        ImGui::PushStyleColor(ImGuiCol_Text, on ? palette::text : palette::quiet);
        if (ImGui::Button(input.name.c_str(), {width, 0})) toggled = {input.name, !on};
        ImGui::PopStyleColor(2);
    }
    ImGui::EndGroup();
    if (toggled)
        row.change(change_all, [&](const Value& before) { return std::optional(with_name(before, toggled->first, toggled->second)); });
}

void material_control(const Row& row) {
    const Theme& theme = row.theme();
    const std::string chosen = row.mixed() ? mixed_word : std::get<std::string>(row.value());
    if (!begin_combo(theme, "##material", chosen.empty() ? "inherited" : chosen.c_str(), row.width)) return;
    std::optional<std::string> next;
    if (ImGui::Selectable("inherited", chosen.empty())) next = "";
    for (const NodeId id : row.state.document.scene().materials()) {
        const std::string& name = row.state.document.scene().find(id)->name;
        if (ImGui::Selectable(name.c_str(), name == chosen && !row.mixed())) next = name;
    }
    ImGui::EndCombo();
    if (!next) return;
    if (next->empty()) row.change(reset_all);
    else row.set(*next);
}

}  // namespace pinfield::editor

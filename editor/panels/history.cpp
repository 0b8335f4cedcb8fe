// The steps that were made, in order: a click goes back, or forth again, to where one was done.
#include <fmt/format.h>

#include <utility>

#include "editor/panels/ui.h"
#include "editor/widgets/widgets.h"

namespace pinfield::editor {
namespace {

constexpr float row_height = 23;  // design pixels

struct HistoryRow {
    std::string text;
    bool done = true, now = false, saved = false;
};

HistoryRow row_of(const Document& document, std::size_t steps) {
    HistoryRow row;
    row.text = steps > 0 ? document.step_label(steps - 1) : document.path().empty() ? "Begun" : "Opened";
    row.done = steps <= document.undo_steps();
    row.now = steps == document.undo_steps();
    row.saved = document.saved_after() == steps && !document.path().empty();
    return row;
}

/// True when it was clicked.
bool draw_row(const Theme& theme, const HistoryRow& row, std::size_t index) {
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = theme.px(row_height);
    ImGui::PushID(static_cast<int>(index));
    const bool clicked = ImGui::InvisibleButton("step", {width, height});
    ImGui::PopID();
    const bool hot = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (row.now || hot)
        list.AddRectFilled(place, {place.x + width, place.y + height}, ink(row.now ? palette::field_hot : palette::field), theme.px(4));
    const float y = place.y + 0.5f * (height - ImGui::GetFontSize()), dot = place.x + theme.px(10);
    if (row.done) list.AddCircleFilled({dot, place.y + 0.5f * height}, theme.px(3), ink(row.now ? palette::accent : palette::quiet));
    else list.AddCircle({dot, place.y + 0.5f * height}, theme.px(3), ink(palette::quiet));
    const char* const saved = row.saved ? "saved" : "";
    const float saved_width = ImGui::CalcTextSize(saved).x, left = place.x + theme.px(22), right = place.x + width - theme.px(10);
    list.AddText({right - saved_width, y}, ink(palette::teal), saved);
    list.AddText({left, y}, ink(row.done ? palette::text : palette::quiet), fitted(row.text, right - saved_width - theme.px(8) - left).c_str());
    if (hot) tooltip(theme, row.now ? row.text : row.text + "\nClick to go there");
    return clicked;
}

}  // namespace

void history_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    begin_region("##history", position, size, palette::panel, {theme.px(12), theme.px(8)});
    text_in(theme.strong, palette::text, "History");
    const Document& document = state.document;
    const std::size_t unsaved = document.unsaved_steps();
    if (document.dirty() && unsaved > 0) {
        ImGui::SameLine();
        text_in(theme.body, palette::quiet, fmt::format("{} since it was saved", unsaved));
    }
    ImGui::BeginChild("##steps", {0, 0}, false, ImGuiWindowFlags_NoNav);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    std::optional<std::size_t> wanted;
    const float height = theme.px(row_height);
    const std::size_t done = document.undo_steps();
    if (std::exchange(ui.history_seen, done) != done)
        ImGui::SetScrollY((static_cast<float>(done) + 0.5f) * height - 0.5f * ImGui::GetWindowHeight());
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(document.steps()) + 1, height);
    while (clipper.Step())
        for (auto steps = static_cast<std::size_t>(clipper.DisplayStart); steps < static_cast<std::size_t>(clipper.DisplayEnd); ++steps)
            if (draw_row(theme, row_of(document, steps), steps)) wanted = steps;
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::End();
    if (wanted) go_to_step(state, *wanted);
}

}  // namespace pinfield::editor

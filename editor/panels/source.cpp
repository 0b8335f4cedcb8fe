// The table's text beside the table: what is typed there becomes the table as soon as it reads.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "editor/panels/source_lines.h"
#include "editor/widgets/widgets.h"
#include "engine/core/shown.h"

namespace pinfield::editor {
namespace {

std::string with_hint(const Diagnostic& problem) {
    std::string text = shown(problem.message);
    if (!problem.hint.empty()) (text += '\n') += shown(problem.hint);
    return text;
}

/// What is wrong in the text that is shown, and no other.
std::vector<SourceMark> marks_of(const AppState& state) {
    std::vector<SourceMark> marks;
    const auto add = [&](const Diagnostics& problems) {
        for (const Diagnostic& problem : problems)
            if (problem.where.file == main_file) marks.push_back({problem.where.span, problem.severity == Severity::error, with_hint(problem)});
    };
    if (state.source.pending()) {
        add(state.source.problems());
        return marks;
    }
    // While the disk holds a broken text, the document's problems are that text's.
    const Problems problems = problems_of(state);
    if (state.document.diagnosed().shared_main() == state.source.text(state.document)) add(problems.in_file);
    add(problems.in_program);
    return marks;
}

/// The keyboard goes where the mouse was pressed last, and to whatever takes it by itself.
void give_keyboard(AppState& state, SourcePanel& panel, bool over_text) {
    if (std::exchange(state.type_source, false)) {
        panel.focused = panel.reveals_caret = true;
        const Node* node = state.document.scene().find(state.selection.primary());
        if (!node || node->where.file != main_file) return;
        const Span span{carried(node->where.span.begin, panel.typed), carried(node->where.span.end, panel.typed)};
        if (panel.cursor.caret < span.begin || panel.cursor.caret > span.end) panel.wanted = span.begin;
        return;
    }
    const bool elsewhere = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || (ImGui::IsAnyItemActive() && !panel.dragging);
    if (elsewhere && !over_text) panel.focused = false;
}

float footer_height(const Theme& theme, const AppState& state) {
    if (state.source.stale(state.document)) return theme.px(84);
    return state.source.pending() && !state.source.problems().empty() ? theme.px(58) : 0;
}

bool action_button(const Theme& theme, const char* label, std::string_view action) {
    return small_button(theme, label, find_action(action)->doc);
}

/// What keeps the text from being the table's, and the way on.
void footer(AppState& state, Ui& ui, ImVec2 place, ImVec2 size) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(place, {place.x + size.x, place.y + size.y}, ink(palette::bar));
    list.AddLine(place, {place.x + size.x, place.y}, ink(palette::line));
    const bool stale = state.source.stale(state.document);
    const float left = place.x + theme.px(28), room = size.x - theme.px(38);
    float y = place.y + theme.px(6);
    const auto line = [&](const Tint& color, const std::string& text) {
        list.AddText({left, y}, ink(color), fitted(text, room).c_str());
        y += ImGui::GetFontSize() + theme.px(3);
    };
    draw_icon(list, stale ? Icon::warning : Icon::error, {place.x + theme.px(14), y + 0.5f * ImGui::GetFontSize()}, theme.px(13),
              ink(stale ? palette::amber : palette::coral));
    const Diagnostics& problems = state.source.problems();
    if (stale) {
        line(palette::text, "The table was changed elsewhere meanwhile.");
        line(palette::quiet, "What is typed here is kept, and not yet in the table.");
    } else {
        const Place& where = problems.front().where;  // what stands in other files comes last
        const std::string at = where.file == main_file ? "Line " + std::to_string(ui.source.shown->line_column(where.span.begin).line) : "In what it includes";
        line(palette::text, at + ": " + shown(problems.front().message));
    }
    ImGui::SetCursorScreenPos({left, y + theme.px(2)});
    std::string_view action;
    if (stale && action_button(theme, "Try again", "source.try_again")) action = "source.try_again";
    if (stale) ImGui::SameLine();
    if (action_button(theme, "Discard", "source.discard")) action = "source.discard";
    if (!stale) {
        ImGui::SameLine();
        list.AddText({ImGui::GetCursorScreenPos().x, y + theme.px(5)}, ink(palette::quiet),
                     fitted("The last good table plays on.", place.x + size.x - ImGui::GetCursorScreenPos().x - theme.px(8)).c_str());
    }
    if (!action.empty()) run(state, action);
}

/// A word at the right of the header that can be pressed; where it begins.
float changes_button(AppState& state, const Ui& ui, float right, float y) {
    const Theme& theme = ui.theme;
    const std::optional<LineMarks>& changes = ui.source.changes;
    std::string words = "changes";
    if (changes) words = changes->lines.empty() ? "as saved" : fmt::format("+{} -{}", changes->added, changes->removed);
    const float width = pill_width(theme, words);
    ImGui::SetCursorScreenPos({right - width, y});
    pill(theme, words, changes && !changes->lines.empty() ? palette::teal : palette::quiet, changes ? PillStyle::filled : PillStyle::bare);
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    tooltip(theme, find_action("view.changes")->doc);
    if (ImGui::IsItemClicked(0)) run(state, "view.changes");
    return right - width - theme.px(6);
}

/// The title, what differs from the file, and whether the text is the table's.
void header(AppState& state, const Ui& ui, ImVec2 position, float width, float height) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText(theme.strong, theme.strong->FontSize, {position.x + theme.px(12), position.y + 0.5f * (height - theme.strong->FontSize)},
                 ink(palette::text), "Source");
    const float y = position.y + theme.px(8), right = changes_button(state, ui, position.x + width - theme.px(10), y);
    const bool wrong = state.source.pending() && !state.source.waiting();
    if (!wrong) return;
    const char* words = state.source.stale(state.document) ? "not taken" : "does not read";
    ImGui::SetCursorScreenPos({right - pill_width(theme, words), y});
    pill(theme, words, palette::coral, PillStyle::filled);
}

}  // namespace

void source_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    SourcePanel& panel = ui.source;
    begin_region("##source", position, size, palette::panel, {0, 0}, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    const float head = theme.px(32), foot = std::min(footer_height(theme, state), 0.5f * size.y);
    if (std::exchange(panel.foot, foot) < foot && panel.focused) panel.reveals_caret = true;
    header(state, ui, position, size.x, head);
    const ImVec2 lines_at{position.x, position.y + head}, lines_size{size.x, std::max(size.y - head - foot, 1.0f)};
    const bool over_text = ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) &&
                           ImGui::IsMouseHoveringRect(lines_at, {lines_at.x + lines_size.x, lines_at.y + lines_size.y});
    give_keyboard(state, panel, over_text);
    follow_text(state, panel);
    const int page = std::max(1, static_cast<int>(lines_size.y / source_line_height(theme)) - 1);
    if (panel.focused && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) source_keys(state, ui, page);
    if (panel.focused) state.source.pass(state.document, static_cast<double>(ImGui::GetIO().DeltaTime));
    else state.source.read(state.document);
    follow_text(state, panel);

    ImGui::SetCursorScreenPos(lines_at);
    ImGui::BeginChild("##lines", lines_size, false, ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoNav);
    source_lines(state, ui, marks_of(state));
    ImGui::EndChild();
    if (foot > 0 && footer_height(theme, state) > 0) footer(state, ui, {position.x, position.y + size.y - foot}, {size.x, foot});
    ImGui::End();
}

}  // namespace pinfield::editor

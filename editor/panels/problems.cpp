#include "editor/panels/ui.h"
#include "editor/source_places.h"
#include "editor/widgets/widgets.h"
#include "engine/core/shown.h"

namespace pinfield::editor {

namespace {

void problem_row(AppState& state, Ui& ui, const Diagnostic& problem, const Sources& sources, int index) {
    const Theme& theme = ui.theme;
    const bool error = problem.severity == Severity::error;
    const LineColumn at = sources.line_column(problem.where);
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = theme.px(26);
    ImGui::PushID(index);
    if (ImGui::InvisibleButton("row", {width, height})) {
        const NodeId node = node_at(state.document.scene(), problem.where);
        if (node) state.selection.set(node);
        if (problem.where.file == main_file) ui.source.wanted = problem.where.span.begin;
        say(state, problem.hint.empty() ? problem.message : problem.hint, error);
    }
    const bool hot = ImGui::IsItemHovered();
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hot) list.AddRectFilled(place, {place.x + width, place.y + height}, ink(palette::field), theme.px(4));
    draw_icon(list, error ? Icon::error : Icon::warning, {place.x + theme.px(14), place.y + 0.5f * height}, theme.px(14),
              ink(error ? palette::coral : palette::amber));
    const float y = place.y + 0.5f * (height - ImGui::GetFontSize());
    const Sources::Included* included = sources.inclusion(problem.where.file);
    const std::string file = included ? shown(included->path) + ":" : "";
    const std::string where = file + std::to_string(at.line) + ":" + std::to_string(at.column) + "   " + problem.code;
    const float where_width = ImGui::CalcTextSize(where.c_str()).x;
    list.AddText({place.x + width - where_width - theme.px(10), y}, ink(palette::quiet), where.c_str());
    const float left = place.x + theme.px(30), right = place.x + width - where_width - theme.px(30);
    const std::string message = fitted(shown(problem.message), right - left);
    list.AddText({left, y}, ink(palette::text), message.c_str());
    const float after = left + ImGui::CalcTextSize(message.c_str()).x + theme.px(14);
    if (!problem.hint.empty() && message == shown(problem.message) && right - after > theme.px(60))
        list.AddText({after, y}, ink(palette::quiet), fitted(shown(problem.hint), right - after).c_str());
    if (hot) {
        const SourceText* source = sources.find(problem.where);
        const std::string_view line = source ? source->line(at.line) : std::string_view();
        std::string text = shown(problem.message);
        (text += '\n') += shown(line.substr(0, 200));
        if (!problem.hint.empty()) (text += '\n') += shown(problem.hint);
        tooltip(theme, text);
    }
}

}  // namespace

void problems_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    begin_region("##problems", position, size, palette::panel, {theme.px(12), theme.px(8)});
    text_in(theme.strong, palette::text, "Problems");
    ImGui::BeginChild("##list", {0, 0}, false, ImGuiWindowFlags_NoNav);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    int index = 0;
    // A click may change the document: the lists are a copy.
    const Problems problems = problems_of(state);
    for (const Diagnostic& problem : problems.in_draft) problem_row(state, ui, problem, state.source.diagnosed(), index++);
    for (const Diagnostic& problem : problems.in_file) problem_row(state, ui, problem, state.document.diagnosed(), index++);
    for (const Diagnostic& problem : problems.in_program) problem_row(state, ui, problem, state.document.scene().sources, index++);
    if (index == 0) text_in(theme.body, palette::quiet, "The table reads without a problem.");
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::End();
}

}  // namespace pinfield::editor

#include <cmath>

#include "editor/panels/fields.h"
#include "editor/panels/ui.h"
#include "editor/pick.h"
#include "editor/widgets/widgets.h"
#include "engine/core/numbers.h"
#include "engine/program/evaluate.h"

namespace pinfield::editor {

namespace {

std::string millimetres(double metres, int decimals) { return to_text(1000 * metres, decimals); }

/// World box of all that is selected; empty of records.
Box2 selected_box(const AppState& state) {
    Box2 box;
    for (const NodeId id : state.selection.nodes())
        if (const Node* node = state.document.scene().find(id); node && !node->is_record()) box = box.merged(bounds_of(state, id));
    return box;
}

/// Place, distance and node under the mouse, from the right edge leftwards; then what is selected and how large that is.
float probe(const AppState& state, const Ui& ui, ImDrawList& list, float right, float y) {
    const Theme& theme = ui.theme;
    const auto put = [&](const std::string& text, const Tint& color, float least) {
        const float width = std::max(ImGui::CalcTextSize(text.c_str()).x, theme.px(least));
        right -= width;
        steady_number(list, theme.body, {std::floor(right), y}, color, text);
        right -= theme.px(20);
    };
    const auto put_selection = [&] {
        const std::string size = size_in_words(selected_box(state));
        if (!size.empty()) put("selected: " + size, palette::quiet, 0);
        return right;
    };
    if (!ui.viewport_hovered) return put_selection();
    const Vec2& p = ui.mouse_world;
    put(millimetres(p.x(), 1) + ", " + millimetres(p.y(), 1) + " mm", palette::text, 124);
    const Gap gap = gap_at(state.session.world(), p);
    if (std::isfinite(gap.distance)) {
        put((gap.distance < 0 ? "inside " : "distance ") + millimetres(std::fabs(gap.distance), 2) + " mm", palette::quiet, 150);
        if (const Node* node = state.document.scene().find(gap.node)) put("nearest: " + title_of(*node), palette::quiet, 0);
    }
    return put_selection();
}

}  // namespace

void status_bar(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    begin_region("##status", position, size, palette::bar, {theme.px(12), 0},
                 ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine(position, {position.x + size.x, position.y}, ink(palette::line));
    const float y = position.y + 0.5f * (size.y - ImGui::GetFontSize());
    const float limit = probe(state, ui, list, position.x + size.x - theme.px(14), y);

    const Problems found = problems_of(state);
    const std::size_t problems = found.count();
    const std::string count = problems == 0 ? "No problems" : problems == 1 ? "1 problem" : std::to_string(problems) + " problems";
    ImGui::SetCursorScreenPos({position.x + theme.px(10), position.y});
    const float width = ImGui::CalcTextSize(count.c_str()).x + theme.px(30);
    if (ImGui::InvisibleButton("problems", {width, size.y})) ui.problems_open = !ui.problems_open;
    const Tint color = problems == 0 ? palette::quiet : found.any_error() ? palette::coral : palette::amber;
    draw_icon(list,
              problems == 0       ? Icon::fine
              : found.any_error() ? Icon::error
                                  : Icon::warning,
              {position.x + theme.px(20), position.y + 0.5f * size.y}, theme.px(14), ink(color));
    list.AddText({position.x + theme.px(32), y}, ink(ImGui::IsItemHovered() ? palette::text : color), count.c_str());

    float x = position.x + width + theme.px(22);
    if (state.message.empty() || limit - x < theme.px(60)) return ImGui::End();
    if (state.message_is_problem) {
        draw_icon(list, Icon::warning, {x + theme.px(7), position.y + 0.5f * size.y}, theme.px(13), ink(palette::amber));
        x += theme.px(20);
    }
    const std::string message = fitted(state.message, limit - x);
    list.AddText({x, y}, ink(state.message_is_problem ? palette::amber : palette::quiet), message.c_str());
    ImGui::End();
}

}  // namespace pinfield::editor

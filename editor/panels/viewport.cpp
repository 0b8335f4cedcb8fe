#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "editor/panels/fields.h"
#include "editor/panels/measure_tool.h"
#include "editor/panels/rulers.h"
#include "editor/panels/ui.h"
#include "editor/panels/underlay_tool.h"
#include "editor/pick.h"
#include "editor/play_hint.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"

namespace pinfield::editor {

namespace {

Vec2 vec(ImVec2 v) { return {v.x, v.y}; }
ImVec2 im(const Vec2& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

/// A bar of a round length, to see how large things are.
void scale_bar(const AppState& state, const Theme& theme, ImDrawList& list, ImVec2 corner) {
    double length = 1e-4;
    for (const double step : {1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0})
        if (step * state.view.pixels_per_metre <= theme.px(130)) length = step;
    const auto width = std::round(static_cast<float>(length * state.view.pixels_per_metre));
    const Shown text = shown(length, Unit::metre);
    const std::string label = text.number + " " + text.unit;
    const ImU32 color = ink(palette::quiet);
    const float h = theme.px(4), w = std::max(1.0f, theme.px(1));
    list.AddLine({corner.x, corner.y}, {corner.x + width, corner.y}, color, w);
    list.AddLine({corner.x, corner.y - h}, {corner.x, corner.y + 1}, color, w);
    list.AddLine({corner.x + width, corner.y - h}, {corner.x + width, corner.y + 1}, color, w);
    list.AddText(theme.small, theme.small->FontSize, {corner.x + width + theme.px(8), corner.y - 0.7f * theme.small->FontSize}, color,
                 label.c_str());
}

/// Where balls start: a dashed ring with the way they go; and the id of what is selected or under the mouse.
void draw_marks(const AppState& state, const Ui& ui, ImDrawList& list) {
    const Theme& theme = ui.theme;
    const Program& program = state.session.program();
    for (const Part& part : program.parts) {
        if (part.sensor >= 0 && !at(program.sensors, part.sensor).field.solids.empty()) continue;
        if (part.sensor < 0 && (part.solid >= 0 || part.mover >= 0)) continue;
        const ImVec2 c = im(state.view.pixel_from_world(part.world_from_part.offset));
        const auto r = static_cast<float>(program.physics.ball_radius * state.view.pixels_per_metre);
        const bool chosen = state.selection.contains(part.origin) || part.origin == ui.hovered;
        if (plays(state) && !chosen) continue;  // in play nothing is seen of it
        const ImU32 color = ink(chosen ? palette::accent : palette::teal.faded(0.75f));
        constexpr int dashes = 12;
        for (int i = 0; i < dashes; ++i) {
            const float from = 6.2831853f * static_cast<float>(i) / dashes;
            list.PathArcTo(c, r + theme.px(2), from, from + 0.32f);
            list.PathStroke(color, ImDrawFlags_None, std::max(1.0f, theme.px(1.5f)));
        }
    }
}

void name_tag(const AppState& state, const Theme& theme, ImDrawList& list, NodeId id, const Tint& color) {
    const Node* node = state.document.scene().find(id);
    if (!node || !node->type || node->is_record()) return;
    const Box2 box = bounds_of(state, id);
    if (box.is_empty() || !box.is_finite()) return;
    const std::string text = title_of(*node);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str()), pad{theme.px(7), theme.px(3)};
    const ImVec2 top = im(state.view.pixel_from_world({box.centre().x(), box.hi.y()}));
    const float lowest = static_cast<float>(state.view.origin.y()) + theme.px(50);
    const ImVec2 place{std::round(top.x - 0.5f * size.x), std::round(std::max(top.y - size.y - theme.px(14), lowest))};
    list.AddRectFilled({place.x - pad.x, place.y - pad.y}, {place.x + size.x + pad.x, place.y + size.y + pad.y},
                       ink(palette::bar.faded(0.88f)), theme.px(4));
    list.AddText(place, ink(color), text.c_str());
}

/// To the right of the ball, which mostly lies at that edge of the table; above it where there is no room.
void draw_play_hint(const AppState& state, const Theme& theme, ImDrawList& list) {
    const std::optional<PlayHint> hint = play_hint(state);
    if (!hint) return;
    const ImVec2 ball = im(state.view.pixel_from_world(hint->at)), size = ImGui::CalcTextSize(hint->text.c_str());
    const auto r = static_cast<float>(state.session.program().physics.ball_radius * state.view.pixels_per_metre);
    const ImVec2 pad{theme.px(8), theme.px(4)};
    const float gap = r + theme.px(20), right = static_cast<float>(state.view.origin.x() + state.view.size.x());
    ImVec2 place{std::round(ball.x + gap), std::round(ball.y - 0.5f * size.y)};
    if (place.x + size.x + pad.x > right) place = {std::round(right - size.x - 2 * pad.x), std::round(ball.y - gap - size.y)};
    list.AddRectFilled({place.x - pad.x, place.y - pad.y}, {place.x + size.x + pad.x, place.y + size.y + pad.y},
                       ink(palette::bar.faded(0.88f)), theme.px(4));
    list.AddText(place, ink(palette::amber), hint->text.c_str());
}

void draw_marquee(const AppState& state, const Ui& ui, ImDrawList& list) {
    const ImVec2 a = im(state.view.pixel_from_world(ui.pressed_at)), b = im(ui.mouse);
    list.AddRectFilled({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)},
                       ink(palette::accent.faded(0.12f)));
    list.AddRect({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}, ink(palette::accent));
}

/// Why what is dragged stops where it does.
void draw_snap_lines(const AppState& state, const Ui& ui, ImDrawList& list) {
    const Theme& theme = ui.theme;
    const float width = std::max(1.0f, theme.px(1)), end = theme.px(4);
    for (const SnapLine& line : ui.magnets.lines) {
        const ImVec2 a = im(state.view.pixel_from_world(line.a)), b = im(state.view.pixel_from_world(line.b));
        list.AddLine(a, b, ink(palette::amber), width);
        if (line.kind != SnapLine::Kind::gap) continue;
        const bool level = line.a.y() == line.b.y();
        const ImVec2 across = level ? ImVec2(0, end) : ImVec2(end, 0);
        for (const ImVec2& tip : {a, b})
            list.AddLine({tip.x - across.x, tip.y - across.y}, {tip.x + across.x, tip.y + across.y}, ink(palette::amber), width);
        const Shown text = shown(length(line.b - line.a), Unit::metre);
        const ImVec2 middle{0.5f * (a.x + b.x) + theme.px(level ? -12 : 10), 0.5f * (a.y + b.y) + theme.px(level ? 8 : -8)};
        plate(theme, list, middle, text.number + " " + text.unit, palette::amber);
    }
}

/// What the selection turns or scales about, and how far it has come.
void draw_transform(const AppState& state, const Ui& ui, ImDrawList& list) {
    const bool turns = state.tool == Tool::turn;
    if ((!turns && state.tool != Tool::scale) || state.selection.empty()) return;
    const Theme& theme = ui.theme;
    const Vec2 pivot = ui.transform.active() ? ui.transform.pivot() : pivot_of(state.document.scene(), state.selection.nodes());
    const ImVec2 c = im(state.view.pixel_from_world(pivot));
    const float r = theme.px(64), s = theme.px(6), width = std::max(1.0f, theme.px(1.5f));
    const ImU32 color = ink(palette::accent);
    list.AddLine({c.x - s, c.y}, {c.x + s, c.y}, color, width);
    list.AddLine({c.x, c.y - s}, {c.x, c.y + s}, color, width);
    if (turns) list.AddCircle(c, r, ink(palette::accent.faded(0.7f)), 64, width);
    else list.AddRect({c.x - r, c.y - r}, {c.x + r, c.y + r}, ink(palette::accent.faded(0.7f)), 0, 0, width);
    if (!ui.transform.active()) return;
    list.AddLine(c, im(ui.mouse), color, width);
    const std::string text = turns ? fmt::format("{:.4g}\u00b0", ui.transform.amount()) : fmt::format("x {:.4g}", ui.transform.amount());
    list.AddText({c.x + theme.px(10), c.y + theme.px(8)}, ink(palette::text), text.c_str());
}

/// Where the hand is: the table, or the inside of an operator or part; a click goes back there.
void breadcrumb(AppState& state, Ui& ui, ImVec2 position) {
    if (!state.entered) return;
    std::vector<NodeId> way;
    for (const Node* node = state.document.scene().find(state.entered); node; node = state.document.scene().find(node->parent))
        way.insert(way.begin(), node->id);
    ImGui::SetCursorScreenPos({position.x + ui.theme.px(12), position.y + ui.theme.px(10)});
    NodeId chosen;
    const auto crumb = [&](const std::string& text, bool last) {
        ImGui::PushStyleColor(ImGuiCol_Button, last ? palette::accent_deep : palette::bar.faded(0.88f));
        const bool clicked = ImGui::Button(text.c_str());
        ImGui::PopStyleColor();
        return clicked;
    };
    const bool out = crumb("Table", false);
    for (const NodeId id : way) {
        ImGui::SameLine(0, ui.theme.px(4));
        ImGui::PushID(static_cast<int>(id.value));
        if (crumb(title_of(*state.document.scene().find(id)), id == state.entered)) chosen = id;
        ImGui::PopID();
    }
    if (chosen) state.selection.set(chosen), state.entered = chosen;
    else if (out) select(state, NodeId{});
}

void overlay(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(position, {position.x + size.x, position.y + size.y}, true);
    draw_marks(state, ui, list);
    if (ui.hovered && !state.selection.contains(ui.hovered) && !ui.drag.active()) name_tag(state, theme, list, ui.hovered, palette::text);
    const bool on_handle = ui.handle_drag.active() || handle_under_mouse(state, ui) >= 0;  // whose words stand there
    for (const NodeId node : state.selection.nodes())
        if (!on_handle) name_tag(state, theme, list, node, palette::accent);
    draw_handles(state, ui, list);
    draw_transform(state, ui, list);
    draw_guides(state, ui, list);
    draw_snap_lines(state, ui, list);
    draw_gap_warning(state, ui, list);
    draw_measure(state, ui, list);
    draw_underlay_points(state, ui, list);
    draw_play_hint(state, theme, list);
    if (ui.marquee) draw_marquee(state, ui, list);
    if (!state.preferences.show_rulers) scale_bar(state, theme, list, {position.x + theme.px(16), position.y + size.y - theme.px(16)});
    list.PopClipRect();
}

/// Style and framing, over the top right corner of the picture.
void view_controls(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    const float words = ImGui::CalcTextSize("ShadedIsolines").x + 4 * theme.px(10) + theme.px(2), margin = theme.px(10);
    const float icon = ImGui::GetFontSize() + 2 * theme.px(4);
    if (size.x < words + icon + 3 * margin) return;
    ImGui::SetCursorScreenPos({position.x + size.x - words - icon - margin - theme.px(6), position.y + margin});
    const int style =
        segmented(theme, "style", std::array<std::string_view, 2>{"Shaded", "Isolines"}, state.view.style == ViewStyle::shaded ? 0 : 1);
    if (style >= 0) run(state, style == 0 ? "view.shaded" : "view.isolines");
    ImGui::SetCursorScreenPos({position.x + size.x - margin - icon, position.y + margin});
    if (icon_button(theme, {.icon = Icon::frame, .id = "frame", .tooltip = "Frame the table (Home)"}, icon)) run(state, "view.all");
}

}  // namespace

void viewport_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    rulers(state, ui, position, size);
    // The table itself is painted under this window, before the panels.
    begin_region("##viewport", position, size, palette::backdrop.faded(0), {0, 0},
                 ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollWithMouse);
    state.view.origin = vec(position);
    if (std::exchange(ui.frame_wanted, false) || state.view.size.x() <= 1) {
        state.view.size = vec(size);
        run(state, "view.all");
    } else if (state.view.size != vec(size)) {
        state.view.resize(vec(size), {{0, 0}, state.session.program().size});
    }

    look_for_handles(state, ui);
    ImGui::InvisibleButton("##table", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    ImGui::SetItemAllowOverlap();
    table_mouse(state, ui);
    overlay(state, ui, position, size);
    view_controls(state, ui, position, size);
    breadcrumb(state, ui, position);
    underlay_controls(state, ui, position, size);
    ImGui::End();
}

}  // namespace pinfield::editor

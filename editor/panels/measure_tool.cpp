#include "editor/panels/measure_tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "editor/gaps.h"
#include "editor/panels/fields.h"
#include "editor/widgets/widgets.h"
#include "engine/core/numbers.h"
#include "engine/core/trig.h"

namespace pinfield::editor {
namespace {

constexpr double measure_snap_pixels = 7;

ImVec2 im(const Vec2& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

std::string millimetres(double metres) { return to_text(1000 * metres, std::fabs(metres) < 0.1 ? 2 : 1); }

/// Where the hand is: on what is there, unless Ctrl is held.
Vec2 place_under(const AppState& state, const Ui& ui) {
    const bool free = ImGui::GetIO().KeyCtrl;
    return measured_place(state, ui.mouse_world, free ? 0 : measure_snap_pixels / state.view.pixels_per_metre,
                          free ? 0 : state.preferences.grid);
}

void draw_end(ImDrawList& list, const Theme& theme, ImVec2 c, ImU32 color) {
    const float r = theme.px(4);
    list.AddCircleFilled(c, r, ink(palette::bar.faded(0.9f)));
    list.AddCircle(c, r, color, 0, std::max(1.0f, theme.px(1.5f)));
}

/// A free part of the way: its length, and whether a ball fits.
void draw_stretch(const AppState& state, const Theme& theme, ImDrawList& list, const Measurement& m, const FreeStretch& stretch) {
    const Vec2 along = (m.to - m.from) / length(m.to - m.from);
    const double diameter = 2 * state.session.program().physics.ball_radius;
    const bool narrow = stretch.closed && stretch.length() < diameter;
    const Tint color = narrow ? palette::amber : palette::teal;
    const ImVec2 a = im(state.view.pixel_from_world(m.from + stretch.begin * along)),
                 b = im(state.view.pixel_from_world(m.from + stretch.end * along));
    list.AddLine(a, b, ink(color), theme.px(3));
    if (!stretch.closed) return;
    const ImVec2 middle{0.5f * (a.x + b.x), 0.5f * (a.y + b.y)};
    const float wide = std::hypot(b.x - a.x, b.y - a.y);
    const auto r = static_cast<float>(0.5 * diameter * state.view.pixels_per_metre);
    list.AddCircle(middle, r, ink(color), 0, std::max(1.0f, theme.px(1.5f)));
    if (wide < theme.px(16) && !narrow) return;
    const std::string words = millimetres(stretch.length()) + (narrow ? " mm: narrower than a ball" : " mm free");
    // Beside the line, not upon it.
    const bool level = std::fabs(b.x - a.x) > std::fabs(b.y - a.y);
    const float size = ImGui::CalcTextSize(words.c_str()).x;
    if (level)
        plate(theme, list, {middle.x - 0.5f * size, middle.y + r + theme.px(8)}, words, color);
    else
        plate(theme, list, {middle.x + r + theme.px(10), middle.y - 0.5f * ImGui::GetFontSize()}, words, color);
}

}  // namespace

void measure(AppState& state, Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActivated() && io.MouseDown[0]) {
        const Vec2 place = place_under(state, ui);
        ui.measurement = Measurement{place, place};
        ui.measuring = true;
    }
    if (!ImGui::IsItemActive() || !io.MouseDown[0]) ui.measuring = false;
    if (!ui.measuring || !ui.measurement) return;
    Vec2 to = place_under(state, ui);
    const Vec2 delta = to - ui.measurement->from;
    if (io.KeyShift) {
        const int still = std::fabs(delta.x()) < std::fabs(delta.y()) ? 0 : 1;
        to[still] = ui.measurement->from[still];
    }
    ui.measurement->to = to;
}

void draw_measure(const AppState& state, const Ui& ui, ImDrawList& list) {
    if (state.tool != Tool::measure) return;
    const Theme& theme = ui.theme;
    if (ui.viewport_hovered && !ui.measuring)
        draw_end(list, theme, im(state.view.pixel_from_world(place_under(state, ui))), ink(palette::accent));
    if (!ui.measurement) return;
    const Measurement& m = *ui.measurement;
    const ImVec2 a = im(state.view.pixel_from_world(m.from)), b = im(state.view.pixel_from_world(m.to));
    const Vec2 delta = m.to - m.from;
    const double distance = length(delta);
    if (distance > 0) {
        const float thin = std::max(1.0f, theme.px(1));
        const ImU32 legs = ink(palette::text.faded(0.45f));
        list.AddLine(a, {b.x, a.y}, legs, thin);
        list.AddLine({b.x, a.y}, b, legs, thin);
        list.AddLine(a, b, ink(palette::text), std::max(1.0f, theme.px(1.5f)));
        for (const FreeStretch& stretch : free_stretches(state.session.world(), m.from, m.to)) draw_stretch(state, theme, list, m, stretch);
    }
    draw_end(list, theme, a, ink(palette::accent));
    draw_end(list, theme, b, ink(palette::accent));
    const std::string words = fmt::format("{} mm    x {}  y {}    {}\u00b0", millimetres(distance), millimetres(delta.x()),
                                          millimetres(delta.y()), to_text(degrees(arc_tangent(delta.y(), delta.x())), 1));
    const float width = ImGui::CalcTextSize(words.c_str()).x,
                right = static_cast<float>(state.view.origin.x() + state.view.size.x()) - theme.px(10);
    const float above = b.y <= a.y ? -theme.px(30) : theme.px(14);
    plate(theme, list, {std::min(b.x + theme.px(12), right - width), b.y + above}, words, palette::text);
}

void draw_gap_warning(const AppState& state, const Ui& ui, ImDrawList& list) {
    if (!state.preferences.warn_of_gaps) return;
    std::vector<NodeId> moved;
    if (ui.handle_drag.active())
        moved.push_back(ui.handle_drag.node());
    else if (ui.drag.active())
        for (const Held& held : ui.drag.held()) moved.push_back(held.node);
    else if (ui.transform.active())
        moved = state.selection.nodes();
    if (moved.empty()) return;
    const auto gap = narrowest_gap(state, moved, 2 * state.session.program().physics.ball_radius);
    if (!gap) return;
    const Theme& theme = ui.theme;
    const ImVec2 a = im(state.view.pixel_from_world(gap->a)), b = im(state.view.pixel_from_world(gap->b));
    const float end = theme.px(5), dx = b.x - a.x, dy = b.y - a.y, l = std::max(1e-3f, std::hypot(dx, dy));
    const ImVec2 across{-end * dy / l, end * dx / l};
    const float width = std::max(1.0f, theme.px(2));
    list.AddLine(a, b, ink(palette::amber), width);
    for (const ImVec2& tip : {a, b})
        list.AddLine({tip.x - across.x, tip.y - across.y}, {tip.x + across.x, tip.y + across.y}, ink(palette::amber), width);
    const std::string words = millimetres(gap->width) + " mm: narrower than a ball";
    const float wide = ImGui::CalcTextSize(words.c_str()).x,
                right = static_cast<float>(state.view.origin.x() + state.view.size.x()) - theme.px(10);
    plate(theme, list, {std::min(std::max(a.x, b.x) + theme.px(14), right - wide), 0.5f * (a.y + b.y) - 0.5f * ImGui::GetFontSize()}, words,
          palette::amber);
}

}  // namespace pinfield::editor

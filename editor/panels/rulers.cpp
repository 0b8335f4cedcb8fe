// Rulers at the edges of the table's view, and the guides that are drawn out of them.
#include "editor/panels/rulers.h"

#include <algorithm>
#include <cmath>

#include "editor/panels/fields.h"
#include "editor/pick.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

constexpr float ruler_height = 20, ruler_width = 38;  // design pixels
constexpr double reach_pixels = 4;

float coordinate(ImVec2 v, int axis) { return axis == 0 ? v.x : v.y; }
ImVec2 with_axes(int axis, float along, float across) { return axis == 0 ? ImVec2(along, across) : ImVec2(across, along); }

/// A pixel of the window along a world axis.
float pixel_along(const View& view, int axis, double metres) {
    Vec2 world(0, 0);
    world[axis] = metres;
    return std::round(static_cast<float>(view.pixel_from_world(world)[axis]));
}

void draw_ticks(const AppState& state, const Theme& theme, ImDrawList& list, int axis, ImVec2 lo, ImVec2 hi) {
    const RulerScale scale = ruler_scale(state.view.pixels_per_metre, theme.px(axis == 0 ? 56 : 30));
    const Box2 seen = state.view.window();
    const double small = scale.step / scale.parts;
    const auto first = static_cast<long long>(std::floor(seen.lo[axis] / small)),
               last = static_cast<long long>(std::ceil(seen.hi[axis] / small));
    const float edge = coordinate(hi, 1 - axis);  // the table's side
    for (long long i = first; i <= last; ++i) {
        const float at = pixel_along(state.view, axis, static_cast<double>(i) * small);
        const bool labelled = i % scale.parts == 0, middle = scale.parts % 2 == 0 && i % (scale.parts / 2) == 0;
        const float length = theme.px(labelled ? 8 : middle ? 6 : 4);
        list.AddLine(with_axes(axis, at, edge - length), with_axes(axis, at, edge),
                     ink(labelled ? palette::quiet : palette::faint.faded(0.7f)));
        if (!labelled) continue;
        const std::string label = scale.label(i / scale.parts);
        ImGui::PushFont(theme.small);
        const ImVec2 size = ImGui::CalcTextSize(label.c_str());
        ImGui::PopFont();
        const ImVec2 place =
            axis == 0 ? ImVec2(at + theme.px(3), lo.y + theme.px(1)) : ImVec2(edge - theme.px(10) - size.x, at - 0.5f * size.y);
        list.AddText(theme.small, theme.small->FontSize, {std::round(place.x), std::round(place.y)}, ink(palette::quiet), label.c_str());
    }
}

/// How much of it the selection takes, and where the mouse is.
void draw_marks(const AppState& state, const Ui& ui, ImDrawList& list, int axis, ImVec2 lo, ImVec2 hi) {
    Box2 box;
    for (const NodeId node : state.selection.nodes()) box = box.merged(bounds_of(state, node));
    const float least = coordinate(lo, axis), most = coordinate(hi, axis), edge = coordinate(hi, 1 - axis),
                other = coordinate(lo, 1 - axis);
    if (!box.is_empty() && box.is_finite()) {
        const float a = pixel_along(state.view, axis, box.lo[axis]), b = pixel_along(state.view, axis, box.hi[axis]);
        list.AddRectFilled(with_axes(axis, std::clamp(std::min(a, b), least, most), other),
                           with_axes(axis, std::clamp(std::max(a, b), least, most), edge), ink(palette::accent_deep));
    }
    const auto mouse = static_cast<float>(ui.mouse[axis]);
    if (ui.viewport_hovered && mouse > least && mouse < most)
        list.AddLine(with_axes(axis, mouse, other), with_axes(axis, mouse, edge), ink(palette::accent), std::max(1.0f, ui.theme.px(1)));
}

/// Along the axis; a drag out of it makes a guide across.
void ruler(AppState& state, Ui& ui, const char* name, int axis, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    begin_region(name, position, size, palette::bar, {0, 0}, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::InvisibleButton("##strip", size);
    if (ImGui::IsItemActivated() && state.aids.guides.size() < most_guides) {
        ui.guide_hand = {state.aids.guides.size(), true, 0};
        state.aids.guides.push_back({1 - axis, 0});
        state.preferences.show_guides = true;
    }
    const bool held = ui.guide_hand.is_new && ui.guide_hand.index && at(state.aids.guides, *ui.guide_hand.index).axis == 1 - axis;
    if (held && ImGui::IsItemActive())
        drag_guide(state, ui);
    else if (held)
        release_guide(state, ui);
    tooltip(theme, axis == 0 ? "Drag a level guide out of here" : "Drag an upright guide out of here");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{position.x + size.x, position.y + size.y};
    draw_marks(state, ui, list, axis, position, end);
    draw_ticks(state, theme, list, axis, position, end);
    list.AddLine(with_axes(axis, coordinate(position, axis), coordinate(end, 1 - axis) - 1),
                 with_axes(axis, coordinate(end, axis), coordinate(end, 1 - axis) - 1), ink(palette::line));
    ImGui::End();
}

bool over_its_ruler(const AppState& state, const Ui& ui, const Guide& guide) {
    return ui.mouse[guide.axis] < state.view.origin[guide.axis];
}

}  // namespace

void rulers(AppState& state, Ui& ui, ImVec2& position, ImVec2& size) {
    const Theme& theme = ui.theme;
    const float width = theme.px(ruler_width), height = theme.px(ruler_height);
    if (!state.preferences.show_rulers || !state.show_panels || size.x < 4 * width || size.y < 6 * height) return;
    begin_region("##ruler_corner", position, {width, height}, palette::bar, {0, 0}, ImGuiWindowFlags_NoScrollbar);
    const std::string unit = ruler_scale(state.view.pixels_per_metre, theme.px(56)).unit();
    ImGui::GetWindowDrawList()->AddText(theme.small, theme.small->FontSize, {position.x + theme.px(6), position.y + theme.px(2)},
                                        ink(palette::quiet), unit.c_str());
    ImGui::End();
    ruler(state, ui, "##ruler_top", 0, {position.x + width, position.y}, {size.x - width, height});
    ruler(state, ui, "##ruler_left", 1, {position.x, position.y + height}, {width, size.y - height});
    position = {position.x + width, position.y + height};
    size = {size.x - width, size.y - height};
}

std::optional<std::size_t> guide_under_mouse(const AppState& state, const Ui& ui) {
    if (!state.preferences.show_guides || state.preferences.lock_guides || state.tool == Tool::measure) return {};
    return guide_at(state.aids.guides, ui.mouse_world, reach_pixels / state.view.pixels_per_metre);
}

bool press_guide(AppState& state, Ui& ui) {
    const std::optional<std::size_t> index = guide_under_mouse(state, ui);
    if (index) ui.guide_hand = {index, false, at(state.aids.guides, *index).at};
    return index.has_value();
}

void drag_guide(AppState& state, Ui& ui) {
    if (!ui.guide_hand.index || *ui.guide_hand.index >= state.aids.guides.size()) return;
    Guide& guide = at(state.aids.guides, *ui.guide_hand.index);
    const bool free = ImGui::GetIO().KeyCtrl, snaps = state.preferences.snapping && !free;
    const std::vector<Box2> boxes = snaps ? boxes_beside(state, {}) : std::vector<Box2>();
    const Vec2 hand = state.view.world_from_pixel(ui.mouse);
    guide.at =
        guide_place(hand[guide.axis], guide.axis, boxes, snap_pixels / state.view.pixels_per_metre, free ? 0 : state.preferences.grid);
    ImGui::SetMouseCursor(guide.axis == 0 ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
}

void release_guide(AppState& state, Ui& ui) {
    const GuideHand hand = std::exchange(ui.guide_hand, {});
    if (!hand.index || *hand.index >= state.aids.guides.size()) return;
    if (over_its_ruler(state, ui, at(state.aids.guides, *hand.index)))
        state.aids.guides.erase(state.aids.guides.begin() + static_cast<std::ptrdiff_t>(*hand.index));
}

bool cancel_guide(AppState& state, Ui& ui) {
    const GuideHand hand = std::exchange(ui.guide_hand, {});
    if (!hand.index || *hand.index >= state.aids.guides.size()) return false;
    if (hand.is_new)
        state.aids.guides.erase(state.aids.guides.begin() + static_cast<std::ptrdiff_t>(*hand.index));
    else
        at(state.aids.guides, *hand.index).at = hand.before;
    return true;
}

void draw_guides(const AppState& state, const Ui& ui, ImDrawList& list) {
    if (!state.preferences.show_guides) return;
    const Theme& theme = ui.theme;
    const std::optional<std::size_t> hot =
        ui.viewport_hovered && !ui.hovered && !ui.drag.active() ? guide_under_mouse(state, ui) : std::nullopt;
    for (std::size_t i = 0; i < state.aids.guides.size(); ++i) {
        const Guide& guide = state.aids.guides[i];
        const float at = pixel_along(state.view, guide.axis, guide.at);
        const auto least = static_cast<float>(state.view.origin[1 - guide.axis]),
                   most = static_cast<float>(least + state.view.size[1 - guide.axis]);
        const bool held = ui.guide_hand.index == i, lit = held || hot == i;
        list.AddLine(with_axes(guide.axis, at, least), with_axes(guide.axis, at, most), ink(Tint(Role::guide, lit ? 1 : 0.75f)),
                     std::max(1.0f, theme.px(lit ? 2 : 1)));
        if (!lit) continue;
        const Shown text = shown(guide.at, Unit::metre);
        const std::string words = std::string(guide.axis == 0 ? "x " : "y ") + text.number + " " + text.unit +
                                  (held && over_its_ruler(state, ui, guide) ? ": let go to remove" : "");
        const ImVec2 beside{static_cast<float>(ui.mouse.x()) + theme.px(14), static_cast<float>(ui.mouse.y()) + theme.px(12)};
        plate(theme, list, beside, words, Role::guide);
    }
}

}  // namespace pinfield::editor

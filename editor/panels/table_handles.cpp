// The handles of the selected node, over the table: drawn, found under the mouse, dragged.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "editor/panels/fields.h"
#include "editor/panels/ui.h"
#include "editor/pick.h"
#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

constexpr double grip_pixels = 8;    ///< how near the mouse must come
constexpr double least_pixels = 14;  ///< of a node on the screen: handles of smaller ones would hide it

/// All that handles depend on: the values of a node and of what lies in it.
std::vector<Value> values_of(const Scene& scene, NodeId id) {
    std::vector<Value> out;
    for (const Node& node : scene.copy(id))
        for (const FieldSlot& slot : node.fields) out.push_back(slot.value);
    return out;
}

bool all_identical(const std::vector<Value>& a, const std::vector<Value>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Value& x, const Value& y) { return identical(x, y); });
}

ImVec2 on_screen(const AppState& state, const Vec2& world) {
    const Vec2 pixel = state.view.pixel_from_world(world);
    return {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
}

/// A handle and where it is seen.
struct SeenHandle {
    const Handle& handle;
    Vec2 world;
    Vec2 node_world;  ///< the node's own place
};

void draw_square(ImDrawList& list, ImVec2 c, float r, ImU32 fill, ImU32 edge, float width) {
    list.AddRectFilled({c.x - r, c.y - r}, {c.x + r, c.y + r}, fill, 1.5f);
    list.AddRect({c.x - r, c.y - r}, {c.x + r, c.y + r}, edge, 1.5f, 0, width);
}

void draw_arrow(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 color, float width) {
    const float x = to.x - from.x, y = to.y - from.y, l = std::max(1e-3f, std::sqrt(x * x + y * y)), s = 4 * width;
    const float ux = x / l, uy = y / l;
    list.AddLine(from, to, color, width);
    list.AddTriangleFilled(to, {to.x - 2 * s * ux - s * uy, to.y - 2 * s * uy + s * ux},
                           {to.x - 2 * s * ux + s * uy, to.y - 2 * s * uy - s * ux}, color);
}

void draw_handle(const AppState& state, const Theme& theme, ImDrawList& list, const SeenHandle& seen, bool hot, bool chosen) {
    const ImVec2 c = on_screen(state, seen.world);
    const float width = std::max(1.0f, theme.px(1.5f)), r = theme.px(hot ? 5 : 4);
    const ImU32 fill = ink(hot || chosen ? palette::accent : palette::bar), edge = ink(hot && chosen ? palette::text : palette::accent);
    switch (seen.handle.kind) {
        case HandleKind::place: draw_square(list, c, r, fill, edge, width); break;
        case HandleKind::velocity:
            draw_arrow(list, on_screen(state, seen.node_world), c, ink(hot ? palette::accent : palette::teal), width);
            list.AddCircleFilled(c, 0.8f * r, fill);
            list.AddCircle(c, 0.8f * r, edge, 0, width);
            break;
        case HandleKind::outline:
            list.AddCircleFilled(c, r, fill);
            list.AddCircle(c, r, edge, 0, width);
            break;
        case HandleKind::gap:
            list.AddCircleFilled(c, 0.6f * r, ink(hot ? palette::accent : palette::bar.faded(0.8f)));
            list.AddCircle(c, 0.6f * r, ink(palette::accent.faded(hot ? 1 : 0.6f)), 0, width);
            break;
    }
}

/// "radius 26 mm", "b 120, 35 mm": what a drag of the handle changes, as it is now.
std::string words_for(const Node& node, const Handle& handle) {
    const FieldType& field = at(node.type->fields, handle.field);
    const Value& value = at(node.fields, handle.field).value;
    if (handle.kind == HandleKind::gap) return "drag to add a point";
    const int all = component_count(value), first = std::min(handle.component, all - 1);
    const Shown x = shown(component(value, first), field.meta.unit);
    const bool pair = handle.kind != HandleKind::outline && first + 1 < all;
    const std::string which = handle.kind == HandleKind::outline && all == 2 ? (first == 0 ? " x" : " y")
                              : all > 2                                      ? fmt::format(" {}", first / 2)
                                                                             : std::string();
    const std::string numbers = pair ? x.number + ", " + shown(component(value, first + 1), field.meta.unit).number : x.number;
    return fmt::format("{}{}  {} {}", field.key, which, numbers, x.unit);
}

void draw_words(const Theme& theme, ImDrawList& list, ImVec2 beside, const std::string& text, const Tint& color) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str()), pad{theme.px(7), theme.px(3)};
    const ImVec2 place{std::round(beside.x + theme.px(14)), std::round(beside.y - size.y - theme.px(10))};
    list.AddRectFilled({place.x - pad.x, place.y - pad.y}, {place.x + size.x + pad.x, place.y + size.y + pad.y},
                       ink(palette::bar.faded(0.92f)), theme.px(4));
    list.AddText(place, ink(color), text.c_str());
}

bool is_too_small(const AppState& state, NodeId node) {
    const Box2 box = bounds_of(state, node);
    return box.is_finite() && box.size().maxCoeff() * state.view.pixels_per_metre < least_pixels;
}

/// The handles go to the copy under the mouse, unless it is at one of those that are seen.
void follow_mouse(const AppState& state, Ui& ui) {
    if (!ui.viewport_hovered || handle_under_mouse(state, ui) >= 0) return;
    const Vec2 mouse = state.view.world_from_pixel(ui.mouse);
    if (auto copy = copy_at(state, ui.handles.node, mouse, grip_pixels * ui.theme.scale / state.view.pixels_per_metre))
        ui.handles.copy = std::move(*copy);
}

/// Along which axes of the world a handle may be pushed: a place along both, an outline along the one that it faces.
SnapWish wish_for(const Showing& showing, const Handle& handle) {
    SnapWish wish{{true, true}, false};
    if (handle.kind == HandleKind::velocity) wish.along[0] = wish.along[1] = false;
    if (handle.kind != HandleKind::outline) return wish;
    constexpr double little = 1e-5, straight = 1e-3;  // metres; of a unit
    const auto here = showing.world_from_local(handle.at), there = showing.world_from_local(handle.at + little * handle.normal);
    for (const int axis : {0, 1})
        wish.along[axis] = here && there && std::fabs((*there - *here)[1 - axis]) < straight * length(*there - *here);
    return wish;
}

/// The hand goes to where the handle is in line with something near by, and the lines say with what.
void snap_handle(const AppState& state, Ui& ui, const Showing& showing, Vec2& p, Vec2& grid) {
    const HandleDrag& drag = ui.handle_drag;
    const auto wanted = showing.world_from_local(p - drag.hold());
    if (!wanted) return;
    Snap held = snap({*wanted, *wanted}, ui.magnets.others, snap_pixels / state.view.pixels_per_metre, wish_for(showing, drag.handle()));
    if (!held.axis[0] && !held.axis[1]) return;
    p = showing.local_from_world(*wanted + held.push) + drag.hold();
    // Where the node stands straight the other coordinate keeps to the grid.
    const Vec2 across = showing.local_from_world(*wanted + Vec2(1e-3, 0)) - showing.local_from_world(*wanted);
    const bool straight = std::fabs(across.y()) < 1e-9, upright = std::fabs(across.x()) < 1e-9;
    for (const int axis : {0, 1})
        if (held.axis[upright ? 1 - axis : axis] || !(straight || upright)) grid[axis] = exact_grid;
    ui.magnets.lines = std::move(held.lines);
}

}  // namespace

void look_for_handles(const AppState& state, Ui& ui) {
    const Scene& scene = state.document.scene();
    Handles& shown = ui.handles;
    const bool one = state.selection.nodes().size() == 1 && state.tool == Tool::select;
    const Node* node = one ? scene.find(state.selection.primary()) : nullptr;
    if (!node || node->is_record() || is_locked(scene, *node) || ui.drag.active()) {
        shown = {};
        return;
    }
    std::vector<Value> values = values_of(scene, node->id);
    if (shown.node != node->id) shown.copy = {};
    if (shown.node != node->id || !all_identical(values, shown.values))
        shown = {node->id, std::move(values), handles_of(scene, node->id), shown.copy};
    if (!ui.handle_drag.active()) follow_mouse(state, ui);
}

int handle_under_mouse(const AppState& state, const Ui& ui) {
    if (!state.document.scene().find(ui.handles.node) || is_too_small(state, ui.handles.node)) return -1;
    const Showing showing(state, ui.handles.node, ui.handles.copy);
    int best = -1;
    // Nearer to the middle of the node the hand means the node: a small one could not be moved otherwise.
    double nearest = grip_pixels * ui.theme.scale;
    const Box2 box = bounds_of(state, ui.handles.node);
    const auto pixels_to = [&](const std::optional<Vec2>& world) {
        return world ? length(state.view.pixel_from_world(*world) - ui.mouse) : infinity;
    };
    const Similarity node_from_world = shown_from_local(state, ui.handles.node).inverse();
    if (box.is_finite()) nearest = std::min(nearest, pixels_to(showing.world_from_local(node_from_world * box.centre())) + 1e-3);
    for (std::size_t i = 0; i < ui.handles.all.size(); ++i) {
        const double distance = pixels_to(showing.world_from_local(ui.handles.all[i].at));
        if (distance >= nearest) continue;
        nearest = distance;
        best = static_cast<int>(i);
    }
    return best;
}

bool press_handle(AppState& state, Ui& ui) {
    const int index = handle_under_mouse(state, ui);
    if (index < 0) return false;
    const Handle handle = at(ui.handles.all, index);
    state.point.reset();
    if (handle.kind == HandleKind::place) state.point = PickedPoint{ui.handles.node, handle.field, handle.component};
    const Showing showing(state, ui.handles.node, ui.handles.copy);
    ui.magnets = {{}, magnets_for(state, {ui.handles.node}), {}};
    for (const Handle& other : ui.handles.all)  // points of a list come in line with each other, too
        if (other.kind == HandleKind::place && other.field == handle.field && other.component != handle.component)
            if (const auto world = showing.world_from_local(other.at)) ui.magnets.others.push_back({*world, *world});
    return ui.handle_drag.begin(state.document, ui.handles.node, handle, showing.local_from_world(ui.mouse_world));
}

void drag_handle(AppState& state, Ui& ui) {
    const NodeId node = ui.handle_drag.node();
    if (!state.document.scene().find(node)) return;
    const bool free = ImGui::GetIO().KeyCtrl;
    const Showing showing(state, node, ui.handles.copy);
    Vec2 p = showing.local_from_world(ui.mouse_world), grid = square_grid(free ? 0 : state.preferences.grid);
    ui.magnets.lines.clear();
    if (state.preferences.snapping && !free) snap_handle(state, ui, showing, p, grid);
    tell(state, ui.handle_drag.update(state.document, p, grid));
}

void draw_handles(const AppState& state, const Ui& ui, ImDrawList& list) {
    const Node* node = state.document.scene().find(ui.handles.node);
    if (!node || ui.handles.all.empty()) return;
    const Showing showing(state, node->id, ui.handles.copy);
    const std::optional<Vec2> node_world = showing.world_from_local({0, 0});
    if (is_too_small(state, node->id)) return;
    const bool dragging = ui.handle_drag.active();
    const int hot = ui.viewport_hovered && !dragging ? handle_under_mouse(state, ui) : -1;
    const auto is_dragged = [&](const Handle& handle) {
        const Handle& held = ui.handle_drag.handle();
        const int component_index = held.component + (held.kind == HandleKind::gap ? 2 : 0);
        return dragging && handle.kind != HandleKind::gap && handle.field == held.field && handle.component == component_index;
    };
    for (std::size_t i = 0; i < ui.handles.all.size(); ++i) {
        const Handle& handle = ui.handles.all[i];
        const bool chosen = state.point && state.point->field == handle.field && state.point->component == handle.component &&
                            handle.kind == HandleKind::place;
        const bool lit = is_dragged(handle) || static_cast<int>(i) == hot;
        const std::optional<Vec2> world = showing.world_from_local(handle.at);
        if (!world || (dragging && !lit && handle.kind == HandleKind::gap)) continue;
        draw_handle(state, ui.theme, list, {handle, *world, node_world.value_or(*world)}, lit, chosen);
        if (!lit) continue;
        const ImVec2 beside = on_screen(state, *world);
        const auto& why = ui.handle_drag.stopped_by();
        draw_words(ui.theme, list, beside, dragging && why ? words_for(*node, handle) + "    " + *why : words_for(*node, handle),
                   dragging && why ? palette::amber : palette::text);
    }
}

}  // namespace pinfield::editor

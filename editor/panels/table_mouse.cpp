// What the mouse does over the table: select, enter, drag, copy by dragging, draw a box around, pan, zoom, ask for the menu.
#include <algorithm>
#include <cmath>

#include "editor/panels/measure_tool.h"
#include "editor/panels/rulers.h"
#include "editor/panels/ui.h"
#include "editor/panels/underlay_tool.h"
#include "editor/pick.h"
#include "editor/widgets/widgets.h"

namespace pinfield::editor {
namespace {

constexpr double pick_slack_pixels = 4;
constexpr float drag_threshold = 3;

double slack_of(const AppState& state) { return pick_slack_pixels / state.view.pixels_per_metre; }

NodeId domain_of(const AppState& state) {
    for (const Solid& solid : state.session.program().fixed.solids)
        if (solid.is_domain) return solid.origin;
    return {};
}

/// A double click goes one level down: to the child under the mouse. Where nothing but the wall is, to the wall's pieces.
void enter(AppState& state, const Ui& ui) {
    const NodeId parent = ui.pressed.node ? ui.pressed.node : domain_of(state);
    const std::vector<Hit> within = hits_within(state, parent, ui.mouse_world, slack_of(state));
    if (!within.empty()) select(state, within.front().node);
}

void press(AppState& state, Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.KeyAlt && !io.KeyShift && press_handle(state, ui)) return;
    state.point.reset();
    ui.pressed = grip_at(state, state.entered, ui.mouse_world, slack_of(state));
    if (!ui.pressed.node && press_guide(state, ui)) return;
    ui.pressed_at = ui.mouse_world;
    ui.pressing = true;
    ui.copies = io.KeyAlt;
    ui.double_click = ImGui::IsMouseDoubleClicked(0);
    if (ui.double_click && !io.KeyShift) return enter(state, ui);
    if (ui.pressed.node && !io.KeyShift && !state.selection.contains(ui.pressed.node)) select(state, ui.pressed.node);
}

/// With the tools for it, a drag turns or scales what is selected, wherever it begins.
bool begin_transform(AppState& state, Ui& ui) {
    if (state.tool != Tool::turn && state.tool != Tool::scale) return false;
    const std::vector<NodeId>& nodes = state.selection.nodes();
    const TransformKind kind = state.tool == Tool::turn ? TransformKind::turn : TransformKind::scale;
    return ui.transform.begin(state.document, nodes, kind, pivot_of(state.document.scene(), nodes), ui.pressed_at);
}

void drag_transform(AppState& state, Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool turns = ui.transform.kind() == TransformKind::turn;
    const double step = turns ? (io.KeyShift ? 15 : 1) : io.KeyShift ? 0.1 : 0.01;
    tell(state, ui.transform.update(state.document, ui.mouse_world, io.KeyCtrl ? 0 : step));
}

/// What goes along when the node under the mouse is dragged: with others selected, all of them.
std::vector<Held> nodes_in_hand(const AppState& state, const Hit& pressed) {
    std::vector<NodeId> nodes{pressed.node};
    if (state.selection.contains(pressed.node)) nodes = outermost(state.document.scene(), state.selection.nodes());
    std::vector<Held> held;
    for (const NodeId node : nodes) {
        held.push_back({node});
        if (node == pressed.node) held.back().own_from_hand = pressed.own_from_hand;
    }
    return held;
}

void begin_drag(AppState& state, Ui& ui) {
    if (begin_transform(state, ui)) return;
    if (!ui.pressed.node) {
        ui.marquee = true;
        return;
    }
    std::vector<Held> held = nodes_in_hand(state, ui.pressed);
    if (ui.copies) {
        std::vector<NodeId> nodes;
        nodes.reserve(held.size());
        for (const Held& one : held) nodes.push_back(one.node);
        const Outcome outcome = duplicate_nodes(state.document, nodes, {0, 0});
        ui.copies = take(state, outcome) && outcome.nodes.size() == held.size();
        for (std::size_t i = 0; ui.copies && i < held.size(); ++i) held[i].node = outcome.nodes[i];
        if (!ui.copies) {
            ui.pressing = false;  // what has no copy stays where it is
            return;
        }
    }
    ui.drag.begin(state.document, held, ui.pressed_at);
    std::vector<NodeId> nodes;
    ui.magnets = {};
    for (const Held& one : ui.drag.held()) {
        nodes.push_back(one.node);
        ui.magnets.box_before = ui.magnets.box_before.merged(bounds_of(state, one.node));
    }
    ui.magnets.others = magnets_for(state, nodes);
}

/// The nodes follow the hand, on the grid, or where edges and middles meet those of others.
void drag_nodes(AppState& state, Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    Vec2 grid = square_grid(io.KeyCtrl ? 0 : state.preferences.grid), hand = ui.mouse_world;
    ui.magnets.lines.clear();
    if (state.preferences.snapping && !io.KeyCtrl && ui.pressed.own_from_hand.isIdentity()) {
        Vec2 delta = hand - ui.pressed_at;
        if (io.KeyShift) delta[std::fabs(delta.x()) < std::fabs(delta.y()) ? 0 : 1] = 0;
        const Box2& before = ui.magnets.box_before;
        Snap held = snap({before.lo + delta, before.hi + delta}, ui.magnets.others, snap_pixels / state.view.pixels_per_metre);
        hand = ui.pressed_at + delta + held.push;
        for (const int axis : {0, 1})
            if (held.axis[axis]) grid[axis] = exact_grid;
        ui.magnets.lines = std::move(held.lines);
    }
    // The same drag may have been taken back by Esc: then the preview stays away until the next press.
    tell(state, ui.drag.update(state.document, hand, grid, io.KeyShift));
}

/// From left to right: what lies wholly in it; from right to left: what it touches.
void end_marquee(AppState& state, Ui& ui) {
    const Box2 box{ui.pressed_at.cwiseMin(ui.mouse_world), ui.pressed_at.cwiseMax(ui.mouse_world)};
    std::vector<NodeId> nodes = nodes_in(state, box, ui.mouse_world.x() < ui.pressed_at.x());
    if (ImGui::GetIO().KeyShift)
        for (const NodeId node : state.selection.nodes())
            if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) nodes.push_back(node);
    select(state, std::move(nodes));
}

/// A click that was no drag.
void click(AppState& state, const Ui& ui) {
    if (ImGui::GetIO().KeyShift) {  // with a drag, Shift locks the axis
        if (ui.pressed.node) state.selection.toggle(ui.pressed.node);
    } else if (!ui.double_click) {
        select(state, ui.pressed.node);
    }
}

void release(AppState& state, Ui& ui) {
    if (ui.handle_drag.active()) {
        tell(state, ui.handle_drag.end(state.document));
    } else if (ui.transform.active()) {
        tell(state, ui.transform.end(state.document));
    } else if (ui.drag.active()) {
        const std::size_t before = state.document.undo_steps();
        tell(state, ui.drag.end(state.document));
        if (ui.copies && state.document.undo_steps() > before) state.document.join_steps();
    } else if (ui.marquee) {
        end_marquee(state, ui);
    } else if (ui.pressing) {
        click(state, ui);
    }
    ui.pressing = ui.marquee = ui.copies = false;
    ui.pressed = {};
    ui.magnets = {};
}

void left_button(AppState& state, Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActivated() && io.MouseDown[0]) {
        press(state, ui);
    }
    if (!ImGui::IsItemActive()) {
        if (ui.guide_hand.index && !ui.guide_hand.is_new) release_guide(state, ui);
        if (ui.pressing || ui.handle_drag.active()) release(state, ui);
        return;
    }
    if (io.MouseDown[0] && ui.guide_hand.index) return drag_guide(state, ui);
    if (io.MouseDown[0] && ui.handle_drag.active()) return drag_handle(state, ui);
    if (!io.MouseDown[0] || !ui.pressing) return;
    const bool drags = ui.drag.active() || ui.transform.active() || ui.marquee;
    if (!drags && ImGui::IsMouseDragging(0, drag_threshold)) begin_drag(state, ui);
    if (ui.drag.active()) drag_nodes(state, ui);
    if (ui.transform.active()) drag_transform(state, ui);
}

/// A right click that was no pan asks for the menu of what lies under the mouse.
void right_button(AppState& state, Ui& ui) {
    if (ImGui::IsItemClicked(1)) ui.menu_at = ui.mouse;
    if (!ImGui::IsItemHovered() || !ImGui::IsMouseReleased(1) || length(ui.mouse - ui.menu_at) > drag_threshold) return;
    ui.under_mouse.clear();
    const Hit grip = grip_at(state, state.entered, ui.mouse_world, slack_of(state));
    if (grip.node) ui.under_mouse.push_back(grip.node);
    for (const Hit& hit : hits_at(state, ui.mouse_world, slack_of(state)))
        if (hit.node != grip.node) ui.under_mouse.push_back(hit.node);
    if (grip.node && !state.selection.contains(grip.node)) select(state, grip.node);
    ImGui::OpenPopup("##node_menu");
}

void pan_and_zoom(AppState& state, Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    View& view = state.view;
    if (ui.viewport_hovered && io.MouseWheel != 0) view.zoom_at(ui.mouse, std::pow(1.18, static_cast<double>(io.MouseWheel)));
    const bool on_nothing = ui.pressing && !ui.pressed.node;
    const bool wants = io.MouseDown[2] || io.MouseDown[1] || (io.MouseDown[0] && io.KeyAlt && on_nothing);
    if (ImGui::IsItemActive() && wants && !ui.drag.active() && !ui.handle_drag.active()) ui.panning = true;
    if (!wants) ui.panning = false;
    if (!ui.panning) return;
    ui.pressing = ui.marquee = false;
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    view.centre += Vec2(-io.MouseDelta.x, io.MouseDelta.y) / view.pixels_per_metre;
}

}  // namespace

std::vector<Box2> magnets_for(const AppState& state, const std::vector<NodeId>& nodes) {
    std::vector<Box2> boxes = boxes_beside(state, nodes);
    const auto add = [&](const std::vector<Box2>& lines) { boxes.insert(boxes.end(), lines.begin(), lines.end()); };
    add(mirror_axes(state, nodes));
    if (state.preferences.show_guides) add(boxes_of(state.aids.guides, state.session.program().size));
    return boxes;
}

void table_mouse(AppState& state, Ui& ui) {
    ui.viewport_hovered = ImGui::IsItemHovered();
    ui.mouse_world = state.view.world_from_pixel(ui.mouse);
    state.pointer = ui.viewport_hovered ? std::optional(ui.mouse_world) : std::nullopt;
    right_button(state, ui);
    pan_and_zoom(state, ui);
    if (state.tool == Tool::measure && !ui.panning) {
        measure(state, ui);
    } else if (state.tool == Tool::underlay && !ui.panning) {
        move_underlay(state, ui);
    } else if (!ui.panning) {
        left_button(state, ui);
    }
    const bool on_handle = ui.handle_drag.active() || handle_under_mouse(state, ui) >= 0;
    const bool on_nodes = state.tool != Tool::measure && state.tool != Tool::underlay;
    if (ui.viewport_hovered && !ui.panning && !on_handle && on_nodes)
        ui.hovered = grip_at(state, state.entered, ui.mouse_world, slack_of(state)).node;
    if (ImGui::BeginPopup("##node_menu")) {
        if (ui.under_mouse.size() > 1) {
            text_in(ui.theme.small, palette::quiet, "Under the mouse");
            for (const NodeId node : ui.under_mouse) {
                const Node* found = state.document.scene().find(node);
                const std::string label = found ? title_of(*found) + "##" + std::to_string(node.value) : "";
                if (found && ImGui::MenuItem(label.c_str(), nullptr, state.selection.contains(node))) select(state, node);
            }
            ImGui::Separator();
        }
        node_menu(state, ui);
        ImGui::EndPopup();
    }
}

bool cancel_drag(AppState& state, Ui& ui) {
    const bool guide = cancel_guide(state, ui), measured = state.tool == Tool::measure && ui.measurement;
    ui.measurement.reset();
    ui.measuring = false;
    const bool underlay = cancel_underlay(state, ui);
    const bool any = guide || measured || underlay || ui.drag.active() || ui.marquee || ui.handle_drag.active() || ui.transform.active();
    ui.handle_drag.cancel(state.document);
    ui.transform.cancel(state.document);
    ui.magnets = {};
    if (ui.drag.active()) {
        ui.drag.cancel(state.document);
        if (ui.copies) state.document.undo();
    }
    ui.pressing = ui.marquee = ui.copies = false;
    ui.pressed = {};
    return any;
}

}  // namespace pinfield::editor

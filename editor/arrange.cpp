#include "editor/arrange.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "editor/edit_tools.h"
#include "editor/handlers.h"
#include "editor/pick.h"
#include "engine/core/at.h"
#include "engine/scene/node_common.h"

namespace pinfield::editor {
namespace {

struct Placed {
    NodeId node;
    Box2 box;
};

/// What is selected and can be seen as a box.
std::vector<Placed> placed(const AppState& state) {
    std::vector<Placed> out;
    for (const NodeId node : outermost(state.document.scene(), state.selection.nodes())) {
        const Box2 box = bounds_of(state, node);
        if (!box.is_empty() && box.is_finite() && !state.document.scene().find(node)->is_record()) out.push_back({node, box});
    }
    return out;
}

Box2 around(const std::vector<Placed>& nodes) {
    Box2 all;
    for (const Placed& one : nodes) all = all.merged(one.box);
    return all;
}

bool has_several(const AppState& s) { return s.selection.nodes().size() > 1 && !s.document.previewing(); }

void do_all(AppState& state, const std::vector<Edit>& edits, const std::string& label) {
    const std::optional<std::string> why = edits.empty() ? std::nullopt : state.document.edit(edits, label);
    say(state, why.value_or(label), why.has_value());
}

/// Moves without a grid: the lines are to meet.
void move_each(AppState& state, const std::vector<Placed>& nodes, const std::vector<Vec2>& by, const std::string& label) {
    std::vector<Edit> edits;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Node& node = *state.document.scene().find(nodes[i].node);
        const SetField edit = moved(state.document.scene(), node.id, node.get<Vec2>("at"), by[i], square_grid(0));
        if (!identical(edit.value, node.value("at"))) edits.emplace_back(edit);
    }
    do_all(state, edits, label);
}

}  // namespace

void align(AppState& state, Align how) {
    const std::vector<Placed> nodes = placed(state);
    if (nodes.size() < 2) return say(state, "select two nodes or more to align them", true);
    const Box2 all = around(nodes);
    const auto line = [&](const Box2& box) {
        switch (how) {
            case Align::left: return Vec2(box.lo.x(), 0);
            case Align::middle: return Vec2(box.centre().x(), 0);
            case Align::right: return Vec2(box.hi.x(), 0);
            case Align::top: return Vec2(0, box.hi.y());
            case Align::centre: return Vec2(0, box.centre().y());
            case Align::bottom: return Vec2(0, box.lo.y());
        }
        return Vec2(0, 0);
    };
    std::vector<Vec2> by;
    for (const Placed& one : nodes) by.push_back(line(all) - line(one.box));
    move_each(state, nodes, by, fmt::format("Align {} nodes", nodes.size()));
}

void distribute(AppState& state, int axis) {
    std::vector<Placed> nodes = placed(state);
    if (nodes.size() < 3) return say(state, "select three nodes or more to space them evenly", true);
    std::sort(nodes.begin(), nodes.end(), [&](const Placed& a, const Placed& b) { return a.box.centre()[axis] < b.box.centre()[axis]; });
    double filled = 0;
    for (const Placed& one : nodes) filled += one.box.size()[axis];
    const double first = nodes.front().box.lo[axis], last = nodes.back().box.hi[axis];
    const double gap = (last - first - filled) / static_cast<double>(nodes.size() - 1);
    std::vector<Vec2> by;
    double next = first;
    for (const Placed& one : nodes) {
        Vec2 push(0, 0);
        push[axis] = next - one.box.lo[axis];
        by.push_back(push);
        next += one.box.size()[axis] + gap;
    }
    move_each(state, nodes, by, fmt::format("Space {} nodes evenly", nodes.size()));
}

void flip_selection(AppState& state, int axis) {
    const Scene& scene = state.document.scene();
    const std::vector<Placed> nodes = placed(state);
    if (nodes.empty()) return;
    const double middle = around(nodes).centre()[axis];
    std::vector<Edit> edits;
    const auto add = [&](const SetField& edit) {
        if (!identical(edit.value, at(scene.find(edit.node)->fields, edit.field).value)) edits.emplace_back(edit);
    };
    for (const Placed& one : nodes) {
        const Node& node = *scene.find(one.node);
        const Similarity world_from_parent = node.parent ? world_from_local(scene, node.parent) : Similarity{};
        const Vec2 place = world_from_parent * node.get<Vec2>("at");
        Vec2 push(0, 0);
        push[axis] = 2 * (middle - place[axis]);
        const SetField place_after = moved(scene, node.id, node.get<Vec2>("at"), push, square_grid(0));
        add(place_after);
        // A reflection in an axis of the parent's frame: F R(turn) S F' = R(-turn) S F F'. Twice x and y is half a turn.
        if (world_from_parent.cosine != 1 && world_from_parent.cosine != -1)
            return say(state, "what lies in a turned group cannot be mirrored in place", true);
        const std::string before = node.get<std::string>("flip"), name(choice_names(Flip{})[axis == 0 ? 1 : 2]);
        double turn = -node.get<double>("turn");
        std::string after = before == "none" ? name : "none";
        if (before != "none" && before != name) turn += 180;
        turn = turn > 180 ? turn - 360 : turn;
        add({node.id, *node.type->find_field("flip"), after, true});
        add({node.id, *node.type->find_field("turn"), turn == 0 ? 0.0 : turn, true});
    }
    do_all(state, edits,
           nodes.size() == 1 ? fmt::format("Mirror {}", scene.path(nodes.front().node)) : fmt::format("Mirror {} nodes", nodes.size()));
}

std::span<const Handler> arrange_handlers() {
    static const Handler handlers[] = {
        {"edit.flip_x", has_selection, [](AppState& s) { flip_selection(s, 0); }},
        {"edit.flip_y", has_selection, [](AppState& s) { flip_selection(s, 1); }},
        {"align.left", has_several, [](AppState& s) { align(s, Align::left); }},
        {"align.middle", has_several, [](AppState& s) { align(s, Align::middle); }},
        {"align.right", has_several, [](AppState& s) { align(s, Align::right); }},
        {"align.top", has_several, [](AppState& s) { align(s, Align::top); }},
        {"align.centre", has_several, [](AppState& s) { align(s, Align::centre); }},
        {"align.bottom", has_several, [](AppState& s) { align(s, Align::bottom); }},
        {"align.space_x", has_several, [](AppState& s) { distribute(s, 0); }},
        {"align.space_y", has_several, [](AppState& s) { distribute(s, 1); }},
        {"tool.select", always, [](AppState& s) { s.tool = Tool::select; }, [](const AppState& s) { return s.tool == Tool::select; }},
        {"tool.move", always, [](AppState& s) { s.tool = Tool::move; }, [](const AppState& s) { return s.tool == Tool::move; }},
        {"tool.turn", always, [](AppState& s) { s.tool = Tool::turn; }, [](const AppState& s) { return s.tool == Tool::turn; }},
        {"tool.scale", always, [](AppState& s) { s.tool = Tool::scale; }, [](const AppState& s) { return s.tool == Tool::scale; }},
        {"tool.measure", always, [](AppState& s) { s.tool = Tool::measure; }, [](const AppState& s) { return s.tool == Tool::measure; }},
        {"tool.snap", always, [](AppState& s) { s.preferences.snapping = !s.preferences.snapping; },
         [](const AppState& s) { return s.preferences.snapping; }},
    };
    return handlers;
}

}  // namespace pinfield::editor

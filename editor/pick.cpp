// Finding scene nodes on the running table: what is under a point, and how far a node reaches.
#include <set>

#include "editor/app_state.h"
#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/program/evaluate.h"
#include "engine/scene/parts/domain.h"
#include "engine/scene/parts/spawn.h"

namespace pinfield::editor {
namespace {

constexpr double place_radius = 0.012;  ///< metres about a place that can be clicked

/// The best node so far: inside beats near; among those inside the smallest wins, else the nearest.
struct Candidate {
    NodeId node;
    double distance = infinity, area = infinity;

    void offer(NodeId other, double other_distance, double other_area) {
        const bool was_inside = node && distance <= 0, is_inside = other_distance <= 0;
        const bool better = was_inside != is_inside ? is_inside : is_inside ? other_area < area : other_distance < distance;
        if (better || !node) *this = {other, other_distance, other_area};
    }
};

double area_of(const Box2& box) {
    if (!box.is_finite()) return infinity;
    return box.size().x() * box.size().y();
}

/// A scene node (the edge of a table without a domain belongs to the table's record), and neither it nor what it lies in is locked.
bool is_free(const Scene& scene, NodeId id) {
    const Node* node = scene.find(id);
    if (!node || node->is_record()) return false;
    for (; node; node = node->parent ? scene.find(node->parent) : nullptr)
        if (node->get<bool>("locked")) return false;
    return true;
}

void offer_solids(const AppState& state, const Field& field, const Vec2& p, double slack, Candidate& best) {
    for (std::size_t i = 0; i < field.solids.size(); ++i) {
        const Solid& solid = field.solids[i];
        const std::vector<Part>& parts = state.session.program().parts;
        if (solid.part >= 0 && at(parts, solid.part).is<parts::Domain>()) continue;
        if (solid.bounds.distance(p) > slack || !is_free(state.document.scene(), solid.origin)) continue;
        const double distance = nearest_of_solid(field, static_cast<int>(i), p).distance;
        if (distance <= slack) best.offer(solid.origin, distance, area_of(solid.bounds));
    }
}

/// Parts that have nothing to hit are found by their place.
void offer_places(const AppState& state, const Vec2& p, Candidate& best) {
    for (const Part& part : state.session.program().parts) {
        if (part.sensor < 0 && !part.is<parts::Spawn>()) continue;
        const double distance = length(p - part.world_from_part.offset) - place_radius;
        if (distance <= 0 && is_free(state.document.scene(), part.origin))
            best.offer(part.origin, distance, pi * place_radius * place_radius);
    }
}

std::set<NodeId> subtree(const Scene& scene, NodeId root) {
    std::set<NodeId> out;
    std::vector<NodeId> open{root};
    while (!open.empty()) {
        const Node* node = scene.find(open.back());
        open.pop_back();
        if (!node || !out.insert(node->id).second) continue;
        open.insert(open.end(), node->children.begin(), node->children.end());
    }
    return out;
}

Box2 bounds_in(const Field& field, const std::set<NodeId>& nodes) {
    Box2 box;
    for (const Op& op : field.ops)
        if (nodes.count(op.origin) && !op.bounds.is_empty()) box = box.merged(op.bounds);
    for (const Solid& solid : field.solids)
        if (nodes.count(solid.origin) && !solid.bounds.is_empty()) box = box.merged(solid.bounds);
    return box;
}

}  // namespace

NodeId pick(const AppState& state, const Vec2& world, double slack) {
    const Program& program = state.session.program();
    Candidate best;
    offer_solids(state, program.fixed, world, slack, best);
    for (std::size_t i = 0; i < program.movers.size(); ++i)
        offer_solids(state, program.movers[i].field, state.session.world_from_mover(static_cast<int>(i)).inverse() * world, slack, best);
    for (const Sensor& sensor : program.sensors) offer_solids(state, sensor.field, world, slack, best);
    offer_places(state, world, best);
    return best.node;
}

Box2 bounds_of(const AppState& state, NodeId node) {
    const Program& program = state.session.program();
    const std::set<NodeId> nodes = subtree(state.document.scene(), node);
    Box2 box = bounds_in(program.fixed, nodes);
    for (std::size_t i = 0; i < program.movers.size(); ++i)
        box = box.merged(state.session.world_from_mover(static_cast<int>(i)) * bounds_in(program.movers[i].field, nodes));
    for (const Sensor& sensor : program.sensors) box = box.merged(bounds_in(sensor.field, nodes));
    if (!box.is_empty() || !state.document.scene().find(node)) return box;
    const Node& found = *state.document.scene().find(node);
    if (found.is_record()) return {{0, 0}, program.size};
    const Vec2 place = world_from_local(state.document.scene(), node).offset;
    return Box2{place, place}.grown(place_radius);
}

}  // namespace pinfield::editor

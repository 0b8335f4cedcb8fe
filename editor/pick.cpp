#include "editor/pick.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "editor/edit_tools.h"
#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/program/evaluate.h"
#include "engine/scene/parts/domain.h"
#include "engine/scene/parts/spawn.h"

namespace pinfield::editor {
namespace {

constexpr double place_radius = 0.012;  ///< metres about a place that can be clicked

double area_of(const Box2& box) {
    if (!box.is_finite()) return infinity;
    return box.size().x() * box.size().y();
}

/// A scene node (the edge of a table without a domain belongs to the table's record), and neither it nor what it lies in is locked.
bool is_free(const Scene& scene, NodeId id) {
    const Node* node = scene.find(id);
    return node && !node->is_record() && !is_locked(scene, *node);
}

/// A hit and what decides between several.
struct Candidate {
    Hit hit;
    double area = infinity;  ///< of its box, square metres

    bool is_inside() const { return hit.distance <= 0; }
    bool operator<(const Candidate& other) const {
        if (is_inside() != other.is_inside()) return is_inside();
        return is_inside() ? area < other.area : hit.distance < other.hit.distance;
    }
};

/// Each node once, the one meant most first.
std::vector<Hit> sorted(std::vector<Candidate> found) {
    std::stable_sort(found.begin(), found.end());
    std::vector<Hit> out;
    for (const Candidate& candidate : found)
        if (std::none_of(out.begin(), out.end(), [&](const Hit& hit) { return hit.node == candidate.hit.node; }))
            out.push_back(candidate.hit);
    return out;
}

/// The point as a field's frame has it, for every field of the program.
template <class Visit>
void for_each_field(const AppState& state, const Vec2& world, Visit visit) {
    const Program& program = state.session.program();
    visit(program.fixed, world);
    for (std::size_t i = 0; i < program.movers.size(); ++i)
        visit(program.movers[i].field, state.session.world_from_mover(static_cast<int>(i)).inverse() * world);
    for (const Sensor& sensor : program.sensors) visit(sensor.field, world);
}

void offer_solids(const AppState& state, const Field& field, const Vec2& p, double slack, std::vector<Candidate>& found) {
    for (std::size_t i = 0; i < field.solids.size(); ++i) {
        const Solid& solid = field.solids[i];
        if (solid.is_domain || solid.bounds.distance(p) > slack || !is_free(state.document.scene(), solid.origin)) continue;
        const double distance = nearest_of_solid(field, static_cast<int>(i), p).distance;
        if (distance <= slack) found.push_back({{solid.origin, distance}, area_of(solid.bounds)});
    }
}

/// Parts that have nothing to hit are found by their place.
void offer_places(const AppState& state, const Vec2& p, std::vector<Candidate>& found) {
    for (const Part& part : state.session.program().parts) {
        if (part.sensor < 0 && !part.is<parts::Spawn>()) continue;
        const double distance = length(p - part.world_from_part.offset) - place_radius;
        if (distance <= 0 && is_free(state.document.scene(), part.origin))
            found.push_back({{part.origin, distance}, pi * place_radius * place_radius});
    }
}

/// Goes down a solid's tree to the children of one node, taking the point along through copies and warps.
class Descent {
public:
    Descent(const AppState& state, const Field& field, NodeId parent, double slack, std::vector<Candidate>& found)
        : scene_(state.document.scene()), field_(field), parent_(parent), slack_(slack), found_(found) {}

    /// `seen_from_hand`: how the point `p` moves where the hand moves.
    void visit(int index, const Vec2& p, const Eigen::Matrix2d& seen_from_hand) {
        const Op& op = at(field_.ops, index);
        const Node* node = scene_.find(op.origin);
        if (node && node->parent == parent_) return offer(index, p, seen_from_hand);
        if (op.kernels->form == sdf::Form::warp) {
            const sdf::Warped warped = op.kernels->warped(field_.params.data() + op.params, op.local_from_field * p);
            Eigen::Matrix2d local;
            local << warped.from_x, warped.from_y;
            const Similarity field_from_local = op.local_from_field.inverse();
            return visit_children(op, field_from_local * warped.point,
                                  linear(field_from_local) * local * linear(op.local_from_field) * seen_from_hand);
        }
        if (op.kernels->form != sdf::Form::images) return visit_children(op, p, seen_from_hand);
        for (int i = 0; i < op.image_count; ++i) {
            const Similarity child_from_image = at(field_.images, op.first_image + i).inverse();
            visit_children(op, child_from_image * p, linear(child_from_image) * seen_from_hand);
        }
    }

private:
    static Eigen::Matrix2d linear(const Similarity& map) {
        Eigen::Matrix2d out;
        out << map.scale * map.direction({1, 0}), map.scale * map.direction({0, 1});
        return out;
    }

    void visit_children(const Op& op, const Vec2& p, const Eigen::Matrix2d& seen_from_hand) {
        for (int i = 0; i < op.child_count; ++i) visit(at(field_.links, op.first_link + i), p, seen_from_hand);
    }

    void offer(int index, const Vec2& p, const Eigen::Matrix2d& seen_from_hand) {
        const Op& op = at(field_.ops, index);
        if (op.bounds.distance(p) > slack_ || !is_free(scene_, op.origin)) return;
        const double distance = evaluate_tree(field_, index, p).value;
        if (distance <= slack_) found_.push_back({{op.origin, distance, seen_from_hand}, area_of(op.bounds)});
    }

    const Scene& scene_;
    const Field& field_;
    NodeId parent_;
    double slack_;
    std::vector<Candidate>& found_;
};

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
        if (nodes.contains(op.origin) && !op.bounds.is_empty()) box = box.merged(op.bounds);
    for (const Solid& solid : field.solids)
        if (nodes.contains(solid.origin) && !solid.bounds.is_empty()) box = box.merged(solid.bounds);
    return box;
}

}  // namespace

std::vector<Hit> hits_at(const AppState& state, const Vec2& world, double slack) {
    std::vector<Candidate> found;
    for_each_field(state, world, [&](const Field& field, const Vec2& p) { offer_solids(state, field, p, slack, found); });
    offer_places(state, world, found);
    return sorted(std::move(found));
}

NodeId pick(const AppState& state, const Vec2& world, double slack) {
    const std::vector<Hit> hits = hits_at(state, world, slack);
    return hits.empty() ? NodeId{} : hits.front().node;
}

std::vector<Hit> hits_within(const AppState& state, NodeId parent, const Vec2& world, double slack) {
    const Scene& scene = state.document.scene();
    const Node* node = scene.find(parent);
    if (!node || node->children.empty()) return {};
    bool is_domain = false;
    std::vector<Candidate> found;
    for_each_field(state, world, [&](const Field& field, const Vec2& p) {
        for (const Solid& solid : field.solids) {
            const bool related = solid.origin == parent || scene.is_within(solid.origin, parent) || scene.is_within(parent, solid.origin);
            if (!related) continue;
            is_domain = is_domain || (solid.is_domain && solid.origin == parent);
            Descent(state, field, parent, solid.is_domain ? infinity : slack, found).visit(solid.root, p, Eigen::Matrix2d::Identity());
        }
    });
    if (!is_domain) return sorted(std::move(found));
    // In play every point is inside of a piece: what is meant is an outline near by, or, from within the wall, the nearest one.
    const bool in_wall = std::none_of(found.begin(), found.end(), [](const Candidate& candidate) { return candidate.is_inside(); });
    for (Candidate& candidate : found) candidate.hit.distance = std::fabs(candidate.hit.distance);
    if (!in_wall) std::erase_if(found, [&](const Candidate& candidate) { return candidate.hit.distance > slack; });
    return sorted(std::move(found));
}

Hit grip_at(const AppState& state, NodeId entered, const Vec2& world, double slack) {
    if (entered)
        if (const std::vector<Hit> within = hits_within(state, entered, world, slack); !within.empty()) return within.front();
    const std::vector<Hit> hits = hits_at(state, world, slack);
    return hits.empty() ? Hit{} : hits.front();
}

Similarity shown_from_local(const AppState& state, NodeId node) {
    const Scene& scene = state.document.scene();
    const Similarity world_from_node = world_from_local(scene, node);
    const Program& program = state.session.program();
    for (std::size_t i = 0; i < program.movers.size(); ++i) {
        const Part& part = at(program.parts, program.movers[i].part);
        if (part.origin == node || !scene.find(part.origin) || !scene.is_within(node, part.origin)) continue;
        const Similarity world_from_part = world_from_local(scene, part.origin);
        const Similarity mover_from_part{.scale = world_from_part.scale, .mirrored = world_from_part.mirrored};
        return state.session.world_from_mover(static_cast<int>(i)) * mover_from_part * world_from_part.inverse() * world_from_node;
    }
    return world_from_node;
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

std::vector<Box2> boxes_beside(const AppState& state, const std::vector<NodeId>& without) {
    const Program& program = state.session.program();
    std::set<NodeId> left_out;
    const Scene& scene = state.document.scene();
    for (const NodeId node : without) {
        left_out.merge(subtree(scene, node));
        // What it lies in has edges that are its own: they would hold it where it is.
        for (NodeId above = scene.find(node)->parent; above; above = scene.find(above)->parent) left_out.insert(above);
    }
    std::vector<Box2> out{{{0, 0}, program.size}};
    const auto offer = [&](const Field& field, const Similarity& world_from_field) {
        for (const Solid& solid : field.solids)
            if (!solid.is_domain && !solid.bounds.is_empty() && solid.bounds.is_finite() && !left_out.contains(solid.origin))
                out.push_back(world_from_field * solid.bounds);
    };
    offer(program.fixed, {});
    for (std::size_t i = 0; i < program.movers.size(); ++i)
        offer(program.movers[i].field, state.session.world_from_mover(static_cast<int>(i)));
    for (const Sensor& sensor : program.sensors) offer(sensor.field, {});
    return out;
}

std::vector<Box2> mirror_axes(const AppState& state, const std::vector<NodeId>& without) {
    const Program& program = state.session.program();
    const Field& field = program.fixed;
    std::set<NodeId> left_out;
    for (const NodeId node : without) left_out.merge(subtree(state.document.scene(), node));
    std::vector<Box2> out;
    for (const Op& op : field.ops) {
        if (left_out.contains(op.origin)) continue;
        for (int i = 0; i < op.image_count; ++i) {
            const Similarity& image = at(field.images, op.first_image + i);
            const Vec2 moved = image.offset;
            for (const int axis : {0, 1}) {
                Vec2 along(0, 0), across(0, 0);
                across[axis] = along[1 - axis] = 1;
                const bool reflects = image.mirrored && image.scale == 1 && length(image.direction(across) + across) < 1e-9 &&
                                      length(image.direction(along) - along) < 1e-9;
                if (!reflects || std::fabs(moved[1 - axis]) > 1e-9) continue;
                Box2 line{{0, 0}, program.size};
                line.lo[axis] = line.hi[axis] = 0.5 * moved[axis];
                out.push_back(line);
            }
        }
    }
    return out;
}

std::vector<NodeId> nodes_in(const AppState& state, const Box2& world, bool touching) {
    const Program& program = state.session.program();
    std::set<NodeId> found;
    const auto offer = [&](NodeId node) {
        if (!is_free(state.document.scene(), node)) return;
        const Box2 box = bounds_of(state, node);
        if (touching ? box.overlaps(world) : !box.is_empty() && world.contains(box.lo) && world.contains(box.hi)) found.insert(node);
    };
    for (const Solid& solid : program.fixed.solids)
        if (!solid.is_domain) offer(solid.origin);
    for (const Part& part : program.parts)
        if (!part.is<parts::Domain>()) offer(part.origin);
    std::vector<NodeId> out;
    for (const NodeId node : state.document.scene().all())
        if (found.contains(node)) out.push_back(node);
    return out;
}

NodeId compound_around(const Scene& scene, NodeId node) {
    const Node* found = scene.find(node);
    const Node* parent = found ? scene.find(found->parent) : nullptr;
    return parent && parent->type->key() != "group" ? parent->id : NodeId{};
}

}  // namespace pinfield::editor

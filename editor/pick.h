// Finding scene nodes on the running table: what is under a point or in a box, and how far a node reaches. No window, no ImGui.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "editor/app_state.h"

namespace pinfield::editor {

/// A node under a point.
struct Hit {
    NodeId node;
    double distance = infinity;  ///< signed, metres: at most 0 inside
    /// The node's own motion, in the world, where what the hand holds moves by a vector of the world: turned or mirrored where that is one
    /// of the copies that mirror, repeat or a warp show of it.
    Eigen::Matrix2d own_from_hand = Eigen::Matrix2d::Identity();
};

/// Scene nodes whose solid is at (or within `slack` metres of) a world point, movers included, the one meant most first: what the point is
/// inside of, the smallest before all, then what is nearest. Sensors answer within their region, and every part with no solid within 12 mm
/// of its place. Locked nodes do not count, nor does the domain, nor groups: their members do.
std::vector<Hit> hits_at(const AppState& state, const Vec2& world, double slack);
/// The first of them, or none in free space.
NodeId pick(const AppState& state, const Vec2& world, double slack);

/// The children of an operator or part under a point, in the order of hits_at(); of the domain, the pieces whose
/// outline is within `slack`, or, from within the wall, all of them, the nearest first.
std::vector<Hit> hits_within(const AppState& state, NodeId parent, const Vec2& world, double slack);

/// What a hand at this point takes hold of: a child of `entered` where that has one there, else the first of hits_at().
Hit grip_at(const AppState& state, NodeId entered, const Vec2& world, double slack);

/// A node's frame -> where it stands in the world now: in a mover, where that has turned or slid to. Of what mirrors, repeats or warps show of
/// it, the original.
Similarity shown_from_local(const AppState& state, NodeId node);

/// World box around a node and all below it as it runs now; at least its place, 12 mm about. May be infinite.
Box2 bounds_of(const AppState& state, NodeId node);

/// World boxes of all solids and regions but the domain's and those in `without`, as they stand now; and the table's own.
std::vector<Box2> boxes_beside(const AppState& state, const std::vector<NodeId>& without);

/// The upright and level lines in which something that stands still is mirrored, but for what lies in `without`; as boxes without extent, as
/// long as the table.
std::vector<Box2> mirror_axes(const AppState& state, const std::vector<NodeId>& without);

/// What hits_at() can find, in a box of the world: wholly, or (`touching`) in part.
std::vector<NodeId> nodes_in(const AppState& state, const Box2& world, bool touching);

/// The operator or part whose children are edited when this node is: its parent, unless that is a group or none.
NodeId compound_around(const Scene& scene, NodeId node);

}  // namespace pinfield::editor

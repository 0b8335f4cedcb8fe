// The searches of bvh.h, as templates over what is done with an entry.
#pragma once
#include "engine/core/at.h"
#include "engine/program/bvh.h"

namespace pinfield {

namespace detail {

/// The build never makes a tree deeper than this; a search keeps one pending node a level.
inline constexpr int bvh_depth = 64;

inline double squared_distance(const Bvh::TreeNode& node, const Vec2& p) {
    const double dx =
        std::max(std::max(static_cast<double>(node.lo_x) - p.x(), p.x() - static_cast<double>(node.hi_x)), 0.0);
    const double dy =
        std::max(std::max(static_cast<double>(node.lo_y) - p.y(), p.y() - static_cast<double>(node.hi_y)), 0.0);
    return dx * dx + dy * dy;
}

inline bool overlap(const Bvh::TreeNode& node, const Box2& box) {
    return static_cast<double>(node.lo_x) <= box.hi.x() && box.lo.x() <= static_cast<double>(node.hi_x) &&
           static_cast<double>(node.lo_y) <= box.hi.y() && box.lo.y() <= static_cast<double>(node.hi_y);
}

}  // namespace detail

template <class Visit>
void Bvh::nearest_squared(const Vec2& p, double reach_squared, Visit&& visit) const {
    double reach = reach_squared;
    for (const int entry : unbounded_) reach = visit(entry);
    if (nodes_.empty()) return;
    struct Pending {
        double distance;
        int node;
    };
    Pending pending[detail::bvh_depth];
    int depth = 0;
    Pending here{detail::squared_distance(nodes_[0], p), 0};
    while (true) {
        if (here.distance <= reach) {
            const TreeNode& node = at(nodes_, here.node);
            if (node.count == 0) {
                const TreeNode* children = nodes_.data() + node.first;
                const Pending left{detail::squared_distance(children[0], p), node.first};
                const Pending right{detail::squared_distance(children[1], p), node.first + 1};
                const bool right_first = right.distance < left.distance;
                const Pending& farther = right_first ? left : right;
                pending[depth] = farther;
                depth += farther.distance <= reach ? 1 : 0;
                here = right_first ? right : left;
                continue;
            }
            for (int i = 0; i < node.count; ++i) reach = visit(at(order_, node.first + i));
        }
        if (depth == 0) return;
        here = pending[--depth];
    }
}

template <class Visit>
void Bvh::nearest(const Vec2& p, double reach, Visit&& visit) const {
    nearest_squared(p, reach * reach, [&](int entry) {
        const double shorter = visit(entry);
        return shorter * shorter;
    });
}

template <class Visit>
void Bvh::overlapping(const Box2& box, Visit&& visit) const {
    for (const int entry : unbounded_) visit(entry);
    if (nodes_.empty()) return;
    int pending[detail::bvh_depth + 1];
    int depth = 0;
    pending[depth++] = 0;
    while (depth > 0) {
        const TreeNode& node = at(nodes_, pending[--depth]);
        if (!detail::overlap(node, box)) continue;
        if (node.count == 0) {
            pending[depth++] = node.first + 1;
            pending[depth++] = node.first;
        } else {
            for (int i = 0; i < node.count; ++i) visit(at(order_, node.first + i));
        }
    }
}

}  // namespace pinfield

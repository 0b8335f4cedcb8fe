// Bounding volume hierarchy over boxes, for nearest-first searches in a union: the one operator where skipping what is
// farther than the best so far is always right.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "engine/core/geometry.h"

namespace pinfield {

class Bvh {
public:
    Bvh() = default;
    /// Builds over entries 0 ... boxes.size() - 1; infinite boxes are allowed and always visited, empty ones never.
    explicit Bvh(std::span<const Box2> boxes);

    /// Calls visit(entry) for entries whose box is nearer to p than `reach`, near boxes first; visit returns the new
    /// reach (at most the old one). Order is a function of the boxes and p alone. A box exactly at reach is still
    /// visited.
    template <class Visit>
    void nearest(const Vec2& p, double reach, Visit&& visit) const;
    /// The same with squares of distances throughout: spares a root for every box.
    template <class Visit>
    void nearest_squared(const Vec2& p, double reach_squared, Visit&& visit) const;

    /// Calls visit(entry) for every entry whose box overlaps `box`.
    template <class Visit>
    void overlapping(const Box2& box, Visit&& visit) const;

    /// Floats, rounded outwards with room to spare: half the memory, and rounding never prunes the nearest entry.
    struct TreeNode {
        float lo_x = 0, lo_y = 0, hi_x = 0, hi_y = 0;
        int first = 0;  ///< leaf: first entry in order_; inner: index of the left child, the right one follows it
        int count = 0;  ///< entries of a leaf; 0 for an inner node
    };

private:
    std::vector<TreeNode> nodes_;
    std::vector<int> order_;
    std::vector<int> unbounded_;
};

}  // namespace pinfield

#include "engine/program/bvh_search.h"

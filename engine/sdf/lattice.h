// A lattice of places along the axes of a local frame, and which of the copies that stand there matter where.
#pragma once
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/core/geometry.h"

namespace pinfield::sdf {

struct Lattice {
    Vec2 step{0, 0};  ///< metres from one column, and one row, to the next; 0: there is but one

    /// Columns and rows on either side of its own that a point between -step / 2 and step / 2 must ask, when the child lies in `child`
    /// (finite): of the copies of the foot, the nearest is no more than half a step away along either axis, and a copy of the child that
    /// holds the point reaches at least as far. At most `too_many` of each.
    std::array<int, 2> neighbours(const Box2& child) const {
        int out[2] = {0, 0};
        for (const int axis : {0, 1}) {
            const double reach = std::max(child.hi[axis], -child.lo[axis]);
            if (step[axis] > 0 && !child.is_empty()) out[axis] = clamped(1 + reach / step[axis] + 1e-9);
        }
        return {out[0], out[1]};
    }

    /// The offsets of all copies of the child that meet the window (finite, as the child); nothing where they are more than `too_many`.
    std::optional<std::vector<Vec2>> offsets_meeting(const Box2& window, const Box2& child) const {
        std::vector<Vec2> out;
        if (child.is_empty() || window.is_empty()) return out;
        int first[2] = {0, 0}, count[2] = {1, 1};
        for (const int axis : {0, 1}) {
            if (step[axis] == 0) continue;
            first[axis] = clamped((window.lo[axis] - child.hi[axis]) / step[axis]);
            count[axis] = clamped((window.hi[axis] - child.lo[axis]) / step[axis]) + 1 - first[axis] + 1;
        }
        if (count[0] > too_many || count[1] > too_many || count[0] * count[1] > too_many) return std::nullopt;
        for (int row = 0; row < count[1]; ++row)
            for (int column = 0; column < count[0]; ++column) out.emplace_back(step.cwiseProduct(Vec2(first[0] + column, first[1] + row)));
        return out;
    }

    static constexpr int too_many = 4096;

private:
    static int clamped(double steps) { return static_cast<int>(std::floor(std::clamp(steps, -1.0 * too_many, 1.0 * too_many))); }
};

}  // namespace pinfield::sdf

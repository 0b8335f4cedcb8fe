#include "editor/snap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pinfield::editor {
namespace {

constexpr double same = 1e-9;  ///< metres: lines no farther apart are one

std::array<double, 3> lines_of(const Box2& box, int axis) { return {box.lo[axis], box.centre()[axis], box.hi[axis]}; }

/// How far apart two boxes lie along the other axis.
double gap_between(const Box2& a, const Box2& b, int axis) { return std::max({0.0, a.lo[axis] - b.hi[axis], b.lo[axis] - a.hi[axis]}); }

/// The least push along an axis that brings a line of the box onto one of the others'.
bool nearest_line(const Box2& moved, std::span<const Box2> others, int axis, double reach, double& push) {
    bool found = false;
    double least = reach, least_gap = infinity;
    for (const Box2& other : others)
        for (const double there : lines_of(other, axis))
            for (const double here : lines_of(moved, axis)) {
                const double need = std::fabs(there - here), gap = gap_between(moved, other, 1 - axis);
                if (need > least + same || (need > least - same && gap >= least_gap && found)) continue;
                found = true;
                least = std::min(least, need);
                least_gap = gap;
                push = there - here;
            }
    return found;
}

void add_guides(const Box2& moved, std::span<const Box2> others, int axis, std::vector<Guide>& out) {
    for (const double here : lines_of(moved, axis)) {
        double lo = infinity, hi = -infinity;
        for (const Box2& other : others)
            for (const double there : lines_of(other, axis))
                if (std::fabs(there - here) <= same) lo = std::min(lo, other.lo[1 - axis]), hi = std::max(hi, other.hi[1 - axis]);
        if (lo > hi) continue;
        lo = std::min(lo, moved.lo[1 - axis]);
        hi = std::max(hi, moved.hi[1 - axis]);
        out.push_back(axis == 0 ? Guide{{here, lo}, {here, hi}} : Guide{{lo, here}, {hi, here}});
    }
}

}  // namespace

Snap snap(const Box2& moved, std::span<const Box2> others, double reach) {
    Snap out;
    if (moved.is_empty() || !moved.is_finite()) return out;
    for (const int axis : {0, 1}) out.axis[axis] = nearest_line(moved, others, axis, reach, out.push[axis]);
    const Box2 there{moved.lo + out.push, moved.hi + out.push};
    for (const int axis : {0, 1})
        if (out.axis[axis]) add_guides(there, others, axis, out.guides);
    return out;
}

}  // namespace pinfield::editor

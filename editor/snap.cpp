#include "editor/snap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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

void add_lines(const Box2& moved, std::span<const Box2> others, int axis, std::vector<SnapLine>& out) {
    const std::array<double, 3> lines = lines_of(moved, axis);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double here = lines[i];
        if (i > 0 && here == lines[i - 1]) continue;  // of what has no extent all three are one
        double lo = infinity, hi = -infinity;
        for (const Box2& other : others)
            for (const double there : lines_of(other, axis))
                if (std::fabs(there - here) <= same) lo = std::min(lo, other.lo[1 - axis]), hi = std::max(hi, other.hi[1 - axis]);
        if (lo > hi) continue;
        lo = std::min(lo, moved.lo[1 - axis]);
        hi = std::max(hi, moved.hi[1 - axis]);
        out.push_back(axis == 0 ? SnapLine{{here, lo}, {here, hi}} : SnapLine{{lo, here}, {hi, here}});
    }
}

/// Boxes with extent that share some of it with the moved one along the other axis.
std::vector<Box2> row_of(const Box2& moved, std::span<const Box2> others, int axis) {
    std::vector<Box2> row;
    for (const Box2& other : others)
        if (other.size().minCoeff() > 0 && gap_between(moved, other, 1 - axis) == 0 && moved.hi[1 - axis] > other.lo[1 - axis] &&
            other.hi[1 - axis] > moved.lo[1 - axis])
            row.push_back(other);
    return row;
}

/// Three boxes, the moved one among them, with the same gap between the first and second as between the second and third.
struct EqualGaps {
    double push = 0;
    Box2 first, second, third;  ///< the moved one after the push
};

SnapLine gap_line(const Box2& a, const Box2& b, int axis) {
    const int across = 1 - axis;
    const double middle = 0.5 * (std::max(a.lo[across], b.lo[across]) + std::min(a.hi[across], b.hi[across]));
    SnapLine line{{0, 0}, {0, 0}, SnapLine::Kind::gap};
    line.a[axis] = a.hi[axis], line.b[axis] = b.lo[axis];
    line.a[across] = line.b[across] = middle;
    return line;
}

/// Nothing of a row begins or ends between two of it.
bool is_clear(const Box2& a, const Box2& b, const std::vector<Box2>& row, int axis) {
    const auto between = [&](double x) { return x > a.hi[axis] + same && x < b.lo[axis] - same; };
    return std::none_of(row.begin(), row.end(), [&](const Box2& box) { return between(box.lo[axis]) || between(box.hi[axis]); });
}

std::optional<EqualGaps> equal_gaps(const Box2& moved, std::span<const Box2> others, int axis, double reach) {
    const std::vector<Box2> row = row_of(moved, others, axis);
    std::optional<EqualGaps> best;
    const auto pushed = [&](double push) {
        Box2 box = moved;
        box.lo[axis] += push;
        box.hi[axis] += push;
        return box;
    };
    const auto offer = [&](double push, const Box2& first, const Box2& second, const Box2& third) {
        if (second.lo[axis] - first.hi[axis] <= same || std::fabs(push) > reach || (best && std::fabs(push) >= std::fabs(best->push)))
            return;
        if (is_clear(first, second, row, axis) && is_clear(second, third, row, axis)) best = EqualGaps{push, first, second, third};
    };
    for (const Box2& a : row)
        for (const Box2& b : row) {
            const double gap = b.lo[axis] - a.hi[axis];
            if (gap <= same || gap_between(a, b, 1 - axis) > 0) continue;
            const double between = 0.5 * (a.hi[axis] + b.lo[axis] - moved.lo[axis] - moved.hi[axis]);
            offer(between, a, pushed(between), b);
            const double after = b.hi[axis] + gap - moved.lo[axis], before = a.lo[axis] - gap - moved.hi[axis];
            offer(after, a, b, pushed(after));
            offer(before, pushed(before), a, b);
        }
    return best;
}

}  // namespace

Snap snap(const Box2& moved, std::span<const Box2> others, double reach, const SnapWish& wish) {
    Snap out;
    if (moved.is_empty() || !moved.is_finite()) return out;
    std::optional<EqualGaps> gaps[2];
    for (const int axis : {0, 1}) {
        if (!wish.along[axis]) continue;
        out.axis[axis] = nearest_line(moved, others, axis, reach, out.push[axis]);
        if (!wish.gaps) continue;
        gaps[axis] = equal_gaps(moved, others, axis, out.axis[axis] ? std::max(0.0, std::fabs(out.push[axis]) - same) : reach);
        if (!gaps[axis]) continue;
        out.axis[axis] = true;
        out.push[axis] = gaps[axis]->push;
    }
    const Box2 there{moved.lo + out.push, moved.hi + out.push};
    for (const int axis : {0, 1}) {
        if (out.axis[axis]) add_lines(there, others, axis, out.lines);
        if (!gaps[axis]) continue;
        out.lines.push_back(gap_line(gaps[axis]->first, gaps[axis]->second, axis));
        out.lines.push_back(gap_line(gaps[axis]->second, gaps[axis]->third, axis));
    }
    return out;
}

}  // namespace pinfield::editor

#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/lattice.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Copies of the child without end, along x, along y or both, united. A point is folded into the middle cell (Quilez,
/// "domain repetition") and asks the child and as many of its copies on either side as lattice.h finds to matter, so that the distance is
/// right however far the child reaches out of its cell, as outside of it the child's is.
template <class Real>
struct RepeatInfinite {
    static constexpr double least_step = 1e-4;  // metres: several hundred floats wide where a table lies

    Point<Real> step{Real(0.05), Real(0.05)};

    Point<Real> warp(const Point<Real>& p) const { return {folded(p.x, step.x), folded(p.y, step.y)}; }
    static Real folded(const Real& x, const Real& step) {
        return x - step * floor(x / max(step, Real(least_step)) + Real(0.5));
    }
    Lattice lattice() const { return {{step.x, step.y}}; }

    Exactness exactness(std::span<const Exactness> children) const { return {children[0].outside, Side::bound, children[0].lipschitz}; }
    Box2 bounds(std::span<const Box2> children) const {
        Box2 out = children[0];
        if (out.is_empty()) return out;
        if (step.x > 0) out.lo.x() = -infinity, out.hi.x() = infinity;
        if (step.y > 0) out.lo.y() = -infinity, out.hi.y() = infinity;
        return out;
    }

    static constexpr auto describe() {
        using T = RepeatInfinite;
        return operation<T>(
            {.key = "repeat_infinite",
             .exactness = {.inside = Side::bound},
             .float_error = 2e-6,
             .children = {1, 1},
             .doc = "Copies of the child without end."},
            fields(field(
                "step", &T::step,
                {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "From one column, and one row, to the next; 0: only one."})),
            contract("a step along x or y", [](const auto& r) { return r.step.x > 0 || r.step.y > 0; }),
            contract("no step below 0.1 mm but 0",
                     [](const auto& r) { return (r.step.x == 0 || r.step.x >= least_step) && (r.step.y == 0 || r.step.y >= least_step); }));
    }
};

}  // namespace pinfield::sdf

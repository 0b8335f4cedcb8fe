#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// The child cut along its local axes and pulled apart, what is between drawn straight (Quilez, "distfunctions2d", elongation). A point
/// nearer to the middle than the stretch looks at the child's own middle; filled, it also counts the way to the stretch's edge.
/// Not filled, it counts a fifty-thousandth of the stretch, so that a middle on the child's own outline is solid and no plane of zeros.
template <class Real>
struct Elongate {
    Point<Real> by{Real(0.05), Real(0)};
    bool filled = true;

    Point<Real> warp(const Point<Real>& p) const {
        return {sign(p.x) * max(abs(p.x) - by.x * Real(0.5), Real(0)), sign(p.y) * max(abs(p.y) - by.y * Real(0.5), Real(0))};
    }
    Real lift(const Point<Real>& p) const {
        const Real roof = (by.x + by.y) * Real(filled ? -1 : -2e-5);
        return min(Real(0), max(max(abs(p.x) - by.x * Real(0.5), abs(p.y) - by.y * Real(0.5)), roof));
    }

    Exactness exactness(std::span<const Exactness> children) const {
        if (by.x == 0 && by.y == 0) return children[0];
        return {Side::bound, Side::bound, max(1.0, children[0].lipschitz)};
    }
    /// A filled middle is solid where it is deeper than the child is away from its own.
    Box2 bounds(std::span<const Box2> children) const {
        const Vec2 half(0.5 * by.x, 0.5 * by.y);
        const Box2& child = children[0];
        if (child.is_empty()) return Box2::centred(half.x(), half.y());
        return Box2{child.lo - half, child.hi + half}.merged(filled ? Box2::centred(half.x(), half.y()) : Box2::empty());
    }

    static constexpr auto describe() {
        using T = Elongate;
        return operation<T>({.key = "elongate",
                             .exactness = {Side::bound, Side::bound},
                             .children = {1, 1},
                             .doc = "The child cut along its local axes and pulled apart."},
                            fields(field("by", &T::by,
                                         {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "Length added along x and along y."}),
                                   field("filled", &T::filled,
                                         {.doc = "The inside counts the way to the stretch's edge; otherwise it is flat there."})));
    }
};

}  // namespace pinfield::sdf

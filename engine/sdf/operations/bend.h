#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/waves.h"

namespace pinfield::sdf {

/// The child's x axis bent upwards into a parabola over a length about the local origin, and on in straight lines. Bending shifts
/// every point along y: a shear by the parabola's slope, at most 4 sag / length. The field is divided by what it stretches.
template <class Real>
struct Bend {
    Real sag = Real(0.02);
    Real length = Real(0.1);

    Real height(const Real& x) const {
        const Real far = abs(x), curved = min(far, length * Real(0.5));
        return sag * Real(4) * (curved * curved / length + (far - curved)) / length;
    }
    Point<Real> warp(const Point<Real>& p) const { return {p.x, p.y - height(p.x)}; }
    double factor() const { return 1 / stretch_of_shear(4 * sag / length); }

    Exactness exactness(std::span<const Exactness> children) const {
        if (sag == 0) return children[0];
        return {Side::bound, Side::bound, children[0].lipschitz};
    }
    Box2 bounds(std::span<const Box2> children) const {
        const Box2& child = children[0];
        if (child.is_empty() || sag == 0) return child;
        const double left = height(child.lo.x()), right = height(child.hi.x());
        const bool straddles = child.lo.x() < 0 && child.hi.x() > 0;
        const double low = straddles ? min(0.0, min(left, right)) : min(left, right);
        const double high = straddles ? max(0.0, max(left, right)) : max(left, right);
        return {child.lo + Vec2(0, low), child.hi + Vec2(0, high)};
    }

    static constexpr auto describe() {
        return operation<Bend>(
            {.key = "bend",
             .exactness = {Side::bound, Side::bound},
             .float_error = 4e-6,
             .children = {1, 1},
             .doc = "The child's x axis bent into a parabola."},
            fields(
                field(
                    "sag", &Bend::sag,
                    {.unit = Unit::metre, .step = 0.001, .doc = "How much higher than its middle either end of the length comes to lie."}),
                field("length", &Bend::length, {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Of the part that bends."})),
            contract("the sag is at most the length", [](const auto& b) { return -b.length <= b.sag && b.sag <= b.length; }));
    }
};

}  // namespace pinfield::sdf

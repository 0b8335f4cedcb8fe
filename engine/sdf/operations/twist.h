#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/waves.h"

namespace pinfield::sdf {

/// The child stirred about the local origin: turned by the full angle there, by less outwards, and not at all beyond the radius.
/// At distance r the turn is angle (1 - u)^2 with u = (r / radius)^2; the map shears by r times its slope, 4 |angle| u (1 - u), which is
/// never more than the angle in radians. The field is divided by what such a shear stretches, so that it is a bound.
template <class Real>
struct Twist {
    Real angle = Real(90);
    Real radius = Real(0.08);

    /// Turned back: the child is asked where the point comes from.
    Point<Real> warp(const Point<Real>& p) const {
        const Real u = (p.x * p.x + p.y * p.y) / (radius * radius);
        const Real left = max(Real(1) - u, Real(0));
        const Real turns = angle * Real(-1.0 / 360) * left * left;
        const Real c = cosine_of_turns(turns), s = sine_of_turns(turns);
        return {c * p.x - s * p.y, s * p.x + c * p.y};
    }
    double factor() const { return 1 / stretch_of_shear(radians(angle)); }

    Exactness exactness(std::span<const Exactness> children) const {
        if (angle == 0) return children[0];
        return {Side::bound, Side::bound, children[0].lipschitz};
    }
    Box2 bounds(std::span<const Box2> children) const {
        const Box2& child = children[0];
        if (child.is_empty()) return child;
        const Vec2 farthest = child.lo.cwiseAbs().cwiseMax(child.hi.cwiseAbs());
        const double reach = min(radius, length(farthest));
        return child.distance({0, 0}) > radius ? child : child.merged(Box2::centred(reach, reach));
    }

    static constexpr auto describe() {
        return operation<Twist>({.key = "twist",
                                 .exactness = {Side::bound, Side::bound},
                                 .float_error = 4e-6,
                                 .children = {1, 1},
                                 .doc = "The child stirred about the local origin."},
                                fields(field("angle", &Twist::angle,
                                             {.unit = Unit::degree, .min = from(-720), .max = to(720), .step = 1,
                                              .doc = "How far the middle turns, counter-clockwise."}),
                                       field("radius", &Twist::radius,
                                             {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Where the turning ends."})));
    }
};

}  // namespace pinfield::sdf

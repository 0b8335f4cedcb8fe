#pragma once
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/parabola_hill.h"

namespace pinfield::sdf {

/// What a circle becomes when each of its quarters is one quadratic Bezier curve with its middle control point in the corner of the
/// square around it: a little fuller than the disc (Quilez, distfunctions2d). In the first quadrant the outline is the parabola
/// x + y = (3r - (x - y)^2 / r) / 2.
template <class Real>
struct QuadraticCircle {
    Real radius = Real(0.05);

    static constexpr bool convex = true;

    /// Folded into an eighth, where the slope at the foot goes from 0 on the diagonal to 1 on the axis.
    Real distance(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        constexpr double half_root = 0.70710678118654752440;
        const Real x = abs(p.x), y = abs(p.y);
        const Point<Real> q{abs(x - y) * Real(half_root), (x + y - Real(1.5) * radius) * Real(half_root)};
        const Plain bend = frozen(radius) * Plain(half_root);
        const Plain m = min(slope_of_hill_at_foot(Point<Plain>{frozen(q.x), frozen(q.y)}, bend), Plain(1));
        return distance_to_hill(q, m, bend);
    }
    Box2 bounds() const { return Box2::centred(radius, radius); }

    static constexpr auto describe() {
        return shape<QuadraticCircle>(
            {.key = "quadratic_circle", .doc = "Disc about the local origin whose quarters are parabolas."},
            fields(field("radius", &QuadraticCircle::radius,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the centre along x and along y."})));
    }
};

}  // namespace pinfield::sdf

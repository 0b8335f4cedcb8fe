// Signed distance to the solid below a parabola, y <= -x^2 / 2R with R the radius of curvature on its top, for every scalar.
#pragma once
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// x^(21/64) by square roots: within 1 % of the cube root per factor 7 between x and 1.
template <class R>
R nearly_cube_root(const R& x) {
    return sqrt(sqrt(x * sqrt(sqrt(x * sqrt(sqrt(x))))));
}

/// Slope m >= 0 of the hill's side at its point nearest to p, which lies on the side p.x >= 0: the normal there is along (m, 1), the point
/// is (R m, -R m^2 / 2). m is the largest root of m^3 / 2 + q m = x, with lengths in radii and q = 1 + y. That cubic is convex for m >= 0
/// and starts at or below 0, so that Newton's steps from an upper bound come down to it wherever the point lies, also inside
/// the evolute. The bounds are within a factor 3 of the root at any scale; eight steps bring that to the last digit.
template <class R>
R slope_of_hill_at_foot(const Point<R>& p, const R& radius) {
    const R x = p.x / radius, q = R(1) + p.y / radius;
    const R cubic_bound = R(1.3) * nearly_cube_root(R(2) * x);
    R m = select(q < R(0), sqrt(R(2) * max(-q, R(0))) + cubic_bound, min(cubic_bound, x / max(q, R(1e-20))));
    for (int step = 0; step < 8; ++step) {
        const R half_square = R(0.5) * m * m;
        m = max(m - (m * (half_square + q) - x) / max(R(3) * half_square + q, R(1e-30)), R(0));
    }
    return m;
}

/// Signed distance of p, p.x >= 0, to the tangent of the hill with slope -m, measured across it: the distance to the hill when m is the
/// slope at the foot, and an error of m enters only by its square.
template <class Real, class Plain>
Real distance_to_hill(const Point<Real>& p, const Plain& m, const Plain& radius) {
    const Plain cosine = Plain(1) / sqrt(Plain(1) + m * m);
    return p.x * Real(m * cosine) + p.y * Real(cosine) - Real(Plain(0.5) * radius * m * (m * cosine));
}

}  // namespace pinfield::sdf

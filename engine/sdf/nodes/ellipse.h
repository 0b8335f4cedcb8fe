#pragma once
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Unit normal, with both components >= 0, at the point of the ellipse with half axes a, b that is nearest to a point of
/// the first quadrant. The normal's angle is the only root in that quadrant of "foot to point is parallel to the normal", with a
/// known sign at both ends: bisection finds it wherever the point lies, Newton's steps polish it. Working with
/// the normal, not with the foot (Eberly, "Distance from a Point to an Ellipse", 2013), keeps needles well conditioned
/// and divides by no coordinate that may vanish.
template <class R>
Point<R> ellipse_normal(const Point<R>& p, const R& a, const R& b) {
    const auto unit = [](const Point<R>& v) { return v * (R(1) / norm(v)); };
    const R aa = a * a, bb = b * b;
    Point<R> low{R(1), R(0)}, high{R(0), R(1)};
    R width = R(1.6);
    for (int step = 0; step < 16; ++step) {
        const Point<R> n = unit(low + high);
        const R reach = sqrt(aa * n.x * n.x + bb * n.y * n.y);
        const auto further = n.x * p.y - n.y * p.x + (aa - bb) * n.x * n.y / reach > R(0);
        low = select(further, n, low);
        high = select(further, high, n);
        width = width * R(0.5);
    }
    Point<R> n = unit(low + high);
    for (int step = 0; step < 3; ++step) {
        const R reach = sqrt(aa * n.x * n.x + bb * n.y * n.y);
        const R miss = n.x * p.y - n.y * p.x + (aa - bb) * n.x * n.y / reach;
        const R to_centre_of_curvature = dot(n, p) - reach + aa * bb / (reach * reach * reach);
        const R turn = clamp(miss / max(to_centre_of_curvature, R(1e-15)), -width, width);
        n = unit(Point<R>{max(n.x - turn * n.y, R(0)), max(n.y + turn * n.x, R(0))});
    }
    return n;
}

/// Ellipse about the local origin, its axes along x and y. Exact on both sides: with the nearest point's normal n the distance is
/// n.p - h(n), where h is the support function, and an error of n enters only by its square.
template <class Real>
struct Ellipse {
    Point<Real> radii{Real(0.05), Real(0.03)};

    static constexpr bool convex = true;

    Real distance(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        const Plain a = frozen(radii.x), b = frozen(radii.y), size = max(a, b);
        const Point<Plain> q{frozen(abs(p.x)) / size, frozen(abs(p.y)) / size};
        const Point<Plain> n = ellipse_normal(q, a / size, b / size);
        const Plain reach = norm(Point<Plain>{a * n.x, b * n.y});
        return abs(p.x) * Real(n.x) + abs(p.y) * Real(n.y) - Real(reach);
    }
    Box2 bounds() const { return Box2::centred(radii.x, radii.y); }

    static constexpr auto describe() {
        return shape<Ellipse>({.key = "ellipse", .float_error = 2e-6, .doc = "Ellipse about the local origin, its axes along x and y."},
                              fields(field("radii", &Ellipse::radii,
                                           {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Half axes along x and along y."})),
                              contract("neither radius above 1000 times the other", [](const auto& e) {
                                  return e.radii.x <= 1000 * e.radii.y && e.radii.y <= 1000 * e.radii.x;
                              }));
    }
};

}  // namespace pinfield::sdf

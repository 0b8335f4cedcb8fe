// Chains of Bezier curves of one degree: their points, nearest points and crossings.
#pragma once
#include "engine/sdf/cubic_curve.h"
#include "engine/sdf/quadratic_curve.h"

namespace pinfield::sdf {

/// One coordinate or both of a curve of degree 1, 2 or 3 as v0 + t v1 + t^2 v2 + t^3 v3.
struct PowerForm {
    Point<double> v0, v1, v2{0, 0}, v3{0, 0};

    Point<double> at(double t) const { return v0 + (v1 + (v2 + v3 * t) * t) * t; }
    Point<double> velocity(double t) const { return v1 + (v2 * 2.0 + v3 * (3 * t)) * t; }
};

/// A view of the control points of one curve: degree + 1 of them.
struct BezierView {
    const double* xy;
    int degree;

    Point<double> operator[](int i) const { return {xy[2 * i], xy[2 * i + 1]}; }
    Point<double> end() const { return (*this)[degree]; }
    PowerForm power_form() const {
        const BezierView& c = *this;
        const Point<double> first = c[1] - c[0];
        if (degree == 1) return {c[0], first};
        const Point<double> second = c[2] - c[1];
        if (degree == 2) return {c[0], first * 2.0, second - first};
        const Point<double> third = c[3] - c[2];
        return {c[0], first * 3.0, (second - first) * 3.0, (third - second) - (second - first)};
    }
};

template <class R>
Point<R> nearest_on_line(const Point<R>& p, const Point<double>& a, const Point<double>& b) {
    const Point<double> along = b - a;
    const double square = dot(along, along), scale = square > 0 ? 1 / square : 0;
    const R t = clamp(((p.x - R(a.x)) * R(along.x) + (p.y - R(a.y)) * R(along.y)) * R(scale), R(0), R(1));
    return {R(a.x) + t * R(along.x), R(a.y) + t * R(along.y)};
}

template <class R>
Point<R> nearest_on_bezier(const Point<R>& p, const BezierView& curve) {
    if (curve.degree == 1) return nearest_on_line(p, curve[0], curve[1]);
    if (curve.degree == 2) return nearest_on_quadratic_bezier(p, curve[0], curve[1], curve[2]);
    return nearest_on_cubic_bezier(p, curve[0], curve[1], curve[2], curve[3]);
}

/// Whether the ray from p along +x crosses the curve an odd number of times. The curve is cut where it turns from rising to falling; each
/// part crosses p's height once if its ends lie on different sides of it. Ends that parts and curves share are the same numbers, so that
/// no ray slips between two; they decide, too, from which side the part starts, as the polynomial may round to the other at a turning
/// point that p is level with.
template <class R>
auto crosses_oddly(const Point<R>& p, const BezierView& curve) {
    const PowerForm c = curve.power_form();
    double cuts[4] = {0, 0, 0, 1};
    const double under_root = c.v2.y * c.v2.y - 3 * c.v3.y * c.v1.y;
    if (under_root > 0) {
        const double far = c.v2.y < 0 ? sqrt(under_root) - c.v2.y : -sqrt(under_root) - c.v2.y, square = 3 * c.v3.y;
        const double one = abs(c.v1.y) < abs(far) ? c.v1.y / far : 1, other = abs(far) < abs(square) ? far / square : 1;
        cuts[1] = clamp(min(one, other), 0.0, 1.0);
        cuts[2] = clamp(max(one, other), 0.0, 1.0);
    }
    auto odd = R(0) < R(0);
    const auto height_at = [&](double t) { return t <= 0 ? curve[0].y : t >= 1 ? curve.end().y : c.at(t).y; };
    for (int i = 0; i < 3; ++i) {
        if (!(cuts[i] < cuts[i + 1])) continue;
        const auto starts_under = R(height_at(cuts[i])) <= p.y, straddles = exactly_one(starts_under, R(height_at(cuts[i + 1])) <= p.y);
        // Downwards, so that a point on p's height counts as not above it, as it does for the ends.
        const auto depth = [&](const R& t) { return p.y - R(c.v0.y) - t * (R(c.v1.y) + t * (R(c.v2.y) + t * R(c.v3.y))); };
        const auto slope = [&](const R& t) { return -(R(c.v1.y) + t * (R(2 * c.v2.y) + t * R(3 * c.v3.y))); };
        const R t = curve.degree == 1 ? (p.y - R(c.v0.y)) / R(c.v1.y == 0 ? 1 : c.v1.y)
                                      : sign_change(R(cuts[i]), R(cuts[i + 1]), invert(starts_under), 12, 3, depth, slope);
        const R x = R(c.v0.x) + t * (R(c.v1.x) + t * (R(c.v2.x) + t * R(c.v3.x)));
        odd = exactly_one(odd, both(straddles, x > p.x));
    }
    return odd;
}

}  // namespace pinfield::sdf

// The nearest point of a cubic Bezier curve, for every scalar.
#pragma once
#include "engine/sdf/sign_change.h"

namespace pinfield::sdf {

/// A cubic curve k0 + u k1 + u^2 k2 + u^3 k3, -1 <= u <= 1, and the two places (or an end twice) between which the third derivative of the
/// squared distance to any point is negative: that one derivative is the same for all points.
struct CubicCurve {
    Point<double> k0, k1, k2, k3;
    double bend_low = -1, bend_high = -1;
};

/// From control points. A template over the scalar it is for, so that code for one machine is never shared with another.
template <class R>
CubicCurve cubic_curve(const Point<double>& a, const Point<double>& b, const Point<double>& c, const Point<double>& d) {
    const Point<double> ends = a + d, middles = b + c, across = d - a, inner = c - b;
    CubicCurve out{(ends + middles * 3.0) * 0.125, (across + inner) * 0.375, (ends - middles) * 0.375, (across - inner * 3.0) * 0.125};
    // Of f = B' . (B - p): f''' / 12 = 5 |k3|^2 * 3 u^2 + 10 k2.k3 u + 2 k1.k3 + |k2|^2.
    const double square = 15 * dot(out.k3, out.k3), half_linear = 5 * dot(out.k2, out.k3);
    const double constant = 2 * dot(out.k1, out.k3) + dot(out.k2, out.k2), under_root = half_linear * half_linear - square * constant;
    if (!(under_root > 0)) return out;
    const double far = half_linear < 0 ? -half_linear + sqrt(under_root) : -half_linear - sqrt(under_root);
    const double one = constant / far, other = square > abs(far) * 1e-3 ? far / square : far < 0 ? -1.0 : 1.0;
    out.bend_low = clamp(min(one, other), -1.0, 1.0);
    out.bend_high = clamp(max(one, other), -1.0, 1.0);
    return out;
}

/// Half the derivative of the squared distance, f, is of degree five. The roots of each derivative cut the curve into pieces on which
/// the derivative before it is monotone, down to f itself, whose sign changes are all the places a nearest point can be: none is
/// missed wherever p lies (Yuksel, "High-Performance Polynomial Root Finding for Graphics", 2022). A cut need not be sharp: where it
/// hides a pair of roots from the next step, these are so close that they make no difference.
template <class R>
Point<R> nearest_on_cubic(const Point<R>& p, const CubicCurve& curve) {
    const auto broadcast = [](const Point<double>& v) { return Point<R>{R(v.x), R(v.y)}; };
    const Point<R> k0 = broadcast(curve.k0), k1 = broadcast(curve.k1), k2 = broadcast(curve.k2), k3 = broadcast(curve.k3);
    const Point<R> to_middle = k0 - p;
    const R f0 = dot(k1, to_middle), f1 = R(dot(curve.k1, curve.k1)) + R(2) * dot(k2, to_middle);
    const R f2 = R(3 * dot(curve.k1, curve.k2)) + R(3) * dot(k3, to_middle);
    const R f3(4 * dot(curve.k1, curve.k3) + 2 * dot(curve.k2, curve.k2)), f4(5 * dot(curve.k2, curve.k3)), f5(3 * dot(curve.k3, curve.k3));
    const R three_f3 = R(3) * f3, six_f4 = R(6) * f4, ten_f5 = R(10) * f5;
    const auto value = [&](const R& u) { return f0 + u * (f1 + u * (f2 + u * (f3 + u * (f4 + u * f5)))); };
    const auto slope = [&](const R& u) { return f1 + u * (R(2) * f2 + u * (three_f3 + u * (R(4) * f4 + u * (R(5) * f5)))); };
    const auto half_bend = [&](const R& u) { return f2 + u * (three_f3 + u * (six_f4 + u * ten_f5)); };
    const auto half_bend_slope = [&](const R& u) { return three_f3 + u * (R(2) * six_f4 + u * (R(3) * ten_f5)); };
    const auto bend = [&](const R& u) { return R(2) * half_bend(u); };

    const R first(-1), last(1), low(curve.bend_low), high(curve.bend_high);
    const R bends[] = {first, sign_change(first, low, 9, 4, half_bend, half_bend_slope),
                       sign_change(low, high, 9, 4, half_bend, half_bend_slope),
                       sign_change(high, last, 9, 4, half_bend, half_bend_slope), last};
    R turns[6] = {first, first, first, first, first, last};
    for (int i = 0; i < 4; ++i) turns[i + 1] = sign_change(bends[i], bends[i + 1], 9, 4, slope, bend);
    Point<R> foot = k0 - k1 + k2 - k3;
    R least = dot(foot - p, foot - p);
    for (int i = 0; i < 5; ++i) {
        R u = sign_change(turns[i], turns[i + 1], 10, 3, value, slope);
        // Where the curve is slow for its size the sum of powers has lost digits: the last steps take its vectors themselves, and may
        // leave the piece, which may be cut wrong for the same reason. On the evolute such a step may go anywhere, so every stop counts:
        // any point of the curve is a fair candidate.
        for (int stop = 0;; ++stop) {
            const Point<R> there = k0 + (k1 + (k2 + k3 * u) * u) * u, offset = there - p;
            const R square = dot(offset, offset);
            const auto nearer = square < least;
            least = select(nearer, square, least);
            foot = select(nearer, there, foot);
            if (stop == 2) break;
            const Point<R> velocity = k1 + (k2 * R(2) + k3 * (R(3) * u)) * u, acceleration = k2 * R(2) + k3 * (R(6) * u);
            const R turning = max(dot(velocity, velocity) + dot(acceleration, offset), R(1e-30));
            u = clamp(u - dot(velocity, offset) / turning, first, last);
        }
    }
    return foot;
}

/// The same of the cubic Bezier curve with control points a, b, c, d: loops, cusps and points that coincide are all welcome.
template <class R>
Point<R> nearest_on_cubic_bezier(const Point<R>& p, const Point<double>& a, const Point<double>& b, const Point<double>& c,
                                 const Point<double>& d) {
    return nearest_on_cubic(p, cubic_curve<R>(a, b, c, d));
}

}  // namespace pinfield::sdf

// The nearest point of a quadratic curve (a parabola's arc, a straight stretch, a point), for every scalar.
#pragma once
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// The curve start + s first + s^2 second, 0 <= s <= 1, with first . second >= 0: it bends away from its start only.
struct QuadraticPiece {
    Point<double> start, first, second;
};

/// The point of the piece that is nearest to p. Half the derivative of the squared distance is a cubic in s which is convex
/// on the piece, because the curve does not slow down there. So it rises through 0 once at most: halving finds where, and Newton's
/// steps come down to it from the right. Where it does not, the end that lies there is the nearest point, or the start, which is left
/// to the caller, who has one more piece on its other side.
template <class R>
Point<R> nearest_on_quadratic(const Point<R>& p, const QuadraticPiece& piece) {
    const Point<double>&v = piece.first, &w = piece.second;
    const Point<R> to_start{R(piece.start.x) - p.x, R(piece.start.y) - p.y}, first{R(v.x), R(v.y)}, second{R(w.x), R(w.y)};
    const R c0 = dot(first, to_start), c1 = R(dot(v, v)) + R(2) * dot(second, to_start), c2(3 * dot(v, w)), c3(2 * dot(w, w));
    const auto slope_at = [&](const R& s) { return c1 + s * (R(2) * c2 + s * (R(3) * c3)); };
    const auto value_at = [&](const R& s) { return c0 + s * (c1 + s * (c2 + s * c3)); };
    R low(0), high(1);
    for (int step = 0; step < 12; ++step) {
        const R middle = R(0.5) * (low + high);
        const auto before = either(value_at(middle) < R(0), slope_at(middle) < R(0));
        low = select(before, middle, low);
        high = select(before, high, middle);
    }
    R s = high;
    for (int step = 0; step < 5; ++step) s = clamp(s - value_at(s) / max(slope_at(s), R(1e-30)), low, high);
    return {R(piece.start.x) + s * (R(v.x) + s * R(w.x)), R(piece.start.y) + s * (R(v.y) + s * R(w.y))};
}

/// The point nearest to p of the quadratic Bezier curve with control points a, b, c, each of which may coincide with any other. The
/// curve is split at its apex, where it is slowest, if it has one.
template <class R>
Point<R> nearest_on_quadratic_bezier(const Point<R>& p, const Point<double>& a, const Point<double>& b, const Point<double>& c) {
    const Point<double> first = b - a, second = (c - b) - first;
    const double bend = dot(second, second), behind = -dot(first, second);
    const double apex = behind <= 0 ? 0.0 : behind >= bend ? 1.0 : behind / bend;
    const Point<double> start = a + (first * 2.0 + second * apex) * apex, along = (first + second * apex) * 2.0;
    Point<R> foot{R(start.x), R(start.y)};
    const auto offer = [&](const Point<R>& other) {
        const Point<R> now = p - foot, then = p - other;
        foot = select(dot(then, then) < dot(now, now), other, foot);
    };
    if (apex < 1) offer(nearest_on_quadratic(p, {start, along * (1 - apex), second * ((1 - apex) * (1 - apex))}));
    if (apex > 0) offer(nearest_on_quadratic(p, {start, along * -apex, second * (apex * apex)}));
    return foot;
}

}  // namespace pinfield::sdf

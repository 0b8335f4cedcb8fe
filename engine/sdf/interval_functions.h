// What expressions have beyond the operations of scalar.h, over intervals: each holds what the double's function gives for every member, and
// what the true one does.
#pragma once
#include "engine/expression/evaluate.h"
#include "engine/sdf/functions.h"
#include "engine/sdf/interval_dual.h"

namespace pinfield::sdf {

/// Of a function that grows and errs by less than three units of the last place (trig.h).
inline Interval around(double lo, double hi) {
    constexpr double few_ulps = 0x1p-50, least = std::numeric_limits<double>::denorm_min();
    return {lo - (abs(lo) * few_ulps + least), hi + (abs(hi) * few_ulps + least)};
}
inline Interval within(const Interval& a, double lo, double hi) { return {max(a.lo, lo), min(a.hi, hi)}; }
inline constexpr double far_in_degrees = 1e9;  // beyond it, where a peak lies is not known to a degree

/// The cosine takes 1 at every whole turn, -1 halfway; between them it is monotone.
inline Interval cosine_degrees(const Interval& a) {
    if (!(a.width() < 360) || !(max(abs(a.lo), abs(a.hi)) < far_in_degrees)) return {-1, 1};
    constexpr double hair = 1e-6;  // degrees, above the rounding of turns
    const auto meets = [&](double at) { return std::floor((a.hi - at + hair) / 360) >= std::ceil((a.lo - at - hair) / 360); };
    const double at_lo = pinfield::cosine_degrees(a.lo), at_hi = pinfield::cosine_degrees(a.hi);
    return within(around(meets(180) ? -1 : min(at_lo, at_hi), meets(0) ? 1 : max(at_lo, at_hi)), -1, 1);
}
inline Interval sine_degrees(const Interval& a) {
    if (!(a.width() < 360) || !(max(abs(a.lo), abs(a.hi)) < far_in_degrees)) return {-1, 1};
    const Interval turned = cosine_degrees(a - Interval(90));
    if (turned.lo == -1 && turned.hi == 1) return turned;
    const double at_lo = pinfield::sine_degrees(a.lo), at_hi = pinfield::sine_degrees(a.hi);
    return within(around(turned.lo == -1 ? -1 : min(at_lo, at_hi), turned.hi == 1 ? 1 : max(at_lo, at_hi)), -1, 1);
}

/// Of a box that neither holds the origin nor crosses the half axis where the angle jumps, the corners have the outermost angles.
inline Interval arc_tangent(const Interval& y, const Interval& x) {
    const bool has_origin = x.contains(0) && y.contains(0);
    // No zero of y is told from a negative one, but where it is the square or the size of something.
    if (y.lo >= 0 && has_origin) return around(0, pi);
    if (has_origin || (x.lo <= 0 && y.lo < 0 && y.hi >= 0)) return around(-pi, pi);
    const double a = pinfield::arc_tangent(y.lo, x.lo), b = pinfield::arc_tangent(y.lo, x.hi), c = pinfield::arc_tangent(y.hi, x.lo),
                 d = pinfield::arc_tangent(y.hi, x.hi);
    return around(min(min(a, b), min(c, d)), max(max(a, b), max(c, d)));
}
inline Interval exponential(const Interval& a) {
    const Interval out = around(pinfield::exponential(a.lo), pinfield::exponential(a.hi));
    return {max(out.lo, 0.0), out.hi};
}
/// Members that have no logarithm are left out.
inline Interval logarithm(const Interval& a) {
    return around(pinfield::logarithm(max(a.lo, 0.0)), pinfield::logarithm(max(a.hi, 0.0)));
}
inline Interval power(const Interval& a, const Interval& b) {
    if (b.lo == b.hi && expressions::is_whole_power(b.lo)) return expressions::whole_power(a, static_cast<int>(b.lo));
    if (a.lo < 0) return Interval::everything();
    const Interval out = exponential(b * logarithm(a));
    constexpr double rounding = 1e-12;  // of as many products as a whole exponent takes
    return {max(out.lo * (1 - rounding), 0.0), out.hi * (1 + rounding)};
}

/// f(a), of this value and derivative.
inline IntervalDual chained(const Interval& value, const Interval& slope, const IntervalDual& a) {
    return {value, slope * a.dx, slope * a.dy};
}
inline IntervalDual sine_degrees(const IntervalDual& a) {
    return chained(sine_degrees(a.v), Interval(pi / 180) * cosine_degrees(a.v), a);
}
inline IntervalDual cosine_degrees(const IntervalDual& a) {
    return chained(cosine_degrees(a.v), Interval(-pi / 180) * sine_degrees(a.v), a);
}
inline IntervalDual arc_tangent(const IntervalDual& y, const IntervalDual& x) {
    const Interval squared = x.v * x.v + y.v * y.v;
    return {arc_tangent(y.v, x.v), (x.v * y.dx - y.v * x.dx) / squared, (x.v * y.dy - y.v * x.dy) / squared};
}
inline IntervalDual exponential(const IntervalDual& a) {
    const Interval value = exponential(a.v);
    return chained(value, value, a);
}
inline IntervalDual logarithm(const IntervalDual& a) { return chained(logarithm(a.v), Interval(1) / a.v, a); }
inline IntervalDual power(const IntervalDual& a, const IntervalDual& b) {
    const Interval value = power(a.v, b.v), less = b.v.lo == b.v.hi ? Interval(b.v.lo - 1) : b.v - Interval(1);
    const Interval by_a = b.v.is_zero() ? Interval(0) : b.v * power(a.v, less);
    if (b.dx.is_zero() && b.dy.is_zero()) return chained(value, by_a, a);
    const Interval by_b = value * logarithm(a.v);
    return {value, by_a * a.dx + by_b * b.dx, by_a * a.dy + by_b * b.dy};
}
inline IntervalDual hypotenuse(const IntervalDual& a, const IntervalDual& b) { return norm(Point<IntervalDual>{a, b}); }

}  // namespace pinfield::sdf

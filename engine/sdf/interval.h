// Closed intervals as a scalar of the distance formulas: a formula evaluated over a box of points bounds its values there.
// (Moore, Kearfott and Cloud, "Introduction to Interval Analysis", 2009; Duff, "Interval arithmetic and recursive subdivision", 1992.)
//
// Each operation holds every result that its operands' members have, for reals and for rounded doubles alike, so by induction a whole
// formula does, however often it iterates: a halving or a step of Newton's that cannot tell where to go keeps both ways, and what comes out
// may be wide, even everything, but never misses a value. A formula needs nothing for that beyond what SIMD lanes ask of it: to branch by
// `select`.
#pragma once
#include <limits>

#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// lo <= hi, never empty, never NaN; the ends may be infinite.
struct Interval {
    double lo = 0, hi = 0;

    Interval() = default;
    explicit Interval(double value) : Interval(value, value) {}
    /// A NaN at either end, or ends in the wrong order, mean that nothing is known: everything.
    Interval(double from, double to) : lo(from), hi(to) {
        if (!(lo <= hi)) lo = -infinite, hi = infinite;
    }
    static Interval everything() { return {-infinite, infinite}; }

    bool is_zero() const { return lo == 0 && hi == 0; }
    bool is_finite() const { return -infinite < lo && hi < infinite; }
    bool contains(double value) const { return lo <= value && value <= hi; }
    double width() const { return hi - lo; }

    static constexpr double infinite = std::numeric_limits<double>::infinity();
};

/// What is known of a condition: whether some members fulfil it, whether some do not. At least one of the two.
struct IntervalMask {
    bool may_hold, may_fail;
};
inline IntervalMask both(const IntervalMask& a, const IntervalMask& b) { return {a.may_hold && b.may_hold, a.may_fail || b.may_fail}; }
inline IntervalMask either(const IntervalMask& a, const IntervalMask& b) { return {a.may_hold || b.may_hold, a.may_fail && b.may_fail}; }
inline IntervalMask invert(const IntervalMask& a) { return {a.may_fail, a.may_hold}; }
inline IntervalMask exactly_one(const IntervalMask& a, const IntervalMask& b) {
    return {(a.may_hold && b.may_fail) || (a.may_fail && b.may_hold), (a.may_hold && b.may_hold) || (a.may_fail && b.may_fail)};
}

inline Interval hull(const Interval& a, const Interval& b) { return {min(a.lo, b.lo), max(a.hi, b.hi)}; }

/// A result rounded to nearest, an ulp further out at either end. (Rump, Zimmermann, Boldo and Melquiond, "Computing predecessor and
/// successor in rounding to nearest", 2009: the neighbour or one beyond it, by a product and two sums.)
inline Interval outward(double lo, double hi) {
    constexpr double ulp = 0x1.0000000000001p-53, least = std::numeric_limits<double>::denorm_min();
    return {lo - (abs(lo) * ulp + least), hi + (abs(hi) * ulp + least)};
}

inline Interval operator-(const Interval& a) { return {-a.hi, -a.lo}; }
/// Of sums: one that rounds to 0 is 0, so that what stands still at 0 is known to.
inline Interval outward_of_sums(double lo, double hi) {
    const Interval out = outward(lo, hi);
    return {lo == 0 ? 0 : out.lo, hi == 0 ? 0 : out.hi};
}
inline Interval operator+(const Interval& a, const Interval& b) { return outward_of_sums(a.lo + b.lo, a.hi + b.hi); }
inline Interval operator-(const Interval& a, const Interval& b) { return outward_of_sums(a.lo - b.hi, a.hi - b.lo); }
inline Interval abs(const Interval& a) {
    if (a.lo >= 0) return a;
    return a.hi <= 0 ? -a : Interval{0, max(-a.lo, a.hi)};
}
inline Interval square(const Interval& a) {
    const Interval size = abs(a);
    const Interval out = outward(size.lo * size.lo, size.hi * size.hi);
    return {max(out.lo, 0.0), out.hi};
}
/// Of four products or quotients the outermost; a NaN among them (0 times infinity) leaves everything.
inline Interval span_of(double a, double b, double c, double d) {
    if (std::isnan(a) || std::isnan(b) || std::isnan(c) || std::isnan(d)) return Interval::everything();
    return outward(min(min(a, b), min(c, d)), max(max(a, b), max(c, d)));
}
/// What is made of two that are not below 0 is not either, however it rounds.
inline Interval of_sizes(const Interval& a, const Interval& b, const Interval& out) {
    return a.lo >= 0 && b.lo >= 0 ? Interval{max(out.lo, 0.0), out.hi} : out;
}
/// One object times itself is a square, which is never negative: x * x, dot(v, v) and norm(v) are as sharp as they look.
inline Interval operator*(const Interval& a, const Interval& b) {
    if ((a.is_zero() && b.is_finite()) || (b.is_zero() && a.is_finite())) return Interval(0);
    if (&a == &b) return square(a);
    return of_sizes(a, b, span_of(a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi));
}
inline Interval operator/(const Interval& a, const Interval& b) {
    if (b.contains(0)) return Interval::everything();
    return of_sizes(a, b, span_of(a.lo / b.lo, a.lo / b.hi, a.hi / b.lo, a.hi / b.hi));
}

inline IntervalMask operator<(const Interval& a, const Interval& b) { return {a.lo < b.hi, !(a.hi < b.lo)}; }
inline IntervalMask operator<=(const Interval& a, const Interval& b) { return {a.lo <= b.hi, !(a.hi <= b.lo)}; }
inline IntervalMask operator>(const Interval& a, const Interval& b) { return b < a; }
inline IntervalMask operator>=(const Interval& a, const Interval& b) { return b <= a; }

inline Interval min(const Interval& a, const Interval& b) { return {min(a.lo, b.lo), min(a.hi, b.hi)}; }
inline Interval max(const Interval& a, const Interval& b) { return {max(a.lo, b.lo), max(a.hi, b.hi)}; }
inline Interval floor(const Interval& a) { return {std::floor(a.lo), std::floor(a.hi)}; }
/// What rounding has pushed below 0 counts as 0.
inline Interval sqrt(const Interval& a) {
    const Interval out = outward(std::sqrt(max(a.lo, 0.0)), std::sqrt(max(a.hi, 0.0)));
    return {max(out.lo, 0.0), out.hi};
}
inline Interval select(const IntervalMask& condition, const Interval& yes, const Interval& no) {
    if (!condition.may_fail) return yes;
    return condition.may_hold ? hull(yes, no) : no;
}

inline Interval frozen(const Interval& a) { return a; }
inline double epsilon_of(const Interval&) { return 0x1p-52; }
inline Interval with_gradient(const Interval& value, const Interval&, const Interval&, const Point<Interval>&) { return value; }

}  // namespace pinfield::sdf

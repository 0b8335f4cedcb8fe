// What a formula can be over a box: its value and gradient as intervals, watched for jumps and for places where it has no value. What is
// continuous and nowhere without a value changes over the box by no more than its gradients say.
#pragma once
#include "engine/sdf/interval_functions.h"

namespace pinfield::sdf {

struct Watched {
    IntervalDual d;       ///< its gradient holds that of every member apart from jumps
    double jump = 0;      ///< 0: it is continuous; else it jumps somewhere by a whole multiple of this; infinite: by anything
    bool is_none = false;  ///< it may have no value somewhere
    bool flips = false;    ///< where it jumps, it only changes its sign

    static constexpr double by_anything = Interval::infinite;

    Watched() = default;
    explicit Watched(double value) : d(value) {}
    Watched(const IntervalDual& known, double jumps, bool none) : d(known), jump(jumps), is_none(none) {
        if (is_constant()) jump = 0;
    }
    bool is_constant() const { return d.v.lo == d.v.hi && d.dx.is_zero() && d.dy.is_zero(); }
    bool may_be_infinite() const { return !d.v.is_finite(); }
};

/// Of an operation that takes jumps in its operands to jumps by anything.
inline Watched watched(const IntervalDual& d, const Watched& a) { return {d, a.jump == 0 ? 0.0 : Watched::by_anything, a.is_none}; }
inline Watched watched(const IntervalDual& d, const Watched& a, const Watched& b) {
    return {d, a.jump == 0 && b.jump == 0 ? 0.0 : Watched::by_anything, a.is_none || b.is_none};
}
inline Watched or_none(Watched a, bool none) {
    a.is_none = a.is_none || none;
    return a;
}

/// Of a sum of what jumps by multiples of a and of what jumps by multiples of b.
inline double common_jump(double a, double b) {
    const double less = min(a, b), more = max(a, b);
    if (less == 0 || less == more) return more;
    return more < Watched::by_anything && std::fmod(more, less) == 0 ? less : Watched::by_anything;
}
inline bool may_cancel(const Interval& a, const Interval& b) {
    return (a.hi == Interval::infinite && b.lo == -Interval::infinite) || (a.lo == -Interval::infinite && b.hi == Interval::infinite);
}
inline Watched with_flips(Watched out, bool flips) {
    out.flips = flips;
    return out;
}
inline Watched operator-(const Watched& a) { return with_flips({-a.d, a.jump, a.is_none}, a.flips); }
inline Watched operator+(const Watched& a, const Watched& b) {
    return {a.d + b.d, common_jump(a.jump, b.jump), a.is_none || b.is_none || may_cancel(a.d.v, b.d.v)};
}
inline Watched operator-(const Watched& a, const Watched& b) {
    return {a.d - b.d, common_jump(a.jump, b.jump), a.is_none || b.is_none || may_cancel(a.d.v, -b.d.v)};
}
inline Watched operator*(const Watched& a, const Watched& b) {
    const bool none = a.is_none || b.is_none || (a.d.v.contains(0) && b.may_be_infinite()) || (b.d.v.contains(0) && a.may_be_infinite());
    if (b.is_constant()) return with_flips({a.d * b.d, a.jump * abs(b.d.v.lo), none}, a.flips);
    if (a.is_constant()) return with_flips({a.d * b.d, b.jump * abs(a.d.v.lo), none}, b.flips);
    if (&a == &b && a.flips) return {a.d * b.d, 0, none};
    return or_none(watched(a.d * b.d, a, b), none);
}
/// Towards a divisor of 0 a quotient that keeps its sign grows without end; one that may have either sign, or 0 / 0, has no value. (No divisor
/// of a formula is a negative zero: steps.h.)
inline Watched operator/(const Watched& a, const Watched& b) {
    if (b.is_constant() && b.d.v.lo != 0) return {a.d / b.d, a.jump / abs(b.d.v.lo), a.is_none};
    Watched out = watched(a.d / b.d, a, b);
    out.is_none = out.is_none || (a.may_be_infinite() && b.may_be_infinite());
    if (!b.d.v.contains(0)) return out;
    if (b.d.v.lo < 0 || a.d.v.contains(0) || a.is_none || b.is_none) return or_none(out, true);
    const double least = min(abs(a.d.v.lo), abs(a.d.v.hi)), at_least = least / b.d.v.hi * (1 - 1e-15);
    out.d.v = a.d.v.lo > 0 ? Interval(at_least, Interval::infinite) : Interval(-Interval::infinite, -at_least);
    return out;
}

struct WatchedMask {
    IntervalMask mask;
    bool is_none;  ///< it compares what may have no value
};
inline WatchedMask both(const WatchedMask& a, const WatchedMask& b) { return {both(a.mask, b.mask), a.is_none || b.is_none}; }
inline WatchedMask either(const WatchedMask& a, const WatchedMask& b) { return {either(a.mask, b.mask), a.is_none || b.is_none}; }
inline WatchedMask invert(const WatchedMask& a) { return {invert(a.mask), a.is_none}; }
inline WatchedMask operator<(const Watched& a, const Watched& b) { return {a.d < b.d, a.is_none || b.is_none}; }
inline WatchedMask operator<=(const Watched& a, const Watched& b) { return {a.d <= b.d, a.is_none || b.is_none}; }
inline WatchedMask operator>(const Watched& a, const Watched& b) { return b < a; }
inline WatchedMask operator>=(const Watched& a, const Watched& b) { return b <= a; }

/// Where it may be either it jumps: that both are the same where one gives way to the other, nothing here could know.
inline Watched select(const WatchedMask& condition, const Watched& yes, const Watched& no) {
    if (condition.is_none) return {select(IntervalMask{true, true}, yes.d, no.d), Watched::by_anything, true};
    if (!condition.mask.may_fail) return yes;
    if (!condition.mask.may_hold) return no;
    return {select(condition.mask, yes.d, no.d), Watched::by_anything, yes.is_none || no.is_none};
}

/// Of two that are known to be the same there.
inline Watched joined(const WatchedMask& condition, const Watched& yes, const Watched& no) {
    if (condition.is_none || !condition.mask.may_fail || !condition.mask.may_hold) return select(condition, yes, no);
    return watched(select(condition.mask, yes.d, no.d), yes, no);
}

inline Watched abs(const Watched& a) {
    if (a.flips) return {abs(a.d), 0, a.is_none};
    if (a.d.v.lo >= 0) return a;
    return a.d.v.hi <= 0 ? -a : watched(abs(a.d), a);
}
/// Of two, one of which is surely the result, the other's jumps are no matter.
inline Watched min(const Watched& a, const Watched& b) {
    if (a.is_none || b.is_none) return or_none(watched(min(a.d, b.d), a, b), true);
    if (a.d.v.hi < b.d.v.lo) return a;
    return b.d.v.hi < a.d.v.lo ? b : watched(min(a.d, b.d), a, b);
}
inline Watched max(const Watched& a, const Watched& b) { return -min(-a, -b); }
inline Watched floor(const Watched& a) {
    const IntervalDual out = floor(a.d);
    return {out, out.v.lo == out.v.hi ? 0.0 : 1.0, a.is_none};
}
inline Watched sqrt(const Watched& a) { return or_none(watched(sqrt(a.d), a), a.d.v.lo < 0); }
inline Watched hypotenuse(const Watched& a, const Watched& b) { return watched(hypotenuse(a.d, b.d), a, b); }

/// A whole number of turns is no jump to a sine, and half a turn changes its sign.
inline Watched of_angle(const IntervalDual& d, const Watched& a) {
    const auto jumps_by = [&](double angle) { return a.jump < Watched::by_anything && std::fmod(a.jump, angle) == 0; };
    return with_flips({d, jumps_by(360) ? 0.0 : Watched::by_anything, a.is_none || a.may_be_infinite()}, jumps_by(180));
}
inline Watched sine_degrees(const Watched& a) { return of_angle(sine_degrees(a.d), a); }
inline Watched cosine_degrees(const Watched& a) { return of_angle(cosine_degrees(a.d), a); }
/// The angle jumps by a whole turn at the half axis of negative x. About the origin it jumps by anything.
inline Watched arc_tangent_degrees(const Watched& y, const Watched& x) {
    const IntervalDual d = arc_tangent(y.d, x.d) * IntervalDual(180 / pi);
    const Interval &down = y.d.v, &left = x.d.v;
    Watched out = watched(d, y, x);
    out.is_none = out.is_none || y.may_be_infinite() || x.may_be_infinite();
    if (out.jump == 0 && left.lo <= 0 && down.lo < 0 && down.hi >= 0) out.jump = 360;
    if (left.contains(0) && down.contains(0)) out.jump = Watched::by_anything;
    return out;
}
inline Watched exponential(const Watched& a) { return watched(exponential(a.d), a); }
inline Watched logarithm(const Watched& a) { return or_none(watched(logarithm(a.d), a), a.d.v.lo < 0); }
inline Watched power(const Watched& a, const Watched& b) {
    const bool none = a.d.v.lo < 0 || (a.d.v.lo == 0 && !(b.d.v.lo > 0)) || a.may_be_infinite() || b.may_be_infinite();
    return or_none(watched(power(a.d, b.d), a, b), none);
}

}  // namespace pinfield::sdf

// Automatic differentiation over intervals: what a formula's value and gradient can be over a box of points. Where its branches meet in a
// crease the enclosure of the gradient holds those of both sides, hence Clarke's generalised gradient; of a jump it knows nothing.
#pragma once
#include "engine/sdf/interval.h"

namespace pinfield::sdf {

/// Dual of dual.h, each number an interval.
struct IntervalDual {
    Interval v, dx, dy;

    IntervalDual() = default;
    explicit IntervalDual(double value) : v(value) {}
    explicit IntervalDual(const Interval& value) : v(value) {}
    IntervalDual(const Interval& value, const Interval& along_x, const Interval& along_y) : v(value), dx(along_x), dy(along_y) {}
};

inline IntervalDual operator+(const IntervalDual& a, const IntervalDual& b) { return {a.v + b.v, a.dx + b.dx, a.dy + b.dy}; }
inline IntervalDual operator-(const IntervalDual& a, const IntervalDual& b) { return {a.v - b.v, a.dx - b.dx, a.dy - b.dy}; }
inline IntervalDual operator-(const IntervalDual& a) { return {-a.v, -a.dx, -a.dy}; }
inline IntervalDual operator*(const IntervalDual& a, const IntervalDual& b) {
    return {a.v * b.v, a.v * b.dx + b.v * a.dx, a.v * b.dy + b.v * a.dy};
}
inline IntervalDual operator/(const IntervalDual& a, const IntervalDual& b) {
    const Interval q = a.v / b.v;
    return {q, (a.dx - q * b.dx) / b.v, (a.dy - q * b.dy) / b.v};
}
inline IntervalMask operator<(const IntervalDual& a, const IntervalDual& b) { return a.v < b.v; }
inline IntervalMask operator>(const IntervalDual& a, const IntervalDual& b) { return a.v > b.v; }
inline IntervalMask operator<=(const IntervalDual& a, const IntervalDual& b) { return a.v <= b.v; }
inline IntervalMask operator>=(const IntervalDual& a, const IntervalDual& b) { return a.v >= b.v; }
inline IntervalDual select(const IntervalMask& condition, const IntervalDual& yes, const IntervalDual& no) {
    return {select(condition, yes.v, no.v), select(condition, yes.dx, no.dx), select(condition, yes.dy, no.dy)};
}
/// The value is bounded better by its own operation than by a choice between the branches.
inline IntervalDual with_value(const Interval& value, const IntervalDual& slopes) { return {value, slopes.dx, slopes.dy}; }
inline IntervalDual abs(const IntervalDual& a) { return with_value(abs(a.v), select(a.v < Interval(0), -a, a)); }
inline IntervalDual min(const IntervalDual& a, const IntervalDual& b) { return with_value(min(a.v, b.v), select(b < a, b, a)); }
inline IntervalDual max(const IntervalDual& a, const IntervalDual& b) { return with_value(max(a.v, b.v), select(a < b, b, a)); }
inline IntervalDual floor(const IntervalDual& a) { return IntervalDual(floor(a.v)); }
inline IntervalDual sqrt(const IntervalDual& a) {
    const Interval root = sqrt(a.v), k = Interval(0.5) / root;
    return {root, k * a.dx, k * a.dy};
}
/// The gradient is a unit vector's product with the foot vector's derivatives, also where the vector may vanish.
inline IntervalDual norm(const Point<IntervalDual>& q) {
    const Interval length = norm(Point<Interval>{q.x.v, q.y.v});
    const auto unit = [&](const Interval& a) { return length.lo > 0 ? max(min(a / length, Interval(1)), Interval(-1)) : Interval(-1, 1); };
    const Interval ux = unit(q.x.v), uy = unit(q.y.v);
    return {length, ux * q.x.dx + uy * q.y.dx, ux * q.x.dy + uy * q.y.dy};
}

inline Interval frozen(const IntervalDual& a) { return a.v; }
inline IntervalDual with_gradient(const Interval& value, const Interval& x, const Interval& y, const Point<IntervalDual>& p) {
    return {value, x * p.x.dx + y * p.y.dx, x * p.x.dy + y * p.y.dy};
}

}  // namespace pinfield::sdf

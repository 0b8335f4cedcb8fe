// What expressions have beyond the operations of scalar.h, with derivatives by the chain rule. The values are bit for bit the double's.
#pragma once
#include "engine/expression/evaluate.h"
#include "engine/sdf/dual.h"
#include "engine/sdf/functions.h"

namespace pinfield::sdf {

/// f(a), of this value and derivative.
inline Dual chained(double value, double slope, const Dual& a) { return {value, slope * a.dx, slope * a.dy}; }

inline Dual sine_degrees(const Dual& a) {
    const SineCosine at = pinfield::sine_cosine_degrees(a.v);
    return chained(at.sine, radians(at.cosine), a);
}
inline Dual cosine_degrees(const Dual& a) {
    const SineCosine at = pinfield::sine_cosine_degrees(a.v);
    return chained(at.cosine, -radians(at.sine), a);
}
/// At the origin, where there is no angle, the derivative is taken as 0.
inline Dual arc_tangent(const Dual& y, const Dual& x) {
    const double squared = x.v * x.v + y.v * y.v, k = squared > 0 ? 1 / squared : 0;
    return {pinfield::arc_tangent(y.v, x.v), k * (x.v * y.dx - y.v * x.dx), k * (x.v * y.dy - y.v * x.dy)};
}
inline Dual exponential(const Dual& a) {
    const double value = pinfield::exponential(a.v);
    return chained(value, value, a);
}
inline Dual logarithm(const Dual& a) { return chained(pinfield::logarithm(a.v), 1 / a.v, a); }

inline Dual power(const Dual& a, const Dual& b) {
    const double value = expressions::power(a.v, b.v), by_a = b.v == 0 ? 0 : b.v * expressions::power(a.v, b.v - 1);
    if (b.dx == 0 && b.dy == 0) return chained(value, by_a, a);
    const double by_b = a.v > 0 ? value * pinfield::logarithm(a.v) : 0;
    return {value, by_a * a.dx + by_b * b.dx, by_a * a.dy + by_b * b.dy};
}
inline Dual modulo(const Dual& a, const Dual& b) {
    const double whole = std::floor(a.v / b.v);
    return {expressions::modulo(a.v, b.v), a.dx - whole * b.dx, a.dy - whole * b.dy};
}
inline Dual hypotenuse(const Dual& a, const Dual& b) { return norm(Point<Dual>{a, b}); }

}  // namespace pinfield::sdf

// Forward-mode automatic differentiation with two directions: the value and its gradient in one pass of the formula.
// (Griewank and Walther, "Evaluating Derivatives", 2008, chapter 3.)
#pragma once
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Value v with derivatives dx, dy along two chosen directions: the query point's axes for a shape, the two operands for a fold.
struct Dual {
    double v = 0, dx = 0, dy = 0;

    Dual() = default;
    explicit Dual(double value) : v(value) {}
    Dual(double value, double along_x, double along_y) : v(value), dx(along_x), dy(along_y) {}
};

inline Dual operator+(const Dual& a, const Dual& b) { return {a.v + b.v, a.dx + b.dx, a.dy + b.dy}; }
inline Dual operator-(const Dual& a, const Dual& b) { return {a.v - b.v, a.dx - b.dx, a.dy - b.dy}; }
inline Dual operator-(const Dual& a) { return {-a.v, -a.dx, -a.dy}; }
inline Dual operator*(const Dual& a, const Dual& b) {
    return {a.v * b.v, a.v * b.dx + b.v * a.dx, a.v * b.dy + b.v * a.dy};
}
inline Dual operator/(const Dual& a, const Dual& b) {
    const double q = a.v / b.v;
    return {q, (a.dx - q * b.dx) / b.v, (a.dy - q * b.dy) / b.v};
}
inline bool operator<(const Dual& a, const Dual& b) { return a.v < b.v; }
inline bool operator>(const Dual& a, const Dual& b) { return a.v > b.v; }
inline bool operator<=(const Dual& a, const Dual& b) { return a.v <= b.v; }
inline bool operator>=(const Dual& a, const Dual& b) { return a.v >= b.v; }
inline Dual abs(const Dual& a) { return a.v < 0 ? -a : a; }
inline Dual floor(const Dual& a) { return Dual(std::floor(a.v)); }
inline Dual min(const Dual& a, const Dual& b) { return b.v < a.v ? b : a; }
inline Dual max(const Dual& a, const Dual& b) { return a.v < b.v ? b : a; }
inline double frozen(const Dual& a) { return a.v; }
inline Dual with_gradient(double value, double x, double y, const Point<Dual>& p) {
    return {value, x * p.x.dx + y * p.y.dx, x * p.x.dy + y * p.y.dy};
}
inline Dual select(bool condition, const Dual& yes, const Dual& no) { return condition ? yes : no; }
/// At 0 the derivative is taken as 0: finite. Lengths of vectors go through norm(), which does better there.
inline Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.v), k = root > 0 ? 0.5 / root : 0;
    return {root, k * a.dx, k * a.dy};
}

/// Where the foot vector q vanishes its length has a cone's apex or a crease: any limit of the gradient is as good as any other,
/// but it must be a unit vector. The rows of q's Jacobian span those limits (one row for a crease, where q is a projection
/// onto a normal; two for a point), so the longer row, normalised, is one of them.
inline Dual norm(const Point<Dual>& q) {
    const double length = std::sqrt(q.x.v * q.x.v + q.y.v * q.y.v);
    if (length > 0) {
        const double ux = q.x.v / length, uy = q.y.v / length;
        return {length, ux * q.x.dx + uy * q.y.dx, ux * q.x.dy + uy * q.y.dy};
    }
    const double row_x = std::sqrt(q.x.dx * q.x.dx + q.x.dy * q.x.dy);
    const double row_y = std::sqrt(q.y.dx * q.y.dx + q.y.dy * q.y.dy);
    const Dual& row = row_x < row_y ? q.y : q.x;
    const double longest = row_x < row_y ? row_y : row_x;
    if (!(longest > 0)) return {0, 0, 0};
    return {0, row.dx / longest, row.dy / longest};
}

}  // namespace pinfield::sdf

// The operations a distance formula may use, for double, and below those that are made of them for any scalar. dual.h and packet.h give
// the same for their scalars, and so does whoever brings another. A formula branches by `select`, never by `if` on a Real, so that the same
// source runs on SIMD lanes.
#pragma once
#include <cmath>

#include "engine/core/point.h"

namespace pinfield::sdf {

inline double sqrt(double a) { return std::sqrt(a); }
inline double floor(double a) { return std::floor(a); }
inline double abs(double a) { return std::fabs(a); }
/// Ties give the first argument, here and for every scalar: it decides gradients and the winning leaf.
inline double min(double a, double b) { return b < a ? b : a; }
inline double max(double a, double b) { return a < b ? b : a; }
inline double select(bool condition, double yes, double no) { return condition ? yes : no; }
/// The value without its derivatives, as the scalar that suffices for it: for iterations whose derivative is known in closed form.
inline double frozen(double a) { return a; }
/// Spacing of the scalar's numbers just above 1.
inline double epsilon_of(double) { return 0x1p-52; }
/// The scalar with this value at p whose gradient there is (x, y), for a value that was found with frozen numbers.
inline double with_gradient(double value, double, double, const Point<double>&) { return value; }
inline bool both(bool a, bool b) { return a && b; }
inline bool either(bool a, bool b) { return a || b; }
inline bool exactly_one(bool a, bool b) { return a != b; }
inline bool invert(bool a) { return !a; }

template <class Real>
Point<Real> operator+(const Point<Real>& a, const Point<Real>& b) { return {a.x + b.x, a.y + b.y}; }
template <class Real>
Point<Real> operator-(const Point<Real>& a, const Point<Real>& b) { return {a.x - b.x, a.y - b.y}; }
template <class Real>
Point<Real> operator*(const Point<Real>& a, const Real& s) { return {a.x * s, a.y * s}; }
template <class Real>
Real dot(const Point<Real>& a, const Point<Real>& b) { return a.x * b.x + a.y * b.y; }
/// z of the 3D cross product.
template <class Real>
Real cross(const Point<Real>& a, const Point<Real>& b) { return a.x * b.y - a.y * b.x; }
/// Length of a foot vector. Its gradient is a unit vector even where the vector vanishes: see dual.h.
template <class Real>
Real norm(const Point<Real>& p) { return sqrt(p.x * p.x + p.y * p.y); }
template <class Real>
Real clamp(const Real& v, const Real& lo, const Real& hi) { return min(max(v, lo), hi); }
template <class Real, class Mask>
Point<Real> select(const Mask& condition, const Point<Real>& yes, const Point<Real>& no) {
    return {select(condition, yes.x, no.x), select(condition, yes.y, no.y)};
}
/// -1 or +1, never 0: on an axis of symmetry either side will do, none will not.
template <class Real>
Real sign(const Real& v) { return select(v < Real(0), Real(-1), Real(1)); }

}  // namespace pinfield::sdf

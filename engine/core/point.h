// The point that distance formulas are written over, and the lists they read: any scalar, no Eigen, so that they may enter a SIMD
// translation unit.
#pragma once

namespace pinfield {

template <class Real>
struct Point {
    Real x, y;
};

/// A view of `count` points stored as x0 y0 x1 y1 ...; each read is broadcast to the formula's scalar.
template <class Real>
struct PointList {
    const double* xy = nullptr;
    int count = 0;
    Point<Real> operator[](int i) const { return {Real(xy[2 * i]), Real(xy[2 * i + 1])}; }
};

/// A view of `count` values of an enum, stored as reals.
template <class Enum>
struct ChoiceList {
    const double* indices = nullptr;
    int count = 0;
    Enum operator[](int i) const { return static_cast<Enum>(static_cast<int>(indices[i])); }
};

}  // namespace pinfield

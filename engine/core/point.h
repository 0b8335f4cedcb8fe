// The point that distance formulas are written over: any scalar, no Eigen, so that it may enter a SIMD translation unit.
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

}  // namespace pinfield

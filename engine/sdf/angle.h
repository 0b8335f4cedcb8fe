// The angle of a vector, for every scalar and by + - * / and square roots alone: the same bits from every compiler and every SIMD width.
#pragma once
#include "engine/core/trig.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Radians from +x, counter-clockwise, in [0, 2 pi]; 0 for the zero vector. Two halvings of an angle of at most 45 degrees leave
/// a tangent below 0.2, for which eleven terms of the arc tangent's series reach a double's last digit.
template <class R>
R angle_of(const Point<R>& v) {
    const R x = abs(v.x), y = abs(v.y), longer = max(x, y);
    R t = min(x, y) / select(longer > R(0), longer, R(1));
    for (int halving = 0; halving < 2; ++halving) t = t / (R(1) + sqrt(R(1) + t * t));
    const R square = t * t;
    R series(0);
    for (int k = 10; k >= 0; --k) series = R((k % 2 == 0 ? 1.0 : -1.0) / (2 * k + 1)) + square * series;
    R angle = R(4) * t * series;
    angle = select(y > x, R(half_pi) - angle, angle);
    angle = select(v.x < R(0), R(pi) - angle, angle);
    return select(v.y < R(0), R(two_pi) - angle, angle);
}

}  // namespace pinfield::sdf

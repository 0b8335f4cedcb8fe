#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Triangle of three equal sides about the local origin, standing on one of them.
template <class Real>
struct EquilateralTriangle {
    static constexpr int most_pieces = 3;
    static constexpr bool convex = true;

    Real side = Real(0.08);

    void outline(Outline& out) const { outline_regular_polygon(out, 3, side / sqrt(12.0)); }

    static constexpr auto describe() {
        using T = EquilateralTriangle;
        return shape<T>(
            {.key = "equilateral_triangle",
             .doc = "Triangle of three equal sides about the local origin, standing on one of them."},
            fields(field("side", &T::side,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Length of each side."})));
    }
};

}  // namespace pinfield::sdf

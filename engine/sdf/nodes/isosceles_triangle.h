#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/nodes/trapezoid.h"

namespace pinfield::sdf {

/// Triangle with two equal sides, the apex above a level base; centred on the local origin as its bounding box is.
template <class Real>
struct IsoscelesTriangle {
    static constexpr int most_pieces = 3;
    static constexpr bool convex = true;

    Real width = Real(0.06), height = Real(0.09);

    void outline(Outline& out) const { Trapezoid<double>{width, 0, height}.outline(out); }

    static constexpr auto describe() {
        using T = IsoscelesTriangle;
        return shape<T>(
            {.key = "isosceles_triangle",
             .doc = "Triangle with its apex above the middle of its base, half its height about the local origin."},
            fields(
                field("width", &T::width, {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Of the base."}),
                field("height", &T::height,
                      {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the base to the apex."})),
            contract("height / 100 <= width <= 100 height", [](const auto& triangle) {
                return triangle.height <= 100 * triangle.width && triangle.width <= 100 * triangle.height;
            }));
    }
};

}  // namespace pinfield::sdf

#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Two level sides, one above the other, centred on the local origin; a triangle where one of them has no length.
template <class Real>
struct Trapezoid {
    static constexpr int most_pieces = 4;
    static constexpr bool convex = true;

    Real bottom = Real(0.09), top = Real(0.05), height = Real(0.05);

    void outline(Outline& out) const {
        const double b = 0.5 * bottom, t = 0.5 * top, y = 0.5 * height;
        outline_through(out, {{-b, -y}, {b, -y}, {t, y}, {-t, y}});
    }

    static constexpr auto describe() {
        using T = Trapezoid;
        return shape<T>(
            {.key = "trapezoid", .doc = "Symmetrical trapezoid centred on the local origin."},
            fields(
                field("bottom", &T::bottom,
                      {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "Full width below."}),
                field("top", &T::top, {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "Full width above."}),
                field("height", &T::height,
                      {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full height."})),
            contract("height / 100 <= the larger width <= 100 height",
                     [](const auto& trapezoid) {
                         const auto width = max(trapezoid.bottom, trapezoid.top);
                         return trapezoid.height <= 100 * width && width <= 100 * trapezoid.height;
                     }),
            // The lanes of a float packet could not tell nearer corners apart, nor which of them a point lies beyond.
            contract("the smaller width is 0, or at least a thousandth of the other and of the height",
                     [](const auto& trapezoid) {
                         const auto smaller = min(trapezoid.bottom, trapezoid.top);
                         return smaller == 0 ||
                                1000 * smaller >= max(trapezoid.height, max(trapezoid.bottom, trapezoid.top));
                     }));
    }
};

}  // namespace pinfield::sdf

#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Rectangle centred on the local origin and sheared along x.
template <class Real>
struct Parallelogram {
    static constexpr int most_pieces = 4;
    static constexpr bool convex = true;

    Real width = Real(0.07), height = Real(0.05), skew = Real(0.03);

    void outline(Outline& out) const {
        const double x = 0.5 * width, y = 0.5 * height, s = 0.5 * skew;
        outline_through(out, {{-x - s, -y}, {x - s, -y}, {x + s, y}, {-x + s, y}});
    }

    static constexpr auto describe() {
        using T = Parallelogram;
        return shape<T>(
            {.key = "parallelogram", .doc = "Rectangle centred on the local origin, its top pushed sideways."},
            fields(
                field("width", &T::width,
                      {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Length of the two level sides."}),
                field("height", &T::height,
                      {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full height."}),
                field("skew", &T::skew,
                      {.unit = Unit::metre, .step = 0.001, .doc = "How far the top is to the right of the bottom."})),
            contract("width + |skew| <= 100 height",
                     [](const auto& p) { return p.width + abs(p.skew) <= 100 * p.height; }),
            contract("height + |skew| <= 100 width",
                     [](const auto& p) { return p.height + abs(p.skew) <= 100 * p.width; }));
    }
};

}  // namespace pinfield::sdf

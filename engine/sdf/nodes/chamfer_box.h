#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Rectangle centred on the local origin, its corners cut off at 45 degrees.
template <class Real>
struct ChamferBox {
    static constexpr int most_pieces = 8;
    static constexpr bool convex = true;

    Point<Real> size{Real(0.1), Real(0.06)};
    Real chamfer = Real(0.015);

    void outline(Outline& out) const {
        const double x = 0.5 * size.x, y = 0.5 * size.y, u = x - chamfer, v = y - chamfer;
        outline_through(out, {{x, -v}, {x, v}, {u, y}, {-u, y}, {-x, v}, {-x, -v}, {-u, -y}, {u, -y}});
    }

    static constexpr auto describe() {
        using T = ChamferBox;
        return shape<T>(
            {.key = "chamfer_box", .doc = "Rectangle centred on the local origin, its corners cut off at 45 degrees."},
            fields(field("size", &T::size,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full width and height."}),
                   field("chamfer", &T::chamfer,
                         {.unit = Unit::metre,
                          .min = from(0),
                          .step = 0.0005,
                          .doc = "What each cut takes off either side."})),
            contract("chamfer <= half the smaller side",
                     [](const auto& box) { return box.chamfer <= 0.5 * min(box.size.x, box.size.y); }),
            contract("no side is more than 1000 times the other", [](const auto& box) {
                return max(box.size.x, box.size.y) <= 1000 * min(box.size.x, box.size.y);
            }));
    }
};

}  // namespace pinfield::sdf

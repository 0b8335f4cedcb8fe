#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Four equal sides about the local origin, the corners on the axes.
template <class Real>
struct Rhombus {
    static constexpr int most_pieces = 4;
    static constexpr bool convex = true;

    Point<Real> size{Real(0.06), Real(0.09)};

    void outline(Outline& out) const {
        const double x = 0.5 * size.x, y = 0.5 * size.y;
        outline_through(out, {{x, 0}, {0, y}, {-x, 0}, {0, -y}});
    }

    static constexpr auto describe() {
        return shape<Rhombus>(
            {.key = "rhombus", .doc = "Diamond about the local origin, its corners on the axes."},
            fields(field(
                "size", &Rhombus::size,
                {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full width and height: the diagonals."})),
            contract("no diagonal is more than 100 times the other", [](const auto& rhombus) {
                return max(rhombus.size.x, rhombus.size.y) <= 100 * min(rhombus.size.x, rhombus.size.y);
            }));
    }
};

}  // namespace pinfield::sdf

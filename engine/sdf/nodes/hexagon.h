#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Six equal sides about the local origin, the lowest one level: a regular_polygon given by its sides' distance.
template <class Real>
struct Hexagon {
    static constexpr int most_pieces = 6;
    static constexpr bool convex = true;

    Real apothem = Real(0.04);

    void outline(Outline& out) const { outline_regular_polygon(out, 6, apothem); }

    static constexpr auto describe() {
        return shape<Hexagon>(
            {.key = "hexagon", .doc = "Six equal sides about the local origin, the lowest one level."},
            fields(
                field("apothem", &Hexagon::apothem,
                      {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the centre to each side."})));
    }
};

}  // namespace pinfield::sdf

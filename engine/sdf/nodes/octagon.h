#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Eight equal sides about the local origin, the lowest one level: a regular_polygon given by its sides' distance.
template <class Real>
struct Octagon {
    static constexpr int most_pieces = 8;
    static constexpr bool convex = true;

    Real apothem = Real(0.04);

    void outline(Outline& out) const { outline_regular_polygon(out, 8, apothem); }

    static constexpr auto describe() {
        return shape<Octagon>(
            {.key = "octagon", .doc = "Eight equal sides about the local origin, the lowest one level."},
            fields(
                field("apothem", &Octagon::apothem,
                      {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the centre to each side."})));
    }
};

}  // namespace pinfield::sdf

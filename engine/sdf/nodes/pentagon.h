#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Five equal sides about the local origin, the lowest one level: a regular_polygon given by its sides' distance.
template <class Real>
struct Pentagon {
    static constexpr int most_pieces = 5;
    static constexpr bool convex = true;

    Real apothem = Real(0.04);

    void outline(Outline& out) const { outline_regular_polygon(out, 5, apothem); }

    static constexpr auto describe() {
        return shape<Pentagon>(
            {.key = "pentagon", .doc = "Five equal sides about the local origin, the lowest one level."},
            fields(
                field("apothem", &Pentagon::apothem,
                      {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the centre to each side."})));
    }
};

}  // namespace pinfield::sdf

#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Star within the five diagonals of a regular pentagon about the local origin.
template <class Real>
struct Pentagram {
    static constexpr int most_pieces = 10;

    Real radius = Real(0.05);

    /// The diagonals cross in a pentagon that is smaller by the square of the golden ratio.
    void outline(Outline& out) const { outline_star(out, 5, radius, radius * 0.5 * (3 - sqrt(5.0))); }

    static constexpr auto describe() {
        return shape<Pentagram>(
            {.key = "pentagram",
             .doc = "Five-pointed star of straight strokes about the local origin, a tip straight up."},
            fields(field("radius", &Pentagram::radius,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the centre to a tip."})));
    }
};

}  // namespace pinfield::sdf

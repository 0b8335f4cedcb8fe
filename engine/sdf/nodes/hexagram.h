#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Star of two equilateral triangles, one turned by half a turn, about the local origin.
template <class Real>
struct Hexagram {
    static constexpr int most_pieces = 12;

    Real radius = Real(0.05);

    /// The notches are the corners of the hexagon that both triangles share; its side is a third of theirs.
    void outline(Outline& out) const { outline_star(out, 6, radius, radius / sqrt(3.0)); }

    static constexpr auto describe() {
        return shape<Hexagram>(
            {.key = "hexagram", .doc = "Six-pointed star of two triangles about the local origin, a tip straight up."},
            fields(field("radius", &Hexagram::radius,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the centre to a tip."})));
    }
};

}  // namespace pinfield::sdf

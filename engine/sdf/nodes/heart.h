#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// A square standing on a corner, with a half disc over each of its two upper sides (Quilez, "distfunctions2d"). The local origin is
/// the square's centre.
template <class Real>
struct Heart {
    static constexpr int most_pieces = 4;

    Real size = Real(0.1);

    /// With c from the centre of the square to a corner the half discs have radius c sqrt(1/2) about (+-c/2, c/2).
    void outline(Outline& out) const {
        const double c = size / (1 + sqrt(2.0)), h = 0.5 * c;
        OutlinePen pen(out, {0, -c});
        pen.line_to({c, 0});
        pen.arc_to({0, c}, {h, h}, 1);
        pen.arc_to({-c, 0}, {-h, h}, 1);
        pen.close();
    }

    static constexpr auto describe() {
        return shape<Heart>({.key = "heart",
                             .doc = "Square on its corner, with a half disc over each upper side; the square's centre is the origin."},
                            fields(field("size", &Heart::size,
                                         {.unit = Unit::metre, .min = above(0), .step = 0.001,
                                          .doc = "Full width; the height is 0.914 of it."})));
    }
};

}  // namespace pinfield::sdf

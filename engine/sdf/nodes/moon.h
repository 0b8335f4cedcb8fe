#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// Disc about the local origin without the disc about [offset, 0]: a crescent, a disc with a bite, or, where the second disc lies
/// within the first or apart from it, a disc with a hole or a whole one.
template <class Real>
struct Moon {
    static constexpr int most_pieces = 2;

    Real radius = Real(0.05);
    Real bite = Real(0.045);
    Real offset = Real(0.025);

    void outline(Outline& out) const {
        const Vec2 centre(0, 0), bite_centre(offset, 0);
        if (offset >= radius + bite) return out.push_back(Piece::circle(centre, radius));
        if (offset + bite <= radius) {
            out.push_back(Piece::circle(centre, radius));
            return out.push_back(Piece::circle(bite_centre, bite, -1));
        }
        // The circles cross at x = (d^2 + R^2 - b^2) / 2d; both factors of the height's square are positive here.
        const double x = 0.5 * (offset + (radius - bite) * (radius + bite) / offset);
        const double y = sqrt(max(0.0, (radius - x) * (radius + x)));
        const Vec2 upper(x, y), lower(x, -y);
        if (!(y > 0)) return out.push_back(Piece::circle(centre, radius));
        OutlinePen pen(out, upper);
        pen.arc_to(lower, centre, 1, x > 0);  // the long way round
        pen.arc_to(upper, bite_centre, -1, x > offset);
    }

    static constexpr auto describe() {
        return shape<Moon>(
            {.key = "moon", .doc = "Disc about the local origin with another disc taken out of it."},
            fields(
                field("radius", &Moon::radius, {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Of the disc."}),
                field("bite", &Moon::bite, {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Radius of the disc taken out."}),
                field("offset", &Moon::offset,
                      {.unit = Unit::metre,
                       .min = from(0),
                       .step = 0.001,
                       .doc = "From the disc's centre to that of the disc taken out, along +x."})),
            contract("something is left: bite < radius + offset", [](const auto& moon) { return moon.bite < moon.radius + moon.offset; }));
    }
};

}  // namespace pinfield::sdf

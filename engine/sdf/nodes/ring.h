#pragma once
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// Circular wall with flat ends, counter-clockwise from one angle to the other; the whole annulus when they are 360 degrees apart.
/// A wall twice as thick as its radius fills the middle: a sector, or a disc.
template <class Real>
struct Ring {
    static constexpr int most_pieces = 4;

    Real radius = Real(0.04);
    Real from = Real(-30);
    Real to = Real(210);
    Real thickness = Real(0.015);

    void outline(Outline& out) const {
        const double outer = radius + 0.5 * thickness, inner = thickness == 2 * radius ? 0 : radius - 0.5 * thickness;
        if (to - from == 360) {
            out.push_back(Piece::circle({0, 0}, outer));
            if (inner > 0) out.push_back(Piece::circle({0, 0}, inner, -1));
            return;
        }
        const SineCosine at_from = sine_cosine_degrees(from), at_to = sine_cosine_degrees(to);
        const Vec2 first(at_from.cosine, at_from.sine), last(at_to.cosine, at_to.sine);
        const bool reflex = to - from > 180;
        OutlinePen pen(out, inner * first);
        pen.line_to(outer * first);
        pen.arc_to(outer * last, {0, 0}, 1, reflex);
        pen.line_to(inner * last);
        pen.arc_to(inner * first, {0, 0}, -1, reflex);
    }

    static constexpr auto describe() {
        return shape<Ring>(
            {.key = "ring", .doc = "Circular wall with flat ends, counter-clockwise between two angles; a whole annulus at 360 degrees."},
            fields(field("radius", &Ring::radius,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the local origin to the middle of the wall."}),
                   field("from", &Ring::from,
                         {.unit = Unit::degree, .min = pinfield::from(-720), .max = pinfield::to(720), .step = 1,
                          .doc = "Where the wall begins."}),
                   field("to", &Ring::to,
                         {.unit = Unit::degree, .min = pinfield::from(-720), .max = pinfield::to(720), .step = 1,
                          .doc = "Where it ends, counter-clockwise of the beginning."}),
                   field("thickness", &Ring::thickness,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the wall."})),
            contract("from + 1 <= to <= from + 359, or to = from + 360",
                     [](const auto& ring) {
                         const auto apart = ring.to - ring.from;
                         return (apart >= 1 && apart <= 359) || apart == 360;
                     }),
            contract("0.001 radius <= thickness <= 1.99 radius, or thickness = 2 radius", [](const auto& ring) {
                return ring.thickness == 2 * ring.radius ||
                       (ring.thickness >= 0.001 * ring.radius && ring.thickness <= 1.99 * ring.radius);
            }));
    }
};

}  // namespace pinfield::sdf

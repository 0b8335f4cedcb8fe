#pragma once
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// Sector of a disc, counter-clockwise from one angle to the other; the whole disc when they are 360 degrees apart.
template <class Real>
struct Pie {
    static constexpr int most_pieces = 3;

    Real radius = Real(0.05);
    Real from = Real(30);
    Real to = Real(330);

    void outline(Outline& out) const {
        if (to - from == 360) return out.push_back(Piece::circle({0, 0}, radius));
        const SineCosine first = sine_cosine_degrees(from), last = sine_cosine_degrees(to);
        OutlinePen pen(out, {0, 0});
        pen.line_to(radius * Vec2(first.cosine, first.sine));
        pen.arc_to(radius * Vec2(last.cosine, last.sine), {0, 0}, 1, to - from > 180);
        pen.close();
    }

    static constexpr auto describe() {
        return shape<Pie>(
            {.key = "pie", .doc = "Sector of a disc about the local origin."},
            fields(field("radius", &Pie::radius, {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Of the disc."}),
                   field("from", &Pie::from,
                         {.unit = Unit::degree, .step = 1, .doc = "Direction of the first side, counter-clockwise from +x."}),
                   field("to", &Pie::to, {.unit = Unit::degree, .step = 1, .doc = "Direction of the second side."})),
            contract("from + 0.5 <= to <= from + 359.5, or to = from + 360", [](const auto& pie) {
                const auto apart = pie.to - pie.from;
                return (apart >= 0.5 && apart <= 359.5) || apart == 360;
            }));
    }
};

}  // namespace pinfield::sdf

#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Plus sign about the local origin: two bars of the same size, across each other; a square when they are as thick as
/// long.
template <class Real>
struct Cross {
    static constexpr int most_pieces = 20;

    Real length = Real(0.09), thickness = Real(0.03), round = Real(0);

    /// Arm by arm, counter-clockwise from +x, each from one inner corner to the next.
    void outline(Outline& out) const {
        const double t = 0.5 * snapped(thickness, length, length), r = snapped(round, 0, thickness);
        const double tip = 0.5 * length, shoulder = max(t, tip - r);
        OutlinePen pen(out, {t, -t});
        for (const Vec2& along : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
            const auto place = [&](double x, double y) { return Vec2(x * along + y * perpendicular(along)); };
            pen.line_to(place(shoulder, -t));
            pen.arc_to(place(tip, r - t), place(shoulder, r - t), 1);
            pen.line_to(place(tip, t - r));
            pen.arc_to(place(shoulder, t), place(shoulder, t - r), 1);
            pen.line_to(place(t, t));
        }
    }

    static constexpr auto describe() {
        return shape<Cross>(
            {.key = "cross", .doc = "Plus sign about the local origin; the corners of its arms may be rounded."},
            fields(field("length", &Cross::length,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full length of each bar."}),
                   field("thickness", &Cross::thickness,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full width of each bar."}),
                   field("round", &Cross::round,
                         {.unit = Unit::metre,
                          .min = from(0),
                          .step = 0.0005,
                          .doc = "Radius of the outer corners, within the length."})),
            contract("length / 1000 <= thickness <= length",
                     [](const auto& c) { return c.length <= 1000 * c.thickness && c.thickness <= c.length; }),
            contract("round <= half the thickness, and no more than an arm sticks out",
                     [](const auto& c) { return c.round <= 0.5 * min(c.thickness, c.length - c.thickness); }));
    }
};

}  // namespace pinfield::sdf

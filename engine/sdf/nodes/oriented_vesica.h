#pragma once
#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/nodes/vesica.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// Lens with its tips at a and b, the points within both of two equal discs; a disc when it is as wide as the tips are apart.
template <class Real>
struct OrientedVesica {
    static constexpr int most_pieces = 2;
    static constexpr bool convex = true;

    Point<double> a{-0.04, -0.02}, b{0.04, 0.02};
    Real width = Real(0.04);

    double apart() const { return pinfield::length(Vec2(b.x - a.x, b.y - a.y)); }
    void outline(Outline& out) const { draw_lens(out, {a.x, a.y}, {b.x, b.y}, 0.5 * width); }

    static constexpr auto describe() {
        return shape<OrientedVesica>(
            {.key = "oriented_vesica", .doc = "Lens from tip to tip."},
            fields(field("a", &OrientedVesica::a, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "First tip."}),
                   field("b", &OrientedVesica::b, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Second tip."}),
                   field("width", &OrientedVesica::width,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full width in the middle."})),
            contract("0.01 |b - a| <= width <= |b - a|",
                     [](const auto& vesica) { return vesica.width >= 0.01 * vesica.apart() && vesica.width <= vesica.apart(); }));
    }
};

}  // namespace pinfield::sdf

#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Rectangle centred on the local origin, each corner with a rounding of its own. Two roundings may meet on a side and
/// any one may take a whole side, which makes drops, leaves and quarter discs.
template <class Real>
struct RoundedBox {
    static constexpr int most_pieces = 8;
    static constexpr bool convex = true;

    Point<Real> size{Real(0.1), Real(0.06)};
    Real top_right = Real(0.03), bottom_right = Real(0.01), bottom_left = Real(0), top_left = Real(0.02);

    void outline(Outline& out) const {
        const double x = 0.5 * size.x, y = 0.5 * size.y;
        const auto rounding = [&](double radius) { return snapped(radius, 0, min(x, y)); };
        const double tr = rounding(top_right), br = rounding(bottom_right), bl = rounding(bottom_left),
                     tl = rounding(top_left);
        // Each side ends where its second rounding starts: where two meet, a rounding error must not turn the side
        // round.
        OutlinePen pen(out, {x, br - y});
        pen.line_to({x, max(br - y, y - tr)});
        pen.arc_to({x - tr, y}, {x - tr, y - tr}, 1);
        pen.line_to({min(x - tr, tl - x), y});
        pen.arc_to({-x, y - tl}, {tl - x, y - tl}, 1);
        pen.line_to({-x, min(y - tl, bl - y)});
        pen.arc_to({bl - x, -y}, {bl - x, bl - y}, 1);
        pen.line_to({max(bl - x, x - br), -y});
        pen.arc_to({x, br - y}, {x - br, br - y}, 1);
    }

    static constexpr auto describe() {
        using T = RoundedBox;
        constexpr FieldMeta radius{
            .unit = Unit::metre, .min = from(0), .step = 0.0005, .doc = "Radius of that corner."};
        return shape<T>(
            {.key = "rounded_box",
             .doc = "Rectangle centred on the local origin, each corner with a rounding of its own."},
            fields(field("size", &T::size,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full width and height."}),
                   field("top_right", &T::top_right, radius), field("bottom_right", &T::bottom_right, radius),
                   field("bottom_left", &T::bottom_left, radius), field("top_left", &T::top_left, radius)),
            contract("the two radii on a side are together no longer than it",
                     [](const auto& box) {
                         return max(box.top_left + box.top_right, box.bottom_left + box.bottom_right) <= box.size.x &&
                                max(box.top_left + box.bottom_left, box.top_right + box.bottom_right) <= box.size.y;
                     }),
            contract("no side is more than 1000 times the other", [](const auto& box) {
                return max(box.size.x, box.size.y) <= 1000 * min(box.size.x, box.size.y);
            }));
    }
};

}  // namespace pinfield::sdf

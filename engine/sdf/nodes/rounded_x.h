#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// Two bars of one length with round ends, crossed at a right angle along the diagonals (Quilez, "distfunctions2d", where the inside
/// is not exact; here it is). As thick as it is large it is a disc.
template <class Real>
struct RoundedX {
    static constexpr int most_pieces = 12;

    Real size = Real(0.1);
    Real thickness = Real(0.025);

    /// The ends are discs about (+-c, +-c). Arms shorter than half their width have no sides: there the ends meet on the axes. The
    /// same goes for sides too short for their direction's digits.
    void outline(Outline& out) const {
        const double r = 0.5 * thickness, c = 0.5 * (size - thickness), side = r * sqrt(0.5);
        if (c == 0) return out.push_back(Piece::circle({0, 0}, r));
        const bool has_sides = c * sqrt(2.0) > (1 + 1e-8) * r;
        const double notch = has_sides ? r * sqrt(2.0) : c + sqrt((r - c) * (r + c));
        OutlinePen pen(out, {notch, 0});
        Vec2 x(1, 0), y(0, 1);
        for (int arm = 0; arm < 4; ++arm) {
            const Vec2 end = c * (x + y);
            if (has_sides) {
                pen.line_to(end + side * (x - y));
                pen.arc_to(end + side * (y - x), end, 1);
                pen.line_to(notch * y);
            } else {
                pen.arc_to(notch * y, end, 1);
            }
            x = y;
            y = perpendicular(x);
        }
    }

    static constexpr auto describe() {
        return shape<RoundedX>(
            {.key = "rounded_x", .doc = "Two bars with round ends, crossed along the diagonals."},
            fields(field("size", &RoundedX::size, {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full width and height."}),
                   field("thickness", &RoundedX::thickness,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the bars."})),
            contract("0.001 size <= thickness <= size",
                     [](const auto& cross) { return cross.thickness >= 0.001 * cross.size && cross.thickness <= cross.size; }));
    }
};

}  // namespace pinfield::sdf

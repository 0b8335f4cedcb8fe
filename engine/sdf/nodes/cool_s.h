#pragma once
#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// The pointed S of every school desk, as a solid ribbon about the local origin. Two slits part its strands; they are cut from the
/// right-hand strands' side, so that the middle strand keeps its straight edges. Without slits it is the figure's silhouette. (Quilez,
/// "distfunctions2d", draws the strokes instead: there the field is zero inside the solid.)
template <class Real>
struct CoolS {
    static constexpr int most_pieces = 20;

    Real size = Real(0.12);
    Real gap = Real(0.004);

    /// In fifths of half the height the strands are 2 wide, their straight parts 2 long, and every other edge runs diagonally. The corners
    /// from the top down the left-hand side; half a turn gives the other side.
    void outline(Outline& out) const {
        const double u = 0.1 * size, g = 0.5 * gap, slant = gap * sqrt(2.0) - g;
        const Vec2 upper[] = {{0, 5 * u}, {-2 * u, 3 * u}, {-2 * u, u}};
        const Vec2 slit[] = {{g, -u - g}, {g, -3 * u}, {-g, -3 * u}, {-g, -u - slant}};
        const double lip = gap * sqrt(0.5);
        OutlinePen pen(out, upper[0]);
        for (const double side : {1.0, -1.0}) {
            for (const Vec2& p : upper) pen.line_to(side * p);
            if (gap > 0)
                for (const Vec2& p : slit) pen.line_to(side * p);
            for (const Vec2& p : {Vec2(-u - lip, -lip), Vec2(-2 * u, -u), Vec2(-2 * u, -3 * u)}) pen.line_to(side * p);
        }
        pen.close();
    }

    static constexpr auto describe() {
        return shape<CoolS>({.key = "cool_s", .doc = "The pointed S of every school desk, as a solid ribbon about the local origin."},
                            fields(field("size", &CoolS::size,
                                         {.unit = Unit::metre, .min = above(0), .step = 0.001,
                                          .doc = "Full height; the width is 0.4 of it."}),
                                   field("gap", &CoolS::gap,
                                         {.unit = Unit::metre, .min = from(0), .step = 0.0005,
                                          .doc = "Full width of the two slits between the strands; 0 for the silhouette alone."})),
                            contract("0.001 size <= gap <= 0.1 size, or gap = 0", [](const auto& s) {
                                return s.gap == 0 || (s.gap >= 0.001 * s.size && s.gap <= 0.1 * s.size);
                            }));
    }
};

}  // namespace pinfield::sdf

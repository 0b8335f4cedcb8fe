#pragma once
#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// Cross whose four bays are arcs (after Quilez, "distfunctions2d"): each leaves the tip of the longer arm along the arm and runs to
/// the tip of the shorter one. Where Quilez' arms end in cusps, which no finite precision can tell from nothing, these end in a flat tip.
/// With equal arms it is a square without a disc about each corner; with a tip as wide as an arm is long, a rectangle.
template <class Real>
struct CircleCross {
    static constexpr int most_pieces = 8;

    Point<double> size{0.1, 0.1};
    Real tip = Real(0.012);

    void outline(Outline& out) const {
        const Vec2 half(0.5 * size.x, 0.5 * size.y), bay = half - Vec2(0.5 * tip, 0.5 * tip);
        const double longer = max(bay.x(), bay.y()), shorter = min(bay.x(), bay.y());
        const double radius = shorter > 0 ? 0.5 * (longer * (longer / shorter) + shorter) : 0;
        const Vec2 centre = bay.x() >= bay.y() ? Vec2(half.x(), 0.5 * tip + radius) : Vec2(0.5 * tip + radius, half.y());
        OutlinePen pen(out, {half.x(), 0.5 * tip});
        for (int quarter = 0; quarter < 4; ++quarter) {
            const Vec2 side(quarter == 0 || quarter == 3 ? 1 : -1, quarter < 2 ? 1 : -1);
            const Vec2 on_x = side.cwiseProduct(Vec2(half.x(), 0.5 * tip)), on_y = side.cwiseProduct(Vec2(0.5 * tip, half.y()));
            pen.line_to(quarter % 2 == 0 ? on_x : on_y);
            const Vec2& end = quarter % 2 == 0 ? on_y : on_x;
            if (shorter > 0) pen.arc_to(end, side.cwiseProduct(centre), -1);
            else pen.line_to(end);
        }
        pen.close();
    }

    static constexpr auto describe() {
        return shape<CircleCross>(
            {.key = "circle_cross", .doc = "Cross about the local origin whose arms are bounded by four arcs."},
            fields(field("size", &CircleCross::size,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full width and height."}),
                   field("tip", &CircleCross::tip,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the arms at their ends."})),
            contract("tip >= 0.001 of the larger size",
                     [](const auto& cross) { return cross.tip >= 0.001 * max(cross.size.x, cross.size.y); }),
            contract("the bays are at least 0.001 of the larger size deep, or tip is the smaller size", [](const auto& cross) {
                const double larger = max(cross.size.x, cross.size.y), smaller = min(cross.size.x, cross.size.y);
                return smaller - cross.tip >= 0.002 * larger || smaller == cross.tip;
            }));
    }
};

}  // namespace pinfield::sdf

#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// What a level cut leaves of a disc above it (Quilez, "distfunctions2d"): a cap, a half disc, or nearly all of it.
template <class Real>
struct CutDisk {
    static constexpr int most_pieces = 2;

    Real radius = Real(0.05);
    Real height = Real(-0.015);

    void outline(Outline& out) const {
        if (height == -radius) return out.push_back(Piece::circle({0, 0}, radius));
        const double half_cut = sqrt((radius - height) * (radius + height));
        OutlinePen pen(out, {-half_cut, height});
        pen.line_to({half_cut, height});
        pen.arc_to({-half_cut, height}, {0, 0}, 1, height < 0);
    }

    static constexpr auto describe() {
        return shape<CutDisk>(
            {.key = "cut_disk", .doc = "The part of a disc about the local origin that lies above a level cut."},
            fields(field("radius", &CutDisk::radius, {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Of the disc."}),
                   field("height", &CutDisk::height,
                         {.unit = Unit::metre, .step = 0.001,
                          .doc = "Of the cut above the disc's centre; below 0 more than half of the disc is left."})),
            contract("-0.999 radius <= height <= 0.999 radius, or height = -radius for the whole disc", [](const auto& disk) {
                return disk.height == -disk.radius ||
                       (disk.height >= -0.999 * disk.radius && disk.height <= 0.999 * disk.radius);
            }));
    }
};

}  // namespace pinfield::sdf

#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// Box with a half disc on top, as wide as the box (Quilez, "distfunctions2d"), centred on the local origin; only the half disc when
/// it is half as high as wide.
template <class Real>
struct Tunnel {
    static constexpr int most_pieces = 4;
    static constexpr bool convex = true;

    Real width = Real(0.06);
    Real height = Real(0.08);

    void outline(Outline& out) const {
        const double x = 0.5 * width, y = 0.5 * height, springing = height == x ? -y : y - x;
        OutlinePen pen(out, {-x, -y});
        pen.line_to({x, -y});
        pen.line_to({x, springing});
        pen.arc_to({-x, springing}, {0, springing}, 1);
        pen.close();
    }

    static constexpr auto describe() {
        return shape<Tunnel>({.key = "tunnel", .doc = "Box with a half disc on top, the whole centred on the local origin."},
                             fields(field("width", &Tunnel::width,
                                          {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full size along x."}),
                                    field("height", &Tunnel::height,
                                          {.unit = Unit::metre, .min = above(0), .step = 0.001,
                                           .doc = "Full size along y, half disc included."})),
                             contract("0.5 width <= height <= 1000 width", [](const auto& tunnel) {
                                 return tunnel.height >= 0.5 * tunnel.width && tunnel.height <= 1000 * tunnel.width;
                             }));
    }
};

}  // namespace pinfield::sdf

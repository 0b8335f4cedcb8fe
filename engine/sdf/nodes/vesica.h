#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// The lens with tips a and b: two arcs, each reaching half_width (at most half the distance of the tips) beside the middle.
inline void draw_lens(Outline& out, const Vec2& a, const Vec2& b, double half_width) {
    const double half_length = 0.5 * length(b - a);
    const Vec2 middle = a + 0.5 * (b - a), aside = perpendicular(b - a) / (2 * half_length);
    if (half_width == half_length) return out.push_back(Piece::circle(middle, half_length));
    const double to_centre = 0.5 * (half_length - half_width) * (half_length + half_width) / half_width;
    OutlinePen pen(out, b);
    pen.arc_to(a, middle - to_centre * aside, 1);
    pen.arc_to(b, middle + to_centre * aside, 1);
}

/// Lens about the local origin, the points within both of two equal discs. Its tips lie on the x axis where it is longer than
/// wide, on the y axis where it is wider than long; in between it is a disc.
template <class Real>
struct Vesica {
    static constexpr int most_pieces = 2;
    static constexpr bool convex = true;

    Real length = Real(0.1);
    Real width = Real(0.05);

    void outline(Outline& out) const {
        const double x = 0.5 * length, y = 0.5 * width;
        if (x >= y) draw_lens(out, {-x, 0}, {x, 0}, y);
        else draw_lens(out, {0, -y}, {0, y}, x);
    }

    static constexpr auto describe() {
        return shape<Vesica>({.key = "vesica", .doc = "Lens about the local origin; its tips are the ends of the longer way across."},
                             fields(field("length", &Vesica::length,
                                          {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full size along x."}),
                                    field("width", &Vesica::width,
                                          {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full size along y."})),
                             contract("neither length nor width is more than 100 times the other", [](const auto& vesica) {
                                 return vesica.length <= 100 * vesica.width && vesica.width <= 100 * vesica.length;
                             }));
    }
};

}  // namespace pinfield::sdf

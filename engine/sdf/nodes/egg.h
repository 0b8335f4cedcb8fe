#pragma once
#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// Two discs, one above the other, and around them a side on either hand: an arc tangent to both (Quilez, "distfunctions2d").
/// `bulge` is the whole height over the diameter of these arcs: at 0 the sides are straight, at 1 the egg is round. Where the one
/// disc lies within the other the egg is the larger disc; a disc of radius 0 is a pointed end.
template <class Real>
struct Egg {
    static constexpr int most_pieces = 4;
    static constexpr bool convex = true;

    Real lower_radius = Real(0.035);
    Real upper_radius = Real(0.015);
    Real height = Real(0.04);
    Real bulge = Real(0.6);

    /// With r the radius of a side, its centre is r - lower_radius from the lower disc's centre and r - upper_radius from the upper
    /// one's: the sides of a triangle over `height` give the slopes of the normals n at the two points of contact. All is multiplied by
    /// `whole` / r, so that flat sides lose no digits.
    void outline(Outline& out) const {
        const double a = lower_radius, b = upper_radius, whole = height + a + b;
        // Within rounding of touching from inside, too: there the points of contact are one, and nothing would be left of the larger disc.
        if (height - abs(a - b) <= 1e-12 * whole) return out.push_back(a > b ? Piece::circle({0, 0}, a) : Piece::circle({0, height}, b));
        if (bulge == 1) return out.push_back(Piece::circle({0, 0.5 * (height + b - a)}, 0.5 * whole));
        const double reach_a = height + (b - a) + 2 * a * (1 - bulge), reach_b = height + (a - b) + 2 * b * (1 - bulge);
        const double lean = (a - b) * (whole - bulge * (a + b)), bend = bulge * height * height;
        const Vec2 normal_a = unit_with_y((lean - bend) / (height * reach_a)), normal_b = unit_with_y((lean + bend) / (height * reach_b));
        const Vec2 contact_a = a * normal_a, contact_b = Vec2(0, height) + b * normal_b;
        OutlinePen pen(out, mirrored(contact_a));
        pen.arc_to(contact_a, {0, 0}, 1, normal_a.y() > 0);
        if (bulge > 0) pen.arc_to(contact_b, -0.5 * reach_a / bulge * normal_a, 1);
        else pen.line_to(contact_b);
        pen.arc_to(mirrored(contact_b), {0, height}, 1, normal_b.y() < 0);
        if (bulge > 0) pen.arc_to(mirrored(contact_a), mirrored(-0.5 * reach_a / bulge * normal_a), 1);
        else pen.close();
    }

    static constexpr auto describe() {
        return shape<Egg>(
            {.key = "egg", .doc = "Two discs, one above the other, between two arcs that touch both."},
            fields(field("lower_radius", &Egg::lower_radius,
                         {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "Of the disc about the local origin; 0 for a pointed end."}),
                   field("upper_radius", &Egg::upper_radius,
                         {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "Of the disc above it; 0 for a pointed end."}),
                   field("height", &Egg::height, {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "Between the centres of the discs."}),
                   field("bulge", &Egg::bulge,
                         {.min = from(0), .max = to(1), .step = 0.01, .doc = "How round the sides are: straight at 0, a full disc at 1."})),
            contract("a radius is above 0, and height <= 100 times the larger one",
                     [](const auto& egg) {
                         const auto larger = max(egg.lower_radius, egg.upper_radius);
                         return larger > 0 && egg.height <= 100 * larger;
                     }),
            contract("bulge = 0 or bulge >= 0.001", [](const auto& egg) { return egg.bulge == 0 || egg.bulge >= 0.001; }));
    }

private:
    static Vec2 unit_with_y(double y) {
        const double slope = clamp(y, -1.0, 1.0);
        return {sqrt((1 - slope) * (1 + slope)), slope};
    }
    static Vec2 mirrored(const Vec2& p) { return {-p.x(), p.y()}; }
};

}  // namespace pinfield::sdf

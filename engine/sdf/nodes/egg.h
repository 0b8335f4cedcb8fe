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

    void outline(Outline& out) const {
        const double a = lower_radius, b = upper_radius, whole = height + a + b;
        // A smaller disc that looks out by less than a part in 1e9 would have sides too short for their direction's digits.
        if (height - abs(a - b) <= 1e-9 * whole) return out.push_back(a > b ? Piece::circle({0, 0}, a) : Piece::circle({0, height}, b));
        if (bulge == 1) return out.push_back(Piece::circle({0, 0.5 * (height + b - a)}, 0.5 * whole));
        const Vec2 normal_a = normal_at_contact(a, b), inverted_b = normal_at_contact(b, a), normal_b(inverted_b.x(), -inverted_b.y());
        const double to_side = bulge > 0 ? 0.5 * whole / bulge - a : 0;
        const Vec2 contact_a = a * normal_a, contact_b = Vec2(0, height) + b * normal_b;
        OutlinePen pen(out, mirrored(contact_a));
        pen.arc_to(contact_a, {0, 0}, 1, normal_a.y() > 0);
        if (bulge > 0) pen.arc_to(contact_b, -to_side * normal_a, 1);
        else pen.line_to(contact_b);
        pen.arc_to(mirrored(contact_b), {0, height}, 1, normal_b.y() < 0);
        if (bulge > 0) pen.arc_to(mirrored(contact_a), mirrored(-to_side * normal_a), 1);
        else pen.close();
    }

    static constexpr auto describe() {
        return shape<Egg>(
            {.key = "egg", .doc = "Two discs, one above the other, between two arcs that touch both."},
            fields(field("lower_radius", &Egg::lower_radius,
                         {.unit = Unit::metre, .min = from(0), .step = 0.001,
                          .doc = "Of the disc about the local origin; 0 for a pointed end."}),
                   field("upper_radius", &Egg::upper_radius,
                         {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "Of the disc above it; 0 for a pointed end."}),
                   field("height", &Egg::height,
                         {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "Between the centres of the discs."}),
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
    /// Where the side on the right touches the disc of radius a; +y leads to the other disc, of radius b. The centres of side and
    /// discs are the corners of a triangle with sides height, r - a and r - b, where r = (height + a + b) / (2 bulge). Its law of
    /// cosines, solved for 1 + y and 1 - y apart, has only factors and terms that are never below 0: no digits cancel where
    /// the egg is nearly a disc or its sides are nearly straight.
    Vec2 normal_at_contact(double a, double b) const {
        const double left = 1 - bulge, h = height;
        const double up = left * (h + (a - b)) * (h + a + b), down = (h + (b - a)) * (h + bulge * h + left * (a + b));
        return Vec2(2 * sqrt(up * down), up - down) / (up + down);
    }
    static Vec2 mirrored(const Vec2& p) { return {-p.x(), p.y()}; }
};

}  // namespace pinfield::sdf

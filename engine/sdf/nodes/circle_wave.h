#pragma once
#include <tuple>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/outline.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Wavy wall with round ends, of equal arcs by turns above and below the local x axis that join without a corner (the finite kin of the
/// circle wave of Quilez, distfunctions2d). The outside is always exact. Where arcs of more than half a turn come so near each other that
/// the wall overlaps itself, or it fills its arcs, the inside is a bound.
template <class Real>
struct CircleWave {
    Real radius = Real(0.015);
    Real angle = Real(150);
    int count = 5;
    Real thickness = Real(0.008);
    /// Of half an arc's angle.
    Real sine = Real(1), cosine = Real(0);

    static constexpr auto derived() { return std::tuple(&CircleWave::sine, &CircleWave::cosine); }
    void derive() {
        const SineCosine half = sine_cosine_degrees(0.5 * angle);
        sine = half.sine;
        cosine = half.cosine;
    }

    /// The upper arcs are each other's reflections in the lines halfway between them, so the nearest of them is the one whose middle
    /// is; the same holds for the lower ones.
    Real distance(const Point<Real>& p) const {
        const Real to_upper = distance_to_arcs(p.x, p.y, 0, (count + 1) / 2);
        if (count == 1) return to_upper - thickness * Real(0.5);
        return min(to_upper, distance_to_arcs(p.x, -p.y, 1, count / 2)) - thickness * Real(0.5);
    }
    /// Distance to the middle lines of `n` arcs that bend up, every other one beginning with arc `first`.
    Real distance_to_arcs(const Real& x, const Real& y, int first, int n) const {
        const Real chord = Real(2) * radius * sine, from_first = x - (Real(first) - Real(0.5 * (count - 1))) * chord;
        const Real index = clamp(floor(from_first / (Real(2) * chord) + Real(0.5)), Real(0), Real(n - 1));
        const Point<Real> from_centre{abs(from_first - index * (Real(2) * chord)), y + radius * cosine};
        const auto within = from_centre.x * cosine < from_centre.y * sine;
        const Real to_end = norm(Point<Real>{from_centre.x - radius * sine, y});
        return select(within, abs(norm(from_centre) - radius), to_end);
    }

    /// No part of the wall comes near another: not the two ends of a single arc, an end and the arc after the next joint, or
    /// the flanks of two arcs on one side.
    bool is_plain() const {
        if (!(thickness < 1.95 * radius)) return false;
        if (cosine >= 0) return true;
        double gap = 2 * sine;
        if (count >= 2) gap = min(gap, sqrt(1 + 8 * sine * sine) - 1);
        if (count >= 3) gap = min(gap, 4 * sine - 2);
        return thickness < 0.98 * gap * radius;
    }
    Exactness exactness() const { return {.inside = is_plain() ? Side::exact : Side::bound}; }

    /// Where arc i begins and arc i - 1 ends, the unit vector across the wall there to its left, and the centre of arc i.
    Vec2 joint(int i) const { return {(2 * i - count) * radius * sine, 0}; }
    Vec2 left_at_joint(int i) const { return {i % 2 == 0 ? -sine : sine, cosine}; }
    Vec2 centre(int i) const { return {(2 * i + 1 - count) * radius * sine, (i % 2 == 0 ? -radius : radius) * cosine}; }

    Box2 bounds() const {
        const double half_width = radius * ((count - 1) * sine + (cosine < 0 ? 1.0 : sine)), height = radius * (1 - cosine);
        return Box2{{-half_width, count == 1 ? 0 : -height}, {half_width, height}}.grown(0.5 * thickness);
    }
    /// Empty where the wall overlaps itself.
    void outline(Outline& out) const {
        if (!is_plain()) return;
        const double half = 0.5 * thickness;
        const auto beside = [&](int i, double side) { return Vec2(joint(i) + side * half * left_at_joint(i)); };
        const bool reflex = cosine < 0;
        for (int i = 0; i < count; ++i) {
            const int turn = i % 2 == 0 ? -1 : 1;
            out.push_back(Piece::arc(centre(i), radius + turn * half, beside(i, -1), beside(i + 1, -1), turn, reflex));
        }
        out.push_back(Piece::arc(joint(count), half, beside(count, -1), beside(count, 1), 1, false));
        for (int i = count - 1; i >= 0; --i) {
            const int turn = i % 2 == 0 ? 1 : -1;
            out.push_back(Piece::arc(centre(i), radius + turn * half, beside(i + 1, 1), beside(i, 1), turn, reflex));
        }
        out.push_back(Piece::arc(joint(0), half, beside(0, 1), beside(0, -1), 1, false));
    }

    static constexpr auto describe() {
        using T = CircleWave;
        return shape<T>(
            {.key = "circle_wave", .float_error = 2e-6, .doc = "Wavy wall of equal arcs along the local x axis, with round ends."},
            fields(field("radius", &T::radius,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Of every arc, to the middle of the wall."}),
                   field("angle", &T::angle,
                         {.unit = Unit::degree,
                          .min = from(30),
                          .max = to(300),
                          .step = 1,
                          .doc = "How far every arc turns; above 180 the wave meanders."}),
                   field("count", &T::count, {.min = from(1), .max = to(1000), .step = 1, .doc = "How many arcs; the first one bends up."}),
                   field("thickness", &T::thickness,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the wall."})));
    }
};

}  // namespace pinfield::sdf

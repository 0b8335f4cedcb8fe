#pragma once
#include <tuple>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/edges.h"
#include "engine/sdf/outline.h"

namespace pinfield::sdf {

/// Circular wall with round ends, counter-clockwise from one angle to the other; the full ring when they are 360 degrees apart.
/// The outside is always exact. Where the wall fills its own centre or its ends overlap, the inside is a bound.
template <class Real>
struct Arc {
    Real radius = Real(0.04);
    Real from = Real(0);
    Real to = Real(180);
    Real thickness = Real(0.01);
    /// Direction of the arc's middle, and end of its upper half in the frame that has this middle on +x.
    double middle_cosine = 1, middle_sine = 0, half_cosine = 1, half_sine = 0;

    static constexpr auto derived() {
        return std::tuple(&Arc::middle_cosine, &Arc::middle_sine, &Arc::half_cosine, &Arc::half_sine);
    }
    void derive() {
        const SineCosine middle = sine_cosine_degrees(0.5 * (from + to)), half = sine_cosine_degrees(0.5 * (to - from));
        middle_cosine = middle.cosine;
        middle_sine = middle.sine;
        half_cosine = half.cosine;
        half_sine = half.sine;
    }

    /// The sign of a cross product says whether the point lies within the arc's sector. The nudge keeps that sign right for a
    /// full ring (always within) and for an arc of no length (never within, but for +x, where both answers agree).
    Real distance(const Point<Real>& p) const {
        const Point<Real> q = in_frame(p, middle_cosine, middle_sine);
        const Point<Real> upper{q.x, abs(q.y)};
        const double nudged = half_sine < 1e-30 ? 1e-30 : half_sine;
        const auto within = upper.y * Real(half_cosine) < upper.x * Real(nudged);
        const Real end_x = radius * Real(half_cosine), end_y = radius * Real(half_sine);
        const Real to_end = norm(Point<Real>{upper.x - end_x, upper.y - end_y});
        return select(within, abs(norm(upper) - radius), to_end) - thickness * Real(0.5);
    }
    bool is_ring() const { return to - from >= 360; }
    /// The wall leaves its centre free and its ends keep apart.
    bool is_plain() const {
        if (!(0.5 * thickness < radius)) return false;
        return is_ring() || to - from <= 180 || 2 * radius * half_sine > thickness;
    }
    Exactness exactness() const { return {.inside = is_plain() ? Side::exact : Side::bound}; }

    Vec2 point_at(double angle, double distance_from_centre) const {
        const SineCosine t = sine_cosine_degrees(angle);
        return distance_from_centre * Vec2(t.cosine, t.sine);
    }
    Box2 bounds() const {
        Box2 box = Box2::of(point_at(from, radius), point_at(to, radius));
        for (int quarter = -12; quarter <= 12; ++quarter)
            if (from <= 90 * quarter && 90 * quarter <= to) box = box.including(point_at(90 * quarter, radius));
        return box.grown(0.5 * thickness);
    }
    void outline(Outline& out) const {
        const double half = 0.5 * thickness, outer = radius + half, inner = radius - half;
        if (is_ring()) {
            out.push_back(Piece::circle({0, 0}, outer));
            if (inner > 0) out.push_back(Piece::circle({0, 0}, inner, -1));
            return;
        }
        if (!is_plain()) return outline_of_overlap(out);
        const bool reflex = to - from > 180;
        const Vec2 a = point_at(from, radius), b = point_at(to, radius);
        const Vec2 outer_a = point_at(from, outer), outer_b = point_at(to, outer);
        const Vec2 inner_a = point_at(from, inner), inner_b = point_at(to, inner);
        if (from < to) out.push_back(Piece::arc({0, 0}, outer, outer_a, outer_b, 1, reflex));
        out.push_back(Piece::arc(b, half, outer_b, inner_b, 1, false));
        if (from < to) out.push_back(Piece::arc({0, 0}, inner, inner_b, inner_a, -1, reflex));
        out.push_back(Piece::arc(a, half, inner_a, outer_a, 1, false));
    }

    /// Where the two round ends overlap, their circles cross on the arc's axis: once on the outside and, where the wall leaves its centre
    /// free, once on the hole within.
    void outline_of_overlap(Outline& out) const {
        const double half = 0.5 * thickness, outer = radius + half, inner = radius - half;
        const double aside = radius * half_sine, reach = std::sqrt(max(half * half - aside * aside, 0.0));
        const auto on_axis = [&](double place) { return Vec2(place * middle_cosine, place * middle_sine); };
        const Vec2 a = point_at(from, radius), b = point_at(to, radius);
        const Vec2 outer_a = point_at(from, outer), outer_b = point_at(to, outer), corner = on_axis(radius * half_cosine - reach);
        const bool reflex = to - from > 180;
        if (from < to) out.push_back(Piece::arc({0, 0}, outer, outer_a, outer_b, 1, reflex));
        out.push_back(Piece::arc(b, half, outer_b, corner, 1, false));
        out.push_back(Piece::arc(a, half, corner, outer_a, 1, false));
        if (!(inner > 0)) return;
        const Vec2 inner_a = point_at(from, inner), inner_b = point_at(to, inner), nook = on_axis(radius * half_cosine + reach);
        out.push_back(Piece::arc({0, 0}, inner, inner_b, inner_a, -1, reflex));
        out.push_back(Piece::arc(a, half, inner_a, nook, 1, false));
        out.push_back(Piece::arc(b, half, nook, inner_b, 1, false));
    }

    static constexpr auto describe() {
        return shape<Arc>(
            {.key = "arc", .doc = "Circular wall with round ends, counter-clockwise between two angles."},
            fields(field("radius", &Arc::radius,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the local origin to the middle of the wall."}),
                   field("from", &Arc::from,
                         {.unit = Unit::degree,
                          .min = pinfield::from(-720),
                          .max = pinfield::to(720),
                          .step = 1,
                          .doc = "Where the wall begins."}),
                   field("to", &Arc::to,
                         {.unit = Unit::degree,
                          .min = pinfield::from(-720),
                          .max = pinfield::to(720),
                          .step = 1,
                          .doc = "Where it ends, counter-clockwise of the beginning."}),
                   field("thickness", &Arc::thickness,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the wall."})),
            contract("from <= to <= from + 360", [](const auto& arc) { return arc.from <= arc.to && arc.to <= arc.from + 360; }));
    }
};

}  // namespace pinfield::sdf

#pragma once
#include <tuple>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/outline.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Convex hull of two discs: a about the local origin, b about [length, 0]; a flipper's bat. Where one disc holds the other
/// (length <= |radius_a - radius_b|) it is the larger disc.
template <class Real>
struct UnevenCapsule {
    Real length = Real(0.07);
    Real radius_a = Real(0.0116);
    Real radius_b = Real(0.007);
    /// Centres on the x axis and radii of the two round ends; equal when one disc holds the other.
    Real start_x = Real(0), end_x = Real(0), start_radius = Real(0), end_radius = Real(0);
    /// Normal (sine, cosine) of the upper straight side.
    Real sine = Real(0), cosine = Real(1);

    static constexpr bool convex = true;
    static constexpr auto derived() {
        using T = UnevenCapsule;
        return std::tuple(&T::start_x, &T::end_x, &T::start_radius, &T::end_radius, &T::sine, &T::cosine);
    }
    void derive() {
        const double difference = radius_a - radius_b;
        const bool hull = length > abs(difference);
        const bool a_is_larger = difference >= 0;
        start_x = hull || a_is_larger ? 0.0 : length;
        end_x = hull || !a_is_larger ? length : 0.0;
        start_radius = hull || a_is_larger ? radius_a : radius_b;
        end_radius = hull || !a_is_larger ? radius_b : radius_a;
        sine = hull ? difference / length : 0.0;
        cosine = sqrt((1 - sine) * (1 + sine));
    }

    /// In the upper half the nearest point is on the side where the position along the side lies between the feet of the two
    /// centres, else on the end that lies that way.
    Real distance(const Point<Real>& p) const {
        const Point<Real> from_start{p.x - start_x, abs(p.y)}, from_end{p.x - end_x, abs(p.y)};
        const Real past_start = from_start.x * cosine - from_start.y * sine;
        const Real past_end = from_end.x * cosine - from_end.y * sine;
        const Real side = from_start.x * sine + from_start.y * cosine - start_radius;
        return select(past_start <= Real(0), norm(from_start) - start_radius,
                      select(past_end >= Real(0), norm(from_end) - end_radius, side));
    }
    Box2 bounds() const {
        return Box2{{start_x - start_radius, -start_radius}, {start_x + start_radius, start_radius}}.merged(
            {{end_x - end_radius, -end_radius}, {end_x + end_radius, end_radius}});
    }
    void outline(Outline& out) const {
        const Vec2 start(start_x, 0), end(end_x, 0), up(sine, cosine), down(sine, -cosine);
        if (!(start_x < end_x)) return out.push_back(Piece::circle(start, start_radius));
        out.push_back(Piece::segment(start + start_radius * down, end + end_radius * down));
        out.push_back(Piece::arc(end, end_radius, end + end_radius * down, end + end_radius * up, 1, sine < 0));
        out.push_back(Piece::segment(end + end_radius * up, start + start_radius * up));
        out.push_back(Piece::arc(start, start_radius, start + start_radius * up, start + start_radius * down, 1, sine > 0));
    }

    static constexpr auto describe() {
        using T = UnevenCapsule;
        return shape<T>({.key = "uneven_capsule", .doc = "Convex hull of a disc about the local origin and another about [length, 0]."},
                        fields(field("length", &T::length,
                                     {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "Between the two centres."}),
                               field("radius_a", &T::radius_a,
                                     {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Of the end at the local origin."}),
                               field("radius_b", &T::radius_b,
                                     {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Of the end at [length, 0]."})));
    }
};

}  // namespace pinfield::sdf

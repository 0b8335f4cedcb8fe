#pragma once
#include <tuple>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/edges.h"
#include "engine/sdf/outline.h"

namespace pinfield::sdf {

/// Polygon of equal sides and angles about the local origin, its first corner on +x.
template <class Real>
struct RegularPolygon {
    int sides = 6;
    double radius = 0.04;
    double turn_cosine = 1, turn_sine = 0;      // from one corner to the next

    static constexpr bool convex = true;
    static constexpr auto derived() {
        using T = RegularPolygon;
        return std::tuple(&T::turn_cosine, &T::turn_sine);
    }
    void derive() {
        const SineCosine turn = sine_cosine_degrees(360.0 / sides);
        turn_cosine = turn.cosine;
        turn_sine = turn.sine;
    }

    /// The whole first side, though the fold leaves half of it: its middle is then no end, about which the side would be a matter of
    /// rounding.
    Real distance(const Point<Real>& p) const {
        const Point<Real> q = folded_into_sector(p, sides, turn_cosine, turn_sine);
        return signed_distance_to_edge(q, {radius, 0}, {radius * turn_cosine, radius * turn_sine});
    }
    Vec2 corner(int i) const {
        const SineCosine t = sine_cosine_degrees(360.0 * i / sides);
        return radius * Vec2(t.cosine, t.sine);
    }
    Box2 bounds() const {
        Box2 box;
        for (int i = 0; i < sides; ++i) box = box.including(corner(i));
        return box;
    }
    void outline(Outline& out) const {
        for (int i = 0; i < sides; ++i) out.push_back(Piece::segment(corner(i), corner((i + 1) % sides)));
    }

    static constexpr auto describe() {
        using T = RegularPolygon;
        return shape<T>({.key = "regular_polygon", .doc = "Polygon of equal sides about the local origin, its first corner on +x."},
                        fields(field("sides", &T::sides, {.min = from(3), .max = to(360), .step = 1, .doc = "How many."}),
                               field("radius", &T::radius,
                                     {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the centre to a corner."})));
    }
};

}  // namespace pinfield::sdf

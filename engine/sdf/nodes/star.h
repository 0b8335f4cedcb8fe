#pragma once
#include <tuple>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/edges.h"
#include "engine/sdf/outline.h"

namespace pinfield::sdf {

/// Star about the local origin, its first tip on +x.
template <class Real>
struct Star {
    int points = 5;
    double outer = 0.05;
    double inner = 0.02;
    double turn_cosine = 1, turn_sine = 0;  // from one tip to the next
    double notch_x = 0, notch_y = 0;        // the first one

    static constexpr auto derived() {
        return std::tuple(&Star::turn_cosine, &Star::turn_sine, &Star::notch_x, &Star::notch_y);
    }
    void derive() {
        const SineCosine turn = sine_cosine_degrees(360.0 / points), half = sine_cosine_degrees(180.0 / points);
        turn_cosine = turn.cosine;
        turn_sine = turn.sine;
        notch_x = inner * half.cosine;
        notch_y = inner * half.sine;
    }

    Real distance(const Point<Real>& p) const {
        const Point<Real> q = folded_into_sector(p, points, turn_cosine, turn_sine);
        return signed_distance_to_edge(q, {outer, 0}, {notch_x, notch_y});
    }
    /// Tips at even, notches at odd places.
    Vec2 corner(int i) const {
        const SineCosine t = sine_cosine_degrees(180.0 * i / points);
        return (i % 2 == 0 ? outer : inner) * Vec2(t.cosine, t.sine);
    }
    Box2 bounds() const {
        Box2 box;
        for (int i = 0; i < 2 * points; ++i) box = box.including(corner(i));
        return box;
    }
    void outline(Outline& out) const {
        for (int i = 0; i < 2 * points; ++i) out.push_back(Piece::segment(corner(i), corner((i + 1) % (2 * points))));
    }

    static constexpr auto describe() {
        return shape<Star>({.key = "star", .doc = "Star about the local origin, its first tip on +x."},
                           fields(field("points", &Star::points, {.min = from(3), .max = to(180), .step = 1, .doc = "How many tips."}),
                                  field("outer", &Star::outer,
                                        {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the centre to a tip."}),
                                  field("inner", &Star::inner,
                                        {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the centre to a notch."})),
                           contract("inner <= outer", [](const auto& star) { return star.inner <= star.outer; }));
    }
};

}  // namespace pinfield::sdf

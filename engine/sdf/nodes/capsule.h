#pragma once
#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/edges.h"
#include "engine/sdf/outline.h"

namespace pinfield::sdf {

/// Bar along the local x axis with round ends, centred on the local origin; a disc when its length is 0.
template <class Real>
struct Capsule {
    Real length = Real(0.06);
    Real radius = Real(0.01);

    static constexpr bool convex = true;

    Real distance(const Point<Real>& p) const { return distance_to_span(p, length * Real(0.5)) - radius; }
    Box2 bounds() const { return Box2::centred(0.5 * length + radius, radius); }
    void outline(Outline& out) const {
        const Vec2 left(-0.5 * length, 0), right(0.5 * length, 0), up(0, radius);
        if (!(length > 0)) return out.push_back(Piece::circle({0, 0}, radius));
        out.push_back(Piece::segment(left - up, right - up));
        out.push_back(Piece::arc(right, radius, right - up, right + up, 1, false));
        out.push_back(Piece::segment(right + up, left + up));
        out.push_back(Piece::arc(left, radius, left + up, left - up, 1, false));
    }

    static constexpr auto describe() {
        return shape<Capsule>(
            {.key = "capsule", .doc = "Bar along the local x axis with round ends, centred on the local origin."},
            fields(field("length", &Capsule::length,
                         {.unit = Unit::metre, .min = from(0), .step = 0.001, .doc = "Between the centres of the two ends."}),
                   field("radius", &Capsule::radius,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Of the ends: half the bar's width."})));
    }
};

}  // namespace pinfield::sdf

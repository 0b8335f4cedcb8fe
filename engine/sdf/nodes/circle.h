#pragma once
#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/outline.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Disc centred on the local origin.
template <class Real>
struct Circle {
    Real radius = Real(0.05);

    static constexpr bool convex = true;

    Real distance(const Point<Real>& p) const { return norm(p) - radius; }
    Box2 bounds() const { return Box2::centred(radius, radius); }
    void outline(Outline& out) const { out.push_back(Piece::circle({0, 0}, radius)); }

    static constexpr auto describe() {
        return shape<Circle>({.key = "circle", .doc = "Disc centred on the local origin."},
                             fields(field("radius", &Circle::radius,
                                          {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the centre to the rim."})));
    }
};

}  // namespace pinfield::sdf

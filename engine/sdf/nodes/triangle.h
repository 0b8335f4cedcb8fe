#pragma once
#include <tuple>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/edges.h"
#include "engine/sdf/outline.h"

namespace pinfield::sdf {

/// Triangle with corners a, b, c in either order; with all three on a line it is that line's hull, without interior.
template <class Real>
struct Triangle {
    Point<double> a{-0.04, -0.02}, b{0.04, -0.02}, c{0, 0.04};
    double orientation = 1;

    static constexpr bool convex = true;
    static constexpr auto derived() { return std::tuple(&Triangle::orientation); }
    void derive() {
        const double xy[] = {a.x, a.y, b.x, b.y, c.x, c.y};
        orientation = doubled_area(xy, 3) < 0 ? -1.0 : 1.0;
    }

    Real distance(const Point<Real>& p) const {
        const double xy[] = {a.x, a.y, b.x, b.y, c.x, c.y};
        return distance_to_chain(p, xy, 3, orientation);
    }
    Box2 bounds() const { return Box2::of({a.x, a.y}, {b.x, b.y}).including({c.x, c.y}); }
    void outline(Outline& out) const {
        const Vec2 first(a.x, a.y), u(b.x, b.y), v(c.x, c.y);
        const Vec2 corners[] = {first, orientation > 0 ? u : v, orientation > 0 ? v : u};
        for (int i = 0; i < 3; ++i)
            if (corners[i] != corners[(i + 1) % 3]) out.push_back(Piece::segment(corners[i], corners[(i + 1) % 3]));
    }

    static constexpr auto describe() {
        return shape<Triangle>(
            {.key = "triangle", .doc = "Triangle with corners a, b, c in either order."},
            fields(field("a", &Triangle::a, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "First corner."}),
                   field("b", &Triangle::b, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Second corner."}),
                   field("c", &Triangle::c, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Third corner."})));
    }
};

}  // namespace pinfield::sdf

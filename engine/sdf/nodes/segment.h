#pragma once
#include <tuple>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/edges.h"
#include "engine/sdf/outline.h"

namespace pinfield::sdf {

/// Straight wall from a to b with round ends; a disc when a == b.
template <class Real>
struct Segment {
    Point<double> a{-0.04, 0}, b{0.04, 0};
    Real thickness = Real(0.01);
    double middle_x = 0, middle_y = 0, tx = 1, ty = 0, half_length = 0;

    static constexpr bool convex = true;
    static constexpr auto derived() {
        return std::tuple(&Segment::middle_x, &Segment::middle_y, &Segment::tx, &Segment::ty, &Segment::half_length);
    }
    void derive() {
        const Edge e = edge_between(a, b);
        middle_x = a.x + 0.5 * (b.x - a.x);
        middle_y = a.y + 0.5 * (b.y - a.y);
        tx = e.length > 0 ? e.tx : 1;
        ty = e.ty;
        half_length = 0.5 * e.length;
    }

    Real distance(const Point<Real>& p) const {
        const Point<Real> q = in_frame(Point<Real>{p.x - Real(middle_x), p.y - Real(middle_y)}, tx, ty);
        return distance_to_span(q, Real(half_length)) - thickness * Real(0.5);
    }
    Box2 bounds() const { return Box2::of({a.x, a.y}, {b.x, b.y}).grown(0.5 * thickness); }
    void outline(Outline& out) const {
        const double r = 0.5 * thickness;
        const Vec2 start(a.x, a.y), end(b.x, b.y), left(-r * ty, r * tx);
        if (!(half_length > 0)) return out.push_back(Piece::circle(start, r));
        out.push_back(Piece::segment(start - left, end - left));
        out.push_back(Piece::arc(end, r, end - left, end + left, 1, false));
        out.push_back(Piece::segment(end + left, start + left));
        out.push_back(Piece::arc(start, r, start + left, start - left, 1, false));
    }

    static constexpr auto describe() {
        return shape<Segment>(
            {.key = "segment", .doc = "Straight wall from a to b with round ends."},
            fields(
                field("a", &Segment::a, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Centre of the first end."}),
                field("b", &Segment::b,
                      {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Centre of the second end."}),
                field("thickness", &Segment::thickness,
                      {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the wall."})));
    }
};

}  // namespace pinfield::sdf

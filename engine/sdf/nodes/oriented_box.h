#pragma once
#include <tuple>

#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"
#include "engine/sdf/edges.h"
#include "engine/sdf/nodes/box.h"

namespace pinfield::sdf {

/// Straight wall from a to b with flat ends: a box laid between two points.
template <class Real>
struct OrientedBox {
    Point<double> a{-0.04, -0.02}, b{0.04, 0.02};
    Real thickness = Real(0.02);
    double middle_x = 0, middle_y = 0, tx = 1, ty = 0, length = 0;

    static constexpr bool convex = true;
    static constexpr auto derived() {
        using T = OrientedBox;
        return std::tuple(&T::middle_x, &T::middle_y, &T::tx, &T::ty, &T::length);
    }
    void derive() {
        const Edge e = edge_between(a, b);
        middle_x = a.x + 0.5 * (b.x - a.x);
        middle_y = a.y + 0.5 * (b.y - a.y);
        tx = e.tx;
        ty = e.ty;
        length = e.length;
    }

    Real distance(const Point<Real>& p) const {
        const Point<Real> q = in_frame(Point<Real>{p.x - Real(middle_x), p.y - Real(middle_y)}, tx, ty);
        return Box<Real>{{Real(length), thickness}, Real(0)}.distance(q);
    }
    void outline(Outline& out) const {
        const Vec2 start(a.x, a.y), end(b.x, b.y), left = 0.5 * thickness * Vec2(-ty, tx);
        outline_through(out, {start - left, end - left, end + left, start + left});
    }
    Box2 bounds() const {
        Outline out;
        outline(out);
        return bounds_of(out);
    }

    static constexpr auto describe() {
        using T = OrientedBox;
        return shape<T>(
            {.key = "oriented_box", .doc = "Straight wall from a to b with flat ends."},
            fields(field("a", &T::a, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Middle of the first end."}),
                   field("b", &T::b, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Middle of the second end."}),
                   field("thickness", &T::thickness,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the wall."})),
            contract("a and b are apart", [](const auto& box) { return edge_between(box.a, box.b).length > 0; }));
    }
};

}  // namespace pinfield::sdf

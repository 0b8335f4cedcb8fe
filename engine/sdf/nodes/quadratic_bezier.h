#pragma once
#include <vector>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/quadratic_curve.h"

namespace pinfield::sdf {

/// Wall with round ends along a quadratic Bezier curve. The outside is always exact; where the wall fills the bend of its curve or
/// meets its own ends, the inside is a bound.
template <class Real>
struct QuadraticBezier {
    Point<double> a{-0.06, -0.02}, b{0, 0.08}, c{0.06, -0.02};
    Real thickness = Real(0.012);

    Real distance(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        const Point<Plain> foot = nearest_on_quadratic_bezier(Point<Plain>{frozen(p.x), frozen(p.y)}, a, b, c);
        return norm(Point<Real>{p.x - Real(foot.x), p.y - Real(foot.y)}) - thickness * Real(0.5);
    }

    Vec2 point_at(double t) const {
        return Vec2(a.x + t * (2 * (b.x - a.x) + t * (a.x - 2 * b.x + c.x)), a.y + t * (2 * (b.y - a.y) + t * (a.y - 2 * b.y + c.y)));
    }
    Vec2 velocity_at(double t) const { return 2 * Vec2((1 - t) * (b.x - a.x) + t * (c.x - b.x), (1 - t) * (b.y - a.y) + t * (c.y - b.y)); }
    /// No point of the wall is nearer to two parts of the middle line than half a thickness: the bend is wide enough, and so are
    /// the gaps across which an end sees another part square on. A parabola turns by less than half a turn, so no
    /// two inner parts see each other like that; and if it turns by a quarter at most, no part sees an end.
    bool is_plain() const {
        const Vec2 start(a.x, a.y), middle(b.x, b.y), end(c.x, c.y), acceleration = 2 * (start - 2 * middle + end);
        const double bend = pinfield::dot(acceleration, acceleration), behind = -pinfield::dot(acceleration, velocity_at(0));
        const Vec2 slowest = velocity_at(behind <= 0 ? 0.0 : behind >= bend ? 1.0 : behind / bend);
        const double speed = pinfield::length(slowest);
        if (!(0.5 * thickness * std::fabs(pinfield::cross(slowest, acceleration)) < 0.95 * speed * speed * speed)) return false;
        if (pinfield::dot(velocity_at(0), velocity_at(1)) >= 0) return true;
        const double least_gap = 1.05 * thickness;
        return pinfield::length(end - start) > least_gap && leaves_end_free(0, least_gap) && leaves_end_free(1, least_gap);
    }
    /// The parts of the curve that are square to the line to its end at `from` are further away than this.
    bool leaves_end_free(double from, double least_gap) const {
        const double forth = from == 0 ? 1 : -1;
        const Vec2 v = forth * velocity_at(from), w = Vec2(a.x - 2 * b.x + c.x, a.y - 2 * b.y + c.y);
        // Half the derivative of |s v + s^2 w|^2, over s: 2 w.w s^2 + 3 v.w s + v.v.
        const double square = 2 * pinfield::dot(w, w), linear = 3 * pinfield::dot(v, w), constant = pinfield::dot(v, v);
        const double under_root = linear * linear - 4 * square * constant;
        if (!(under_root >= 0 && linear < 0)) return true;
        const double far = -linear + std::sqrt(under_root);
        for (const double s : {far / (2 * square), 2 * constant / far})
            if (s <= 1 && pinfield::length(s * v + s * s * w) < least_gap) return false;
        return true;
    }
    Exactness exactness() const { return {.inside = is_plain() ? Side::exact : Side::bound}; }

    Box2 bounds() const {
        Box2 box = Box2::of({a.x, a.y}, {c.x, c.y});
        for (int axis = 0; axis < 2; ++axis) {
            const double v = velocity_at(0)[axis], w = velocity_at(1)[axis];
            if (v * w < 0) box = box.including(point_at(v / (v - w)));
        }
        return box.grown(0.5 * thickness);
    }

    static constexpr auto describe() {
        using T = QuadraticBezier;
        return shape<T>(
            {.key = "quadratic_bezier", .float_error = 2e-6, .doc = "Wall with round ends along a quadratic Bezier curve."},
            fields(field("a", &T::a, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Where the curve starts."}),
                   field("b", &T::b,
                         {.unit = Unit::metre,
                          .step = 0.001,
                          .meaning = Meaning::place,
                          .doc = "The curve sets out towards here and arrives from here."}),
                   field("c", &T::c, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Where the curve ends."}),
                   field("thickness", &T::thickness,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the wall."})));
    }
};

}  // namespace pinfield::sdf

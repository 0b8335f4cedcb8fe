#pragma once
#include <vector>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/cubic_curve.h"
#include "engine/sdf/plain_stroke.h"

namespace pinfield::sdf {

/// Wall with round ends along a cubic Bezier curve. The outside is always exact; where the wall overlaps itself (a loop, a cusp, a bend
/// that its thickness fills), the inside is a bound.
template <class Real>
struct CubicBezier {
    Point<double> a{-0.06, -0.03}, b{-0.03, 0.09}, c{0.03, -0.09}, d{0.06, 0.03};
    Real thickness = Real(0.012);

    Real distance(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        const Point<Plain> foot = nearest_on_cubic_bezier(Point<Plain>{frozen(p.x), frozen(p.y)}, a, b, c, d);
        return norm(Point<Real>{p.x - Real(foot.x), p.y - Real(foot.y)}) - thickness * Real(0.5);
    }

    Vec2 point_at(double t) const {
        const double s = 1 - t;
        return s * s * s * Vec2(a.x, a.y) + 3 * s * s * t * Vec2(b.x, b.y) + 3 * s * t * t * Vec2(c.x, c.y) + t * t * t * Vec2(d.x, d.y);
    }
    Vec2 velocity_at(double t) const {
        const double s = 1 - t;
        return 3 * (s * s * Vec2(b.x - a.x, b.y - a.y) + 2 * s * t * Vec2(c.x - b.x, c.y - b.y) + t * t * Vec2(d.x - c.x, d.y - c.y));
    }
    CurvePoint curve_at(double t) const { return {point_at(t), velocity_at(t).normalized()}; }
    bool is_plain() const {
        const double top_speed = 3 * max(max(norm(b - a), norm(c - b)), norm(d - c));
        const auto distance_to_middle = [this](const Vec2& p) {
            const Point<double> from{p.x(), p.y()};
            return norm(from - nearest_on_cubic_bezier(from, a, b, c, d));
        };
        return is_plain_stroke([this](double t) { return curve_at(t); }, top_speed, 0.5 * thickness, distance_to_middle);
    }
    Exactness exactness() const { return {.inside = is_plain() ? Side::exact : Side::bound}; }

    Box2 bounds() const {
        Box2 box = Box2::of({a.x, a.y}, {d.x, d.y});
        const Vec2 start = velocity_at(0), end = velocity_at(1), twice_middle = 4 * velocity_at(0.5) - start - end;
        for (int axis = 0; axis < 2; ++axis) {  // where the velocity, start s^2 + twice_middle s t + end t^2 with s = 1 - t, is 0
            const double square = start[axis] - twice_middle[axis] + end[axis], linear = twice_middle[axis] - 2 * start[axis];
            const double under_root = linear * linear - 4 * square * start[axis];
            if (!(under_root >= 0)) continue;
            const double far = -0.5 * (linear + (linear < 0 ? -1 : 1) * std::sqrt(under_root));
            for (const double t : {far / square, start[axis] / far})
                if (t > 0 && t < 1) box = box.including(point_at(t));
        }
        return box.grown(0.5 * thickness);
    }

    static constexpr auto describe() {
        using T = CubicBezier;
        return shape<T>(
            {.key = "cubic_bezier", .float_error = 5e-6, .doc = "Wall with round ends along a cubic Bezier curve."},
            fields(
                field("a", &T::a, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Where the curve starts."}),
                field("b", &T::b,
                      {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "The curve sets out towards here."}),
                field("c", &T::c, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "The curve arrives from here."}),
                field("d", &T::d, {.unit = Unit::metre, .step = 0.001, .meaning = Meaning::place, .doc = "Where the curve ends."}),
                field("thickness", &T::thickness,
                      {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the wall."})));
    }
};

}  // namespace pinfield::sdf

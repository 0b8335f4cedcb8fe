#pragma once
#include <tuple>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Everything below one branch of a hyperbola that opens downwards: a wedge of the given angle whose edge is rounded off. The sides
/// approach two lines that cross in the local origin. Endless like the half plane, so it has no outline.
template <class Real>
struct Hyperbola {
    Real angle = Real(70);
    Real vertex = Real(0.02);
    /// Of half the angle; distance of the foci from the origin.
    Real cosine = Real(1), sine = Real(0), focus = Real(1);

    static constexpr bool convex = true;
    static constexpr auto derived() { return std::tuple(&Hyperbola::cosine, &Hyperbola::sine, &Hyperbola::focus); }
    void derive() {
        const SineCosine half = sine_cosine_degrees(0.5 * angle);
        cosine = half.cosine;
        sine = half.sine;
        focus = vertex / half.cosine;
    }

    /// The branch is (b tan t, -a / cos t) with half axes a = focus cosine, b = focus sine. The foot's t, 0 <= t < 90 degrees, is where
    /// sin t (1 + a y cos t) - b x cos t, in units of the focus, changes its sign; it does so once. As for the ellipse halving finds it,
    /// Newton's steps polish it, and the value is formed from the support function, so that an error of t enters only by its square.
    Real distance(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        const Plain a = frozen(cosine), b = frozen(sine), size = Plain(1) / frozen(focus);
        const Plain bx = b * (frozen(abs(p.x)) * size), ay = a * (frozen(p.y) * size);
        const auto unit = [](const Point<Plain>& v) { return v * (Plain(1) / norm(v)); };
        Point<Plain> low{Plain(1), Plain(0)}, high{Plain(0), Plain(1)};  // (cos t, sin t)
        Plain width(1.6);
        for (int step = 0; step < 16; ++step) {
            const Point<Plain> t = unit(low + high);
            const auto before = t.y * (Plain(1) + ay * t.x) - bx * t.x < Plain(0);
            low = select(before, t, low);
            high = select(before, high, t);
            width = width * Plain(0.5);
        }
        Point<Plain> t = unit(low + high);
        for (int step = 0; step < 3; ++step) {
            const Plain miss = t.y * (Plain(1) + ay * t.x) - bx * t.x;
            const Plain slope = t.x + ay * (t.x * t.x - t.y * t.y) + bx * t.y;
            const Plain turn = clamp(-miss / max(slope, Plain(1e-15)), -width, width);
            t = unit(Point<Plain>{max(t.x - turn * t.y, Plain(0)), max(t.y + turn * t.x, Plain(0))});
        }
        const Point<Plain> normal = unit({a * t.y, b});
        return abs(p.x) * Real(normal.x) + p.y * Real(normal.y) + Real(frozen(vertex) * (normal.y * t.x));
    }
    Box2 bounds() const { return {{-infinity, -infinity}, {infinity, -vertex}}; }

    static constexpr auto describe() {
        using T = Hyperbola;
        return shape<T>(
            {.key = "hyperbola", .float_error = 2e-6, .doc = "Everything below one branch of a hyperbola: a wedge with a rounded edge."},
            fields(field("angle", &T::angle,
                         {.unit = Unit::degree, .min = from(1), .max = to(179), .step = 1, .doc = "Between the lines its sides approach."}),
                   field("vertex", &T::vertex,
                         {.unit = Unit::metre,
                          .min = above(0),
                          .step = 0.001,
                          .doc = "From those lines' crossing, the local origin, down to its top."})));
    }
};

}  // namespace pinfield::sdf

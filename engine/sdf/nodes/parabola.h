#pragma once
#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/parabola_hill.h"

namespace pinfield::sdf {

/// Everything below the parabola y = -x^2 / (4 focal): a hill without end, its top on the local origin. Its complement is a
/// bowl that throws what falls into it straight down through the focus. Endless like the half plane, so it has no outline.
template <class Real>
struct Parabola {
    Real focal = Real(0.02);

    static constexpr bool convex = true;

    Real distance(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        const Point<Real> q{abs(p.x), p.y};
        const Plain radius = Plain(2) * frozen(focal);
        return distance_to_hill(q, slope_of_hill_at_foot(Point<Plain>{frozen(q.x), frozen(q.y)}, radius), radius);
    }
    static Box2 bounds() { return {{-infinity, -infinity}, {infinity, 0}}; }

    static constexpr auto describe() {
        return shape<Parabola>(
            {.key = "parabola", .float_error = 2e-6, .doc = "Everything below a parabola that opens downwards from the local origin."},
            fields(field("focal", &Parabola::focal,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From the top down to the focus."})));
    }
};

}  // namespace pinfield::sdf

#pragma once
#include <tuple>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/parabola_hill.h"

namespace pinfield::sdf {

/// Region under a parabolic arch that stands on the local x axis, middle at the origin.
template <class Real>
struct ParabolaSegment {
    Real width = Real(0.1);
    Real height = Real(0.06);
    /// Radius of curvature on the top, and slope of the sides at the foot of the arch.
    Real radius = Real(0), steepest = Real(0);

    static constexpr bool convex = true;
    static constexpr auto derived() { return std::tuple(&ParabolaSegment::radius, &ParabolaSegment::steepest); }
    void derive() {
        radius = width * width / (8 * height);
        steepest = 4 * height / width;
    }

    /// A corner is nearest beside the chord where the foot on the endless hill lies below it; elsewhere the distance is that to
    /// the hill or to the chord's line, the greater, as for every intersection of convex solids away from its corners.
    Real distance(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        const Point<Real> below_top{abs(p.x), p.y - height};
        const Point<Plain> plain{frozen(below_top.x), frozen(below_top.y)};
        const Plain m = slope_of_hill_at_foot(plain, frozen(radius));
        const Point<Real> from_corner{below_top.x - width * Real(0.5), p.y};
        const auto at_corner = both(m > frozen(steepest), from_corner.x > Real(0));
        return select(at_corner, norm(from_corner), max(distance_to_hill(below_top, m, frozen(radius)), -p.y));
    }
    Box2 bounds() const { return {{-0.5 * width, 0}, {0.5 * width, height}}; }

    static constexpr auto describe() {
        using T = ParabolaSegment;
        return shape<T>(
            {.key = "parabola_segment", .float_error = 2e-6, .doc = "Region under a parabolic arch that stands on the local x axis."},
            fields(field("width", &T::width, {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Of the arch where it stands."}),
                   field("height", &T::height, {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From there to its top."})),
            contract("neither width nor height above 400 times the other",
                     [](const auto& s) { return s.width <= 400 * s.height && s.height <= 400 * s.width; }));
    }
};

}  // namespace pinfield::sdf

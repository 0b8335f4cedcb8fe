#pragma once
#include <tuple>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/parabola_hill.h"

namespace pinfield::sdf {

/// Four rounded tips on the axes with a parabola between each two (Quilez, distfunctions2d): a cross, with a wider neck a square on its
/// corner, then a cushion, up to a quadratic circle. Exact on both sides: the rounding is never wider than the bend of a bite.
template <class Real>
struct BlobbyCross {
    Real size = Real(0.1);
    Real neck = Real(0.046);
    Real round = Real(0.006);
    /// All before rounding: a tip's distance from the centre; a parabola's top above (+: towards the centre) the chord of its two tips,
    /// the sign of that, the parabola's radius of curvature on its top and its slope at the tips.
    Real tip = Real(0), top = Real(0), side = Real(1), radius = Real(0), steepest = Real(0);

    static constexpr double half_root = 0.70710678118654752440;
    static constexpr auto derived() {
        using T = BlobbyCross;
        return std::tuple(&T::tip, &T::top, &T::side, &T::radius, &T::steepest);
    }
    /// A straight side is a parabola, too, with its centre of curvature too far away to tell.
    void derive() {
        tip = 0.5 * size - round;
        top = half_root * tip - (0.5 * neck - round);
        side = top < 0 ? -1 : 1;
        radius = tip * min(0.25 * tip / max(abs(top), 1e-300), 1e15);
        steepest = half_root * tip / radius;
    }

    /// Folded into an eighth: x along the chord from the bite's middle, y from its top away from the parabola's centre of curvature.
    Real distance(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        const Real u = abs(p.x), v = abs(p.y), above_chord = (tip - u - v) * Real(half_root);
        const Point<Real> q{abs(u - v) * Real(half_root), (above_chord - top) * side};
        const Plain m = slope_of_hill_at_foot(Point<Plain>{frozen(q.x), frozen(q.y)}, frozen(radius));
        const Point<Real> from_tip = select(u < v, Point<Real>{v - tip, u}, Point<Real>{u - tip, v});
        const Real to_tip = select(from_tip.x < Real(0), -norm(from_tip), norm(from_tip));
        return select(m > frozen(steepest), to_tip, -side * distance_to_hill(q, m, frozen(radius))) - round;
    }
    Box2 bounds() const { return Box2::centred(0.5 * size, 0.5 * size); }

    static constexpr auto describe() {
        using T = BlobbyCross;
        return shape<T>(
            {.key = "blobby_cross", .float_error = 2e-6, .doc = "Four round tips on the axes with parabolic bites between them."},
            fields(field("size", &T::size, {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From tip to tip."}),
                   field("neck", &T::neck,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Between the bottoms of opposite bites."}),
                   field("round", &T::round, {.unit = Unit::metre, .min = from(0), .step = 0.0005, .doc = "Radius of the tips."})),
            contract("5 round <= size", [](const auto& cross) { return 5 * cross.round <= cross.size; }),
            contract("neck - 2 round between 0.38 and 1.06 of size - 2 round", [](const auto& cross) {
                const auto sharp_neck = cross.neck - 2 * cross.round, sharp_size = cross.size - 2 * cross.round;
                return 0.38 * sharp_size <= sharp_neck && sharp_neck <= 1.06 * sharp_size;
            }));
    }
};

}  // namespace pinfield::sdf

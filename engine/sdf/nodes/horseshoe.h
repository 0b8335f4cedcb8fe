#pragma once
#include "engine/core/trig.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// A strip bent about the local origin, with a straight leg at either end of the bend (Quilez, "distfunctions2d"); it opens
/// towards +y. At 180 degrees it is the letter U, at less a V with a round foot.
template <class Real>
struct Horseshoe {
    static constexpr int most_pieces = 8;

    Real radius = Real(0.04);
    Real angle = Real(220);
    Real leg = Real(0.035);
    Real thickness = Real(0.014);

    Vec2 end_of_bend(double distance_from_centre) const {
        const SineCosine t = sine_cosine_degrees(0.5 * angle);
        return distance_from_centre * Vec2(t.sine, -t.cosine);
    }
    Vec2 leg_on_the_right() const {
        const SineCosine t = sine_cosine_degrees(0.5 * angle);
        return leg * Vec2(t.cosine, t.sine);
    }
    /// Between the inner corners of the two legs' ends.
    double opening() const { return 2 * (end_of_bend(radius - 0.5 * thickness) + leg_on_the_right()).x(); }

    void outline(Outline& out) const {
        const auto mirrored = [](const Vec2& p) { return Vec2(-p.x(), p.y()); };
        const Vec2 outer = end_of_bend(radius + 0.5 * thickness), inner = end_of_bend(radius - 0.5 * thickness), along = leg_on_the_right();
        const bool reflex = angle > 180;
        OutlinePen pen(out, mirrored(outer + along));
        pen.line_to(mirrored(outer));
        pen.arc_to(outer, {0, 0}, 1, reflex);
        pen.line_to(outer + along);
        pen.line_to(inner + along);
        pen.line_to(inner);
        pen.arc_to(mirrored(inner), {0, 0}, -1, reflex);
        pen.line_to(mirrored(inner + along));
        pen.close();
    }

    static constexpr auto describe() {
        return shape<Horseshoe>(
            {.key = "horseshoe", .doc = "Strip bent about the local origin with a straight leg at either end; opens towards +y."},
            fields(field("radius", &Horseshoe::radius,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001,
                          .doc = "From the local origin to the middle of the bent strip."}),
                   field("angle", &Horseshoe::angle,
                         {.unit = Unit::degree, .min = pinfield::from(1), .max = pinfield::to(359), .step = 1,
                          .doc = "By which the strip is bent: at 180 the legs are parallel, above they close in."}),
                   field("leg", &Horseshoe::leg,
                         {.unit = Unit::metre, .min = pinfield::from(0), .step = 0.001, .doc = "Length of either straight leg."}),
                   field("thickness", &Horseshoe::thickness,
                         {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the strip."})),
            contract("0.001 (radius + leg) <= thickness <= 1.9 radius",
                     [](const auto& shoe) {
                         return shoe.thickness >= 0.001 * (shoe.radius + shoe.leg) && shoe.thickness <= 1.9 * shoe.radius;
                     }),
            contract("leg = 0 or leg >= 0.001 radius", [](const auto& shoe) { return shoe.leg == 0 || shoe.leg >= 0.001 * shoe.radius; }),
            contract("the legs of a bend above 180 degrees end apart, by 0.001 (radius + leg) at least", [](const auto& shoe) {
                return shoe.angle <= 180 || shoe.opening() >= 0.001 * (shoe.radius + shoe.leg);
            }));
    }
};

}  // namespace pinfield::sdf

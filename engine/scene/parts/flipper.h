#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/reflect/describe.h"
#include "engine/scene/part_traits.h"
#include "engine/sdf/forward.h"

namespace pinfield::parts {

/// A bat on a pivot, driven by torque: a rigid body that gives and takes angular momentum, not an animation.
/// The pivot is the local origin; at angle 0 the bat lies along local +x.
struct Flipper {
    double length = 0.07;
    double radius_pivot = 0.0116;
    double radius_tip = 0.007;
    double rest = -30;
    double swing = 51;
    double mass = 0.25;
    double strength = 223450;  // 3900 rad/s^2
    double ramp = 0.03;
    double end_torque = 0.75;
    double end_angle = 6;
    double return_ratio = 0.058;
    double stop_bounce = 0.3;
    std::vector<std::string> input;

    static constexpr Role role = Role::mover;
    static constexpr std::array<std::string_view, 1> only_customary{"radius_pivot"};
    template <template <class> class Shape = sdf::UnevenCapsule>
    Shape<double> customary_shape() const { return {length, radius_pivot, radius_tip}; }

    static constexpr auto describe() {
        using F = Flipper;
        return part<F>(
            {.key = "flipper",
             .children = {0, any_number},
             .doc = "A bat on a pivot, driven by torque while one of its inputs is pressed."},
            fields(
                field("length", &F::length,
                      {.unit = Unit::metre,
                       .min = above(0),
                       .max = to(1),
                       .step = 0.001,
                       .doc = "Pivot to the centre of the tip's rounding."}),
                field("radius_pivot", &F::radius_pivot,
                      {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Of the end at the pivot."}),
                field("radius_tip", &F::radius_tip,
                      {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Of the end at the tip."}),
                field("rest", &F::rest, {.unit = Unit::degree, .step = 1, .doc = "Angle at rest, from local +x."}),
                field("swing", &F::swing,
                      {.unit = Unit::degree,
                       .min = from(-180),
                       .max = to(180),
                       .step = 1,
                       .doc = "From rest to the raised end-stop; negative swings clockwise."}),
                field("mass", &F::mass,
                      {.unit = Unit::kilogram,
                       .min = above(0),
                       .step = 0.001,
                       .doc = "Of all that turns, as a rod of the bat's length: the bat, its shaft and crank, the plunger in its coil."}),
                field("strength", &F::strength,
                      {.unit = Unit::degree_per_second2,
                       .min = above(0),
                       .max = to(1e7),
                       .step = 1000,
                       .doc = "Angular acceleration of the free bat at full torque."}),
                field("ramp", &F::ramp,
                      {.unit = Unit::second,
                       .min = from(0),
                       .step = 0.001,
                       .doc = "Time in which the torque of the up-stroke rises from zero to full."}),
                field("end_torque", &F::end_torque,
                      {.min = from(0),
                       .max = to(1),
                       .step = 0.01,
                       .doc = "Share of the torque left at the end of the stroke, which then holds the bat up."}),
                field("end_angle", &F::end_angle,
                      {.unit = Unit::degree, .min = from(0), .step = 0.5, .doc = "Length of that end of the stroke."}),
                field("return_ratio", &F::return_ratio,
                      {.min = from(0), .max = to(1), .step = 0.001, .doc = "Torque of the return spring as a share of the full torque."}),
                field("stop_bounce", &F::stop_bounce,
                      {.min = from(0), .max = to(1), .step = 0.01, .doc = "Coefficient of restitution of the end-stops."}),
                field("input", &F::input, {.meaning = Meaning::input, .doc = "Inputs that raise it."})));
    }
};

}  // namespace pinfield::parts

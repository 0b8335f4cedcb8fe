#pragma once
#include <array>
#include <string_view>

#include "engine/reflect/describe.h"
#include "engine/scene/part_traits.h"
#include "engine/sdf/forward.h"

namespace pinfield::parts {

/// A round post that kicks a ball away.
struct Bumper {
    double radius = 0.024;
    double kick = 0.81;
    double threshold = 0.05;

    static constexpr Role role = Role::solid;
    static constexpr std::array<std::string_view, 1> only_customary{"radius"};
    template <template <class> class Shape = sdf::Circle>
    Shape<double> customary_shape() const { return {radius}; }

    static constexpr auto describe() {
        return part<Bumper>(
            {.key = "bumper", .children = {0, any_number}, .doc = "A post that kicks the ball away when it is hit."},
            fields(
                field("radius", &Bumper::radius,
                      {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Of the customary disc; children replace it."}),
                field(
                    "kick", &Bumper::kick,
                    {.unit = Unit::metre_per_second, .min = from(0), .max = to(20), .step = 0.05, .doc = "Speed added along the normal."}),
                field("threshold", &Bumper::threshold,
                      {.unit = Unit::metre_per_second, .min = from(0), .step = 0.01, .doc = "Slowest impact that makes it kick."})));
    }
};

}  // namespace pinfield::parts

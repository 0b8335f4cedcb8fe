#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/reflect/describe.h"
#include "engine/scene/part_traits.h"
#include "engine/sdf/forward.h"

namespace pinfield::parts {

/// A spring-loaded rod along local +y. Its tip rests on the local origin; holding the input draws it back, letting go shoots it.
struct Plunger {
    Point<double> size{0.02, 0.06};
    double stroke = 0.04;
    double speed = 3.5;
    double pull_time = 0.6;
    std::vector<std::string> input;

    static constexpr Role role = Role::mover;
    static constexpr bool slides = true;
    static constexpr std::array<std::string_view, 1> only_customary{"size"};
    template <template <class> class Shape = sdf::Box>
    Shape<double> customary_shape() const { return {size, 0.0}; }
    Similarity part_from_shape() const { return Similarity::translation({0, -0.5 * size.y}); }

    static constexpr auto describe() {
        using P = Plunger;
        return part<P>(
            {.key = "plunger", .children = {0, any_number}, .doc = "A rod along local +y that shoots the ball resting on its tip."},
            fields(
                field("size", &P::size,
                      {.unit = Unit::metre,
                       .min = above(0),
                       .step = 0.001,
                       .doc = "Width and length of the customary rod; its tip is at the local origin."}),
                field("stroke", &P::stroke,
                      {.unit = Unit::metre, .min = above(0), .max = to(1), .step = 0.001, .doc = "How far it can be drawn back."}),
                field("speed", &P::speed,
                      {.unit = Unit::metre_per_second,
                       .min = above(0),
                       .max = to(20),
                       .step = 0.1,
                       .doc = "Of the rod, not of the ball, when it was drawn back fully; proportionally less before."}),
                field("pull_time", &P::pull_time, {.unit = Unit::second, .min = above(0), .step = 0.05, .doc = "To draw it back fully."}),
                field("input", &P::input, {.meaning = Meaning::input, .doc = "Inputs that draw it back."})));
    }
};

}  // namespace pinfield::parts

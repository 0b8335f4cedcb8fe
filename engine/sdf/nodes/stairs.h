#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/corners.h"

namespace pinfield::sdf {

/// Flight of steps up to the right, solid down to the ground; the local origin is its lower left corner.
template <class Real>
struct Stairs {
    static constexpr int most_steps = 32;
    static constexpr int most_pieces = 2 * most_steps + 2;

    Point<Real> step{Real(0.025), Real(0.015)};
    int count = 4;

    void outline(Outline& out) const { outline_stairs(out, {0, 0}, {step.x, step.y}, count); }

    static constexpr auto describe() {
        return shape<Stairs>(
            {.key = "stairs", .doc = "Steps up to the right from the local origin, solid down to the ground."},
            fields(field("step", &Stairs::step,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Width and height of one step."}),
                   field("count", &Stairs::count,
                         {.min = from(1), .max = to(most_steps), .step = 1, .doc = "How many steps."})),
            contract("the whole is at most 1000 times as wide as a step is high, and the other way round",
                     [](const auto& stairs) {
                         return stairs.count * stairs.step.x <= 1000 * stairs.step.y &&
                                stairs.count * stairs.step.y <= 1000 * stairs.step.x;
                     }));
    }
};

}  // namespace pinfield::sdf

#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/nodes/stairs.h"

namespace pinfield::sdf {

/// Square centred on the local origin, its upper left half cut away in equal square steps.
template <class Real>
struct SquareStairs {
    static constexpr int most_pieces = Stairs<Real>::most_pieces;

    Real size = Real(0.08);
    int count = 4;

    void outline(Outline& out) const {
        const double half = 0.5 * size, step = size / count;
        outline_stairs(out, {-half, -half}, {step, step}, count);
    }

    static constexpr auto describe() {
        using T = SquareStairs;
        return shape<T>(
            {.key = "square_stairs",
             .doc = "Square centred on the local origin, its upper left cut away in square steps."},
            fields(
                field("size", &T::size,
                      {.unit = Unit::metre,
                       .min = above(0),
                       .step = 0.001,
                       .doc = "Full width and height of the whole."}),
                field("count", &T::count,
                      {.min = from(1), .max = to(Stairs<double>::most_steps), .step = 1, .doc = "How many steps."})));
    }
};

}  // namespace pinfield::sdf

// Root finding on a bracket, for every scalar.
#pragma once
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Where a function that is monotone from low to high changes its sign; high when it does not. Halving finds the place, Newton's steps
/// polish it.
template <class R, class Value, class Slope>
R sign_change(R low, R high, int halvings, int newton_steps, const Value& value_at, const Slope& slope_at) {
    const auto starts_below = value_at(low) < R(0);
    for (int step = 0; step < halvings; ++step) {
        const R middle = R(0.5) * (low + high);
        const auto beyond = exactly_one(value_at(middle) < R(0), starts_below);
        high = select(beyond, middle, high);
        low = select(beyond, low, middle);
    }
    R root = high;
    for (int step = 0; step < newton_steps; ++step) {
        const R slope = slope_at(root);
        root = clamp(root - value_at(root) / select(abs(slope) > R(1e-30), slope, R(1e-30)), low, high);
    }
    return root;
}

}  // namespace pinfield::sdf

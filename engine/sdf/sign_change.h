// Root finding on a bracket, for every scalar.
#pragma once
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Where a function that is monotone from low to high changes its sign: from below 0 where `starts_below`. Halving finds the place,
/// Newton's steps polish it. At the end that is nearer to 0 when it changes nowhere.
template <class R, class Mask, class Value, class Slope>
R sign_change(R low, R high, const Mask& starts_below, int halvings, int newton_steps, const Value& value_at, const Slope& slope_at) {
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

/// The same by the function's own sign at low; high when it changes nowhere.
template <class R, class Value, class Slope>
R sign_change(R low, R high, int halvings, int newton_steps, const Value& value_at, const Slope& slope_at) {
    return sign_change(low, high, value_at(low) < R(0), halvings, newton_steps, value_at, slope_at);
}

}  // namespace pinfield::sdf

// Smooth minima: min(a, b) less a bump where the two fields are close (Quilez, "smooth minimum", iquilezles.org/articles/smin).
#pragma once
#include <array>
#include <string_view>

#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// The bump's profile. One meaning of k for all: smooth_min(a, a) == a - k.
enum class BlendFamily : unsigned char { quadratic };
constexpr std::array<std::string_view, 1> choice_names(BlendFamily) { return {"quadratic"}; }

/// min(a, b) - k <= result <= min(a, b), equal to min(a, b) where |a - b| >= 4 k. Its partial derivatives are weights: both >= 0
/// with sum 1, so that it changes no faster than its operands. b - a in this order: at a tie the derivative of the bump
/// must go with the operand that min() picks.
template <class Real>
Real smooth_min(const Real& a, const Real& b, const Real& k, BlendFamily) {
    const Real support = k * Real(4);
    const Real closeness = max(support - abs(b - a), Real(0)) / max(support, Real(1e-30));
    return min(a, b) - k * closeness * closeness;
}

}  // namespace pinfield::sdf

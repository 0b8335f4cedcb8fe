// Smooth minima: min(a, b) less a bump where the two fields are close (Quilez, "smooth minimum", iquilezles.org/articles/smin).
#pragma once
#include <array>
#include <string_view>

#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// The bump's profile. One meaning of k for all: smooth_min(a, a) == a - k. `chamfer` is a straight bevel, `stairs` a flight of them. All
/// but `exponential`, which alone does not depend on the order of the children, end at a finite distance from where the fields are equal.
enum class BlendFamily : unsigned char { quadratic, cubic, quartic, circular, exponential, chamfer, stairs };
constexpr std::array<std::string_view, 7> choice_names(BlendFamily) {
    return {"quadratic", "cubic", "quartic", "circular", "exponential", "chamfer", "stairs"};
}
inline constexpr int usual_steps = 4;  ///< of a flight of stairs

/// log2(1 + 2^-t) for t >= 0 by sums, products and quotients alone, so that every scalar and instruction set agrees. Whole powers of two
/// are taken out of 2^-t before its Taylor series, and log(1 + w) = 2 artanh(w / (2 + w)), whose series ends quickly for w <= 1.
template <class Real>
Real log2_of_one_plus_exp2(const Real& t) {
    constexpr double ln_2 = 0.69314718055994530942;
    Real rest = min(t, Real(63)), whole(1);
    for (int bit = 32; bit > 0; bit /= 2) {
        const auto has = rest >= Real(bit);
        whole = select(has, whole * Real(1.0 / static_cast<double>(1ull << bit)), whole);
        rest = select(has, rest - Real(bit), rest);
    }
    const Real u = rest * Real(-ln_2);
    Real w(1);
    for (int n = 17; n > 0; --n) w = Real(1) + w * u * Real(1.0 / n);
    w = whole * w;
    const Real z = w / (Real(2) + w), zz = z * z;
    Real sum(1.0 / 33);
    for (int n = 31; n > 0; n -= 2) sum = Real(1.0 / n) + sum * zz;
    return Real(2 / ln_2) * z * sum;
}

/// The bump that builds `steps` stairs between two walls. Step i of n is the corner a <= i s, b <= (n + 1 - i) s, and the stairs are the
/// union of these with the walls: min(a, b, max(a - i s, b - (n + 1 - i) s) for every i). With a <= b that is a less the greatest
/// min(i s, (n + 1 - i) s - (b - a)), which, from where the stairs end inwards, rises by s over every other s.
template <class Real>
Real stairs_bump(const Real& difference, const Real& k, int steps) {
    const int steps_to_middle = (steps + 1) / 2;
    const Real s = k * Real(1.0 / steps_to_middle);  // so that the step in the middle is k high
    const Real inwards = max(s * Real(steps) - difference, Real(0));
    const Real whole = floor(inwards / max(s + s, Real(1e-30)));
    return s * whole + min(inwards - whole * (s + s), s);
}

/// How far the bump lowers the minimum of two fields that differ by `difference` >= 0; k where it is 0. `closeness` falls from 1 to 0 over
/// the bump's width, which is such that the slope of the bump is at most 1/2; that of stairs is 0 or 1. `steps` is theirs alone.
template <class Real>
Real bump(const Real& difference, const Real& k, BlendFamily family, int steps = usual_steps) {
    const auto closeness = [&](double widths) {
        const Real support = k * Real(widths);
        return max(support - difference, Real(0)) / max(support, Real(1e-30));
    };
    switch (family) {
        case BlendFamily::quadratic: {
            const Real h = closeness(4);
            return k * h * h;
        }
        case BlendFamily::cubic: {
            const Real h = closeness(6);
            return k * h * h * h;
        }
        case BlendFamily::quartic: {
            const Real h = closeness(16.0 / 3);
            return k * h * h * h * (Real(4) - h) * Real(1.0 / 3);
        }
        case BlendFamily::circular: {  // a quarter of a circle that touches both outlines, seen in the plane of (a, b)
            constexpr double width = 3.41421356237309504880;  // 1 / (1 - sqrt(1/2))
            const Real h = closeness(width);
            return k * Real(0.5 * width) * (Real(1) + h - sqrt(Real(1) + h * (Real(2) - h)));
        }
        case BlendFamily::exponential: return k * log2_of_one_plus_exp2(difference / max(k, Real(1e-30)));
        case BlendFamily::chamfer: return k * closeness(2);
        case BlendFamily::stairs: return stairs_bump(difference, k, steps);
    }
    return Real(0);
}

/// min(a, b) - k <= result <= min(a, b). Its partial derivatives are weights: both >= 0 with sum 1, so that it changes no faster than its
/// operands. b - a in this order: at a tie the derivative of the bump must go with the operand that min() picks.
template <class Real>
Real smooth_min(const Real& a, const Real& b, const Real& k, BlendFamily family, int steps = usual_steps) {
    return min(a, b) - bump(abs(b - a), k, family, steps);
}

}  // namespace pinfield::sdf

// Sine and cosine for distance formulas: by + - * and floor alone, over any scalar, so that every instruction set agrees.
#pragma once
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Sine of an angle in full turns; for doubles right to about 3e-16. Folded into a quarter of a turn, where the Taylor series of
/// the sine has lost nothing after eleven terms.
template <class Real>
Real sine_of_turns(const Real& turns) {
    const Real r = turns - floor(turns + Real(0.5));
    const Real quarter = select(abs(r) > Real(0.25), sign(r) * Real(0.5) - r, r);
    const Real x = quarter * Real(6.28318530717958647693), xx = x * x;
    Real sum(1);
    for (int n = 20; n > 0; n -= 2) sum = Real(1) - sum * xx * Real(1.0 / (n * (n + 1)));
    return x * sum;
}

/// Cosine of an angle in full turns; for doubles right to about 7e-16. Folded first: a quarter added to many turns would lose digits.
template <class Real>
Real cosine_of_turns(const Real& turns) { return sine_of_turns(turns - floor(turns + Real(0.5)) + Real(0.25)); }

/// Largest singular value of a shear by `s`, the matrix (1 s; 0 1): how much a warp that shears stretches lengths at most.
inline double stretch_of_shear(double s) { return 0.5 * (abs(s) + sqrt(s * s + 4)); }

}  // namespace pinfield::sdf

#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/operations/fold.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// A figure on the way from the first child to the second: the weighted mean of their fields, a bound on both sides.
template <class Real>
struct Lerp {
    Real t = Real(0.5);

    Real combine(const Real& a, const Real& b) const { return a + t * (b - a); }
    static Real hard(const Real& a, const Real& b) { return min(a, b); }
    /// Never below the least of both, but as far above it as they differ.
    static Slack slack() { return {.above = infinity}; }

    static Exactness exactness(std::span<const Exactness> children) { return bound_of(children); }
    static Box2 bounds(std::span<const Box2> children) { return union_of(children); }

    static constexpr auto describe() {
        return operation<Lerp>(
            {.key = "lerp",
             .exactness = {Side::bound, Side::bound},
             .children = {2, 2},
             .doc = "A figure on the way from the first child to the second."},
            fields(field("t", &Lerp::t, {.min = from(0), .max = to(1), .step = 0.01, .doc = "0 gives the first child, 1 the second."})));
    }
};

}  // namespace pinfield::sdf

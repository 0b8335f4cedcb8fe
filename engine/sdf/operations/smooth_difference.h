#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/blend.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/operations/fold.h"

namespace pinfield::sdf {

/// The first child minus the rest, the rims of the cuts rounded off; folded in file order.
template <class Real>
struct SmoothDifference {
    Real k = Real(0.005);
    BlendFamily family = BlendFamily::quadratic;
    int steps = usual_steps;

    Real combine(const Real& a, const Real& b) const { return -smooth_min(-a, b, k, family, steps); }
    static Real hard(const Real& a, const Real& b) { return max(a, -b); }
    Slack slack() const { return {.above = k}; }

    static Exactness exactness(std::span<const Exactness> children) { return bound_of(children); }
    static Box2 bounds(std::span<const Box2> children) { return children[0]; }

    static constexpr auto describe() {
        using T = SmoothDifference;
        return operation<T>({.key = "smooth_difference",
                             .exactness = {.outside = Side::bound, .inside = Side::bound},
                             .children = {1, any_number},
                             .doc = "The first child minus the rest with softened rims, folded in file order."},
                            fields(field("k", &T::k,
                                         {.unit = Unit::metre, .min = from(0), .step = 0.0005,
                                          .doc = "How much more is cut away where two outlines coincide."}),
                                   field("family", &T::family, {.doc = "Profile of the rim."}),
                                   field("steps", &T::steps,
                                         {.min = from(1), .max = to(64), .step = 1, .only_with = {"family", "stairs"},
                                          .doc = "How many stairs."})));
    }
};

}  // namespace pinfield::sdf

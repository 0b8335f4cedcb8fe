#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/blend.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/operations/fold.h"

namespace pinfield::sdf {

/// The union of the children, the corners between them filled smoothly; folded in file order.
template <class Real>
struct SmoothUnion {
    Real k = Real(0.005);
    BlendFamily family = BlendFamily::quadratic;
    int steps = usual_steps;

    Real combine(const Real& a, const Real& b) const { return smooth_min(a, b, k, family, steps); }
    static Real hard(const Real& a, const Real& b) { return min(a, b); }
    Slack slack() const { return {.below = k}; }

    static Exactness exactness(std::span<const Exactness> children) { return bound_of(children); }
    /// Each fold lowers the field by at most k, so that the solid lies where some child is below k times the number of folds.
    Box2 bounds(std::span<const Box2> children) const { return union_of(children).grown(reach(static_cast<int>(children.size()))); }
    double reach(int children) const { return k * (children - 1); }

    static constexpr auto describe() {
        using T = SmoothUnion;
        return operation<T>({.key = "smooth_union",
                             .exactness = {.outside = Side::bound, .inside = Side::bound},
                             .children = {1, any_number},
                             .doc = "The union of the children with filled joints, folded in file order."},
                            fields(field("k", &T::k,
                                         {.unit = Unit::metre, .min = from(0), .step = 0.0005,
                                          .doc = "How much the filling adds where two outlines coincide."}),
                                   field("family", &T::family, {.doc = "Profile of the filling."}),
                                   field("steps", &T::steps,
                                         {.min = from(1), .max = to(64), .step = 1, .only_with = {"family", "stairs"},
                                          .doc = "How many stairs."})));
    }
};

}  // namespace pinfield::sdf

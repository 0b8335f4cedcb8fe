#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// A shell along the child's outline, half of it on either side. Its outside is both what is beyond the shell and what is within.
template <class Real>
struct Onion {
    Real thickness = Real(0.006);

    Real modify(const Real& d) const { return abs(d) - thickness * Real(0.5); }
    Affine affine() const { return {.offset = -0.5 * thickness, .absolute = true}; }

    static Exactness exactness(std::span<const Exactness> children) {
        const Exactness& child = children[0];
        const bool exact = child.outside == Side::exact && child.inside == Side::exact;
        return {exact ? Side::exact : Side::bound, Side::bound, child.lipschitz};
    }
    Box2 bounds(std::span<const Box2> children) const { return children[0].grown(0.5 * thickness); }
    double reach(int) const { return 0.5 * thickness; }

    static constexpr auto describe() {
        return operation<Onion>({.key = "onion",
                                 .exactness = {.inside = Side::bound},
                                 .children = {1, 1},
                                 .doc = "A shell along the child's outline."},
                                fields(field("thickness", &Onion::thickness,
                                             {.unit = Unit::metre, .min = above(0), .step = 0.0005, .doc = "Full width of the shell."})));
    }
};

}  // namespace pinfield::sdf

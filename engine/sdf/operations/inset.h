#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// The child shrunk by a distance. Where the child's inside is only a bound, an isoline of that bound is what it shrinks to.
/// Outside, the corners it keeps sharp make it a bound.
template <class Real>
struct Inset {
    Real distance = Real(0.005);

    Real modify(const Real& d) const { return d + distance; }
    Affine affine() const { return {.offset = distance}; }

    Exactness exactness(std::span<const Exactness> children) const {
        Exactness out = children[0];
        if (distance > 0) out.outside = Side::bound;
        return out;
    }
    /// A child whose inside is a bound may be deeper than its field says, never shallower: it reaches no nearer to its box than this.
    Box2 bounds(std::span<const Box2> children) const { return children[0]; }

    static constexpr auto describe() {
        return operation<Inset>({.key = "inset",
                                 .exactness = {.outside = Side::bound},
                                 .children = {1, 1},
                                 .doc = "The child shrunk by a distance."},
                                fields(field("distance", &Inset::distance,
                                             {.unit = Unit::metre, .min = from(0), .step = 0.0005, .doc = "How far it shrinks."})));
    }
};

}  // namespace pinfield::sdf

#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// The child grown by a distance, which rounds its corners. Where the child's outside is only a bound, an isoline of that bound
/// is what it grows to. Inside, concave corners of the child make it a bound.
template <class Real>
struct Round {
    Real radius = Real(0.005);

    Real modify(const Real& d) const { return d - radius; }
    Affine affine() const { return {.offset = -radius}; }

    Exactness exactness(std::span<const Exactness> children) const {
        Exactness out = children[0];
        if (radius > 0) out.inside = Side::bound;
        return out;
    }
    Box2 bounds(std::span<const Box2> children) const { return children[0].grown(radius); }
    double reach(int) const { return radius; }

    static constexpr auto describe() {
        return operation<Round>({.key = "round",
                                 .exactness = {.inside = Side::bound},
                                 .children = {1, 1},
                                 .doc = "The child grown by a distance, which rounds its corners."},
                                fields(field("radius", &Round::radius,
                                             {.unit = Unit::metre, .min = from(0), .step = 0.0005, .doc = "How far it grows."})));
    }
};

}  // namespace pinfield::sdf

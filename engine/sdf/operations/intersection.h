#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/operations/fold.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// The points that are in every child. Exact inside; outside, near corners that the cut made, only a bound.
template <class Real>
struct Intersection {
    static Real combine(const Real& a, const Real& b) { return max(a, b); }

    static Exactness exactness(std::span<const Exactness> children) {
        Exactness out = children[0];
        for (const Exactness& child : children.subspan(1)) {
            if (child.inside == Side::bound) out.inside = Side::bound;
            out.outside = Side::bound;
            out.lipschitz = max(out.lipschitz, child.lipschitz);
        }
        return out;
    }
    static Box2 bounds(std::span<const Box2> children) { return intersection_of(children); }

    static constexpr auto describe() {
        return operation<Intersection>({.key = "intersection",
                                        .exactness = {.outside = Side::bound},
                                        .children = {1, any_number},
                                        .doc = "The points that are in every child."},
                                       fields());
    }
};

}  // namespace pinfield::sdf

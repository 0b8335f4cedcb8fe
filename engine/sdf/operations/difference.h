#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// The first child minus the rest: what an intersection with their complements is, and as exact as that.
template <class Real>
struct Difference {
    static Real combine(const Real& a, const Real& b) { return max(a, -b); }

    static Exactness exactness(std::span<const Exactness> children) {
        Exactness out = children[0];
        for (const Exactness& child : children.subspan(1)) {
            if (child.outside == Side::bound) out.inside = Side::bound;
            out.outside = Side::bound;
            out.lipschitz = max(out.lipschitz, child.lipschitz);
        }
        return out;
    }
    static Box2 bounds(std::span<const Box2> children) { return children[0]; }

    static constexpr auto describe() {
        return operation<Difference>({.key = "difference",
                                      .exactness = {.outside = Side::bound},
                                      .children = {1, any_number},
                                      .doc = "The first child minus the rest."},
                                     fields());
    }
};

}  // namespace pinfield::sdf

#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/operations/fold.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// All points that are in any child. Exact outside; inside, where children overlap, only a bound.
template <class Real>
struct Union {
    static Real combine(const Real& a, const Real& b) { return min(a, b); }

    static Exactness exactness(std::span<const Exactness> children) {
        Exactness out = children[0];
        for (const Exactness& child : children.subspan(1)) {
            if (child.outside == Side::bound) out.outside = Side::bound;
            out.inside = Side::bound;
            out.lipschitz = max(out.lipschitz, child.lipschitz);
        }
        return out;
    }
    static Box2 bounds(std::span<const Box2> children) { return union_of(children); }

    static constexpr auto describe() {
        return operation<Union>({.key = "union",
                                 .exactness = {.inside = Side::bound},
                                 .children = {1, any_number},
                                 .doc = "All points that are in any child."},
                                fields());
    }
};

}  // namespace pinfield::sdf

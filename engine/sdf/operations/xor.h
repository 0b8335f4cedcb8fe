#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/operations/fold.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// The points that are in an odd number of children. Its distance is the least of the children's, so it is exact on both sides
/// where outlines only cross. Where two run along each other the field has a seam of zeros that is no outline; whether they do
/// does not follow from the children's exactness, so what is promised for more than one child is a bound.
template <class Real>
struct Xor {
    static Real combine(const Real& a, const Real& b) { return max(min(a, b), -max(a, b)); }

    static Exactness exactness(std::span<const Exactness> children) { return bound_of(children); }
    static Box2 bounds(std::span<const Box2> children) { return union_of(children); }

    static constexpr auto describe() {
        return operation<Xor>({.key = "xor",
                               .exactness = {.outside = Side::bound, .inside = Side::bound},
                               .children = {1, any_number},
                               .doc = "The points that are in an odd number of children."},
                              fields());
    }
};

}  // namespace pinfield::sdf

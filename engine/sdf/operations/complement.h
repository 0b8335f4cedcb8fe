#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Everything the child is not: a room is the complement of its air.
template <class Real>
struct Complement {
    static Real modify(const Real& d) { return -d; }
    static Affine affine() { return {.sign = -1}; }

    static Exactness exactness(std::span<const Exactness> children) {
        return {children[0].inside, children[0].outside, children[0].lipschitz};
    }
    static Box2 bounds(std::span<const Box2>) { return Box2::everything(); }

    static constexpr auto describe() {
        return operation<Complement>({.key = "complement", .children = {1, 1}, .doc = "Everything the child is not."}, fields());
    }
};

}  // namespace pinfield::sdf

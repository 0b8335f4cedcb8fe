// What many operations over several children share.
#pragma once
#include <span>

#include "engine/core/geometry.h"
#include "engine/reflect/exactness.h"

namespace pinfield::sdf {

inline Box2 union_of(std::span<const Box2> boxes) {
    Box2 out;
    for (const Box2& box : boxes) out = out.merged(box);
    return out;
}
inline Box2 intersection_of(std::span<const Box2> boxes) {
    Box2 out = Box2::everything();
    for (const Box2& box : boxes) out = out.intersected(box);
    return out;
}

/// Of a fold that keeps no side exact, however exact its children are: a bound, except of one child alone, which it returns as it is.
inline Exactness bound_of(std::span<const Exactness> children) {
    Exactness out = children[0];
    for (const Exactness& child : children.subspan(1))
        out = {Side::bound, Side::bound, child.lipschitz > out.lipschitz ? child.lipschitz : out.lipschitz};
    return out;
}

}  // namespace pinfield::sdf

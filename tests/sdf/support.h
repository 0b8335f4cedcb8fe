// What the tests of this folder share.
#pragma once
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/rng.h"
#include "engine/sdf/dual.h"
#include "engine/sdf/kernels.h"

namespace pinfield::sdf {

/// A node with its derived values filled in.
template <class T>
T ready(T node) {
    if constexpr (requires { node.derive(); }) node.derive();
    return node;
}

/// Points all over a square about the origin, and on its axes and diagonals.
inline std::vector<Vec2> points_within(double half, int count = 400) {
    std::vector<Vec2> out{{0, 0}};
    CounterRng rng(3);
    for (int i = 0; i < count; ++i) {
        const double x = rng.in(-half, half), y = rng.in(-half, half);
        out.emplace_back(x, y);
        if (i % 10 == 0)
            for (const Vec2& p : {Vec2(x, 0), Vec2(0, x), Vec2(x, x), Vec2(x, -x)}) out.push_back(p);
    }
    return out;
}

}  // namespace pinfield::sdf

// How much of a tree's surface is whose: a check of which leaf the tree names.
#pragma once
#include <vector>

#include "engine/program/program.h"

namespace pinfield::test {

/// How much of an op's surface is a leaf's: how much the value moves with the leaf's own.
struct BlendWeight {
    int leaf = 0;       ///< op
    double weight = 0;  ///< > 0
};
/// All leaves that the tree's value at p depends on, in the tree's order; their weights add up to 1. Hard operations hand all of it to the
/// winner, smooth ones divide it by their partial derivatives, multiplied along the way down (the chain rule).
std::vector<BlendWeight> blend_weights(const Field& field, int op, const Vec2& p);

}  // namespace pinfield::test

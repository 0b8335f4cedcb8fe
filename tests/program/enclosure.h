// What an op's tree can be over a box: a witness of what pruning by Lipschitz constants claims, that knows nothing of the constants.
#pragma once
#include "engine/program/program.h"
#include "engine/sdf/interval.h"

namespace pinfield::test {

/// Holds tree_value(field, op, p) for every p of the box, in the Field's frame: the natural interval extension of the tree's formula. By
/// the formulas alone, so it holds whatever the nodes claim, and may be wide; it narrows with the box.
sdf::Interval natural_enclosure(const Field& field, int op, const Box2& box);

}  // namespace pinfield::test

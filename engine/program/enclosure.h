// What an op's tree can be over a box: for pruning, and as an independent check of what nodes claim.
#pragma once
#include "engine/program/program.h"

namespace pinfield {

/// Holds tree_value(field, op, p) for every p of the box, in the Field's frame; rotated frames are enclosed on the way. By the formulas
/// alone, so it holds whatever the nodes claim, and may be wide: see interval.h.
sdf::Interval natural_enclosure(const Field& field, int op, const Box2& box);

/// The same, but no wider than the value at the centre give or take the Lipschitz constant times half the diagonal, and rounding. Where
/// the two contradict each other the claim is false, and the formula is believed.
sdf::Interval tree_enclosure(const Field& field, int op, const Box2& box);

}  // namespace pinfield

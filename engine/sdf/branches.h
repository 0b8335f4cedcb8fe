// Whether the branches of `a if c else b` meet where one gives way to the other.
#pragma once
#include "engine/expression/expression.h"

namespace pinfield::sdf {

/// Are both branches of the choice, a node of the expression, surely the same wherever the two sides of its comparison are? Shown by putting one
/// side in the other's place in both: what is then written alike, but for sums with 0 and the like, is the same. Of other conditions
/// than a single comparison, and of very long expressions, nothing is known.
bool branches_meet(const Expression& expression, int choice);

}  // namespace pinfield::sdf

// Value of an op's tree without its gradient: enough for a sign, and a third of the cost.
#pragma once
#include "engine/program/program.h"

namespace pinfield {

/// As evaluate_tree(field, op, p).value, bit for bit in sign.
double tree_value(const Field& field, int op, const Vec2& p);

}  // namespace pinfield

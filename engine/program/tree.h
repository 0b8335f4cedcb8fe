// Value of an op's tree without its gradient: enough for a sign, and a third of the cost.
#pragma once
#include "engine/program/program.h"

namespace pinfield {

/// As evaluate_tree(field, op, p).value, bit for bit in sign.
double tree_value(const Field& field, int op, const Vec2& p);

/// The direction that `m` maps to d.
inline Vec2 direction_before(const Similarity& m, const Vec2& d) {
    const double x = m.cosine * d.x() + m.sine * d.y(), y = m.cosine * d.y() - m.sine * d.x();
    return {x, m.mirrored ? -y : y};
}

}  // namespace pinfield

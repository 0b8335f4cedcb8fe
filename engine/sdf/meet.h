// Where two outline pieces meet.
#pragma once
#include <vector>

#include "engine/sdf/outline.h"

namespace pinfield::sdf {

/// Appends to `cuts_of_a` the points at which piece a must be cut for b's sake, and the other way round: crossings,
/// touching points, and the ends of either that lie on the other, which covers pieces that run along each other. Closer
/// than `tolerance` (metres) counts as touching; a point that close to an end of a piece does not cut it.
void meet(const Piece& a, const Piece& b, double tolerance, std::vector<Vec2>& cuts_of_a,
          std::vector<Vec2>& cuts_of_b);

}  // namespace pinfield::sdf

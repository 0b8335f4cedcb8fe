// The boundary of a line-and-arc solid as oriented pieces: for exact distances, times of impact and tests.
#pragma once
#include <vector>

#include "engine/sdf/piece.h"

namespace pinfield::sdf {

using Outline = std::vector<Piece>;

}  // namespace pinfield::sdf

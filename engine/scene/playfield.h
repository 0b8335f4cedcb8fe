// A generated playfield for benchmarks and soak tests: the same scene from the same seed, everywhere.
#pragma once
#include <cstdint>
#include <memory>

#include "engine/scene/scene.h"

namespace pinfield {

/// 40 % discs, 30 % capsules, 20 % turned boxes and 10 % convex polygons, 2 mm apart at least, a few to 28 mm across, in a
/// domain of 0.5 m x 1 m for 200 obstacles (the area grows with their number). Slope 6.5 degrees, every contact elastic.
Scene playfield(std::shared_ptr<const Catalog> catalog, int obstacles, std::uint64_t seed = 12345);

}  // namespace pinfield

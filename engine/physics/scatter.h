// Balls at random over the free part of a table: for soak tests, benchmarks and `simulate --balls`.
#pragma once
#include "engine/physics/world.h"

namespace pinfield {

/// Adds n balls of this speed in random directions at random places whose gap to everything solid, movers where they stand
/// included, is at least 1 mm. Where there is no room for all of them they overlap each other. Returns how many found a place.
int scatter_balls(World& world, int n, double speed, std::uint64_t seed);

}  // namespace pinfield

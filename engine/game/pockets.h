// Where slow balls come to rest: pockets between solids, from which nothing plays them.
#pragma once
#include <vector>

#include "engine/core/diagnostic.h"
#include "engine/program/program.h"
#include "engine/scene/scene.h"

namespace pinfield {

struct Pocket {
    Vec2 place{0, 0};            ///< of the ball's centre
    std::vector<NodeId> nodes;   ///< what it lies on or between
};

/// Local minima of height in the space that a ball's centre can reach from the table's spawns (from anywhere, where there are none), on the
/// ground: found by rolling balls downhill, without friction and without speed, from wherever a grid of a third of their radius has
/// nothing lower. Not those in a drain, nor those where a flipper or plunger comes, nor those on a bumper with threshold 0, nor ripples: what a
/// push by a tenth of the radius gets a ball out of. A level floor is one pocket.
std::vector<Pocket> pockets_of(const Program& program);

/// Each of them, as a warning at the node it lies on.
Diagnostics pocket_warnings(const Program& program, const Scene& scene);

}  // namespace pinfield

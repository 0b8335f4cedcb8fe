// Where there is room for a ball: for one that an edit has put into something solid, and for one that cannot start where it should.
#pragma once
#include <optional>

#include "engine/physics/world.h"

namespace pinfield {

/// Metres by which a ball in play overlaps solids or movers now; 0 when it does not.
double overlap_of(const World& world, const Ball& ball);

/// The place nearest to the ball where it neither overlaps anything solid nor another ball, as found along rings around it: to within a
/// sixth of its radius and six degrees. None within `reach` metres: nothing.
std::optional<Vec2> free_place(const World& world, const Ball& ball, double reach);

/// The same around any place, for a ball that is to start there while movers are at rest.
std::optional<Vec2> free_start(const Program& program, const Vec2& near, LayerMask layers, double reach);

}  // namespace pinfield

// Where a ball fits that an edit has put into something solid.
#pragma once
#include <optional>

#include "engine/physics/world.h"

namespace pinfield {

/// How deep a ball is in what is solid for it, beyond what a touching one may be, metres: 0 when it is not, or is out of play.
double overlap_of(const World& world, const Ball& ball);

/// The nearest place, to a millimetre or so, where the ball touches nothing solid and no other ball; nothing within `reach` metres.
std::optional<Vec2> free_place(const World& world, const Ball& ball, double reach);

}  // namespace pinfield

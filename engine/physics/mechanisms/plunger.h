// The plunger's reflex: a rod of prescribed speed, drawn back while its input is held and shooting forward when let go.
#pragma once
#include "engine/physics/world.h"
#include "engine/program/parts.h"
#include "engine/scene/parts/plunger.h"

namespace pinfield {

/// q = 0 is the rod at rest, q = -stroke fully drawn, `scale` times as long in the world as in the part.
MoverState plunger_at_rest(const parts::Plunger& plunger, double scale);
/// True in the tick in which the rod is let go.
bool drive_plunger(const parts::Plunger& plunger, MoverState& state);

}  // namespace pinfield

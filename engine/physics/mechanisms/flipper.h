// The flipper's reflex: a bat with one degree of freedom, driven by torque between two end-stops.
#pragma once
#include "engine/physics/world.h"
#include "engine/program/parts.h"
#include "engine/scene/parts/flipper.h"

namespace pinfield {

/// At rest. Inertia about the pivot is that of a uniform rod, m L^2 / 3, with L from the pivot to the end of the tip.
MoverState flipper_at_rest(const parts::Flipper& flipper, double scale);

/// Angular acceleration in the middle of the coming tick: full strength times the ramp while an input is held, `end_torque` of it
/// within `end_angle` of the raised stop; otherwise the return spring. Zero when it leans on an end-stop.
void drive_flipper(const parts::Flipper& flipper, MoverState& state, double step);

/// Acceleration against the end-stop at which it stands; 0 where it does not lean on one.
double flipper_leaning(const parts::Flipper& flipper, const MoverState& state);

/// Rebounds with `stop_bounce`, or stays when the remaining train of rebounds is shorter than a tick.
void flipper_hits_stop(const parts::Flipper& flipper, MoverState& state, double step);

}  // namespace pinfield

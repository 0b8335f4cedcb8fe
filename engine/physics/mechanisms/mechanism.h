// What the parts on a table do inside the tick: the reflexes. Flippers and plungers have a file
// each; what bumpers and drains do is a line of mechanism.cpp. This header is what the World knows of them.
#pragma once
#include <span>

#include "engine/physics/world.h"

namespace pinfield {

/// The mover's state when a game starts: end-stops, axis, inertia.
MoverState mover_at_rest(const Program& program, int mover);
/// Where it then stands.
Similarity world_from_resting_mover(const Program& program, int mover);

/// Sets acceleration (and, for kinematic parts, rate) for the coming tick of `step` seconds.
/// True when a plunger was let go just now.
bool drive_mover(const Program& program, int mover, MoverState& state, double step);

/// How hard a mover that stands at an end-stop is driven against it: acceleration, >= 0.
double leaning(const Program& program, int mover, const MoverState& state);

/// Before each tick: its input is pressed, or not.
void switch_mover(MoverState& state, bool pressed);

/// Answers an end-stop that was hit: the state stands on it, moving into it. `step`: length of a tick.
void hit_end_stop(const Program& program, int mover, MoverState& state, double step);

/// How far any point of the mover may ever be from its pivot, metres.
double mover_reach(const Program& program, int mover, const MoverState& state);

/// Speed added to a ball that hits this part with normal speed `speed`; 0 for parts that do not kick.
double kick_of(const Part& part, double speed);

/// Is the centre of a ball in these layers in the sensor of a drain?
bool drains(const Program& program, const Sensor& sensor, const Vec2& centre, LayerMask layers);

}  // namespace pinfield

// Where balls leave the game. Not part of the layer's interface.
#pragma once
#include "engine/physics/motion.h"
#include "engine/physics/state.h"

namespace pinfield {

struct DrainEntry {
    const Sensor* sensor = nullptr;  ///< none: no drain is on the way
    double time = infinity;          ///< seconds on the path
};
/// The first drain of its layer that the centre of ball i comes into on this path.
DrainEntry first_drain(const WorldState& w, std::size_t i, const Motion& path, double duration);

/// Ball i, at its work's time, leaves the game, and its tick is over.
void fall_into(WorldState& w, std::size_t i, const Sensor& drain);

/// After a tick: a ball that was put into a drain, or moved out of a solid into one, and has no path of its own.
void drain_where_it_stands(WorldState& w, std::size_t i);

}  // namespace pinfield

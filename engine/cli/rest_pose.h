// Flippers and plungers where they stand before anything is pressed.
#pragma once
#include "engine/core/at.h"
#include "engine/physics/mechanisms/mechanism.h"
#include "engine/physics/sweep_mover.h"

namespace pinfield::cli {

inline Similarity world_from_resting_mover(const Program& program, int mover) {
    const MoverState rest = mover_at_rest(program, mover);
    const Pose pose = pose_of(at(program.movers, mover), rest.rotates, rest.axis, rest.q);
    return {.cosine = pose.cosine, .sine = pose.sine, .offset = pose.offset};
}

}  // namespace pinfield::cli

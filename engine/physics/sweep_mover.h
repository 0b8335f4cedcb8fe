// Time of impact of a ball against a moving part.
#pragma once
#include "engine/physics/sweep_field.h"
#include "engine/physics/world.h"
#include "engine/program/pose.h"

namespace pinfield {

struct MoverHit {
    FieldHit hit;                   ///< normal in the world's frame
    double clear_until = infinity;  ///< < duration when the budget ran out
};

/// First contact within `duration`, during which the mover follows q + rate t + acceleration t^2 / 2.
MoverHit sweep_mover(const SweptField& swept, const Mover& mover, const MoverState& state, const Motion& ball, double duration,
                     double radius, const ContactBand& band, LayerMask layers, SweepStats& stats);

}  // namespace pinfield

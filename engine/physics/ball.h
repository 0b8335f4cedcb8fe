// A ball.
#pragma once
#include "engine/core/geometry.h"
#include "engine/core/id.h"
#include "engine/program/program.h"

namespace pinfield {

using BallId = Id<struct BallTag>;

enum class BallState : unsigned char {
    rolling,
    resting,      ///< in contact and still: its bits do not change
    drained,      ///< out of play until put back
    quarantined,  ///< not finite: taken out of the simulation, with an event
    jammed        ///< pinched by a mover that does not yield: it stood still for the tick; an event when that begins
};

struct Ball {
    BallId id;
    Vec2 position{0, 0};  ///< of the centre, metres
    Vec2 velocity{0, 0};  ///< m/s
    double spin = 0;      ///< rad/s, counter-clockwise; a disc rolling along a wall spins in the plane of the table
    BallState state = BallState::rolling;
    LayerMask layer = ground_layer;
    Vec2 start_position{0, 0}, start_velocity{0, 0};  ///< where it is put back
    int spawn = -1;        ///< the part where that is, by its index in Program::parts; -1: it does not start at a spawn
    double free_path = 0;  ///< metres it may still travel before the next field query
};

/// Not drained and not taken out; a jammed ball is on the table, too.
inline bool is_on_table(const Ball& ball) { return ball.state != BallState::drained && ball.state != BallState::quarantined; }

/// Balls in different layers pass each other.
inline bool share_layer(const Ball& a, const Ball& b) { return (a.layer & b.layer) != 0; }

}  // namespace pinfield

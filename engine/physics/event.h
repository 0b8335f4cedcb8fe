// What happened in a tick, for rules, scores, sounds and tests.
#pragma once
#include <cstdint>
#include <string_view>

#include "engine/core/geometry.h"
#include "engine/core/id.h"
#include "engine/physics/ball.h"

namespace pinfield {

enum class EventKind : unsigned char { hit, kick, ball_hit, drain, press, release, end_stop, launch, quarantine, jam };
std::string_view name(EventKind kind);

struct Event {
    std::int64_t tick = 0;
    double time = 0;        ///< seconds since the start
    EventKind kind = EventKind::hit;
    BallId ball;            ///< none for events without a ball
    NodeId node;            ///< what was hit: the winning leaf's scene node, or the part
    Vec2 position{0, 0};    ///< contact point, or the ball's centre
    Vec2 normal{0, 0};      ///< unit, from the surface to the ball
    /// m/s. hit, ball_hit: normal approach speed. kick: what the part adds along the normal. end_stop: of the part's farthest point as it
    /// meets the stop. launch: of the rod when it is let go. 0 for the others.
    double speed = 0;
};

}  // namespace pinfield

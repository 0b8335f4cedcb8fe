// What happened in a tick, for rules, scores, sounds and tests.
#pragma once
#include <cstdint>
#include <string_view>

#include "engine/core/geometry.h"
#include "engine/core/id.h"
#include "engine/physics/ball.h"

namespace pinfield {

enum class EventKind : unsigned char {
    hit, kick, ball_hit, drain, press, release, end_stop, launch, quarantine, jam, held_back, leave, flood, stuck
};
std::string_view name(EventKind kind);
/// What happened, in a line for people.
std::string_view meaning(EventKind kind);

struct Event {
    std::int64_t tick = 0;
    double time = 0;        ///< seconds since the start
    EventKind kind = EventKind::hit;
    BallId ball;            ///< none for events without a ball; of two balls the one with the smaller id
    NodeId node;            ///< what was hit: the part's scene node, or where there is none the winning leaf's; none for balls that meet, quarantine. flood: the first that is not told. stuck: what is below. held_back: what is where the ball starts; none: a ball
    Vec2 position{0, 0};    ///< contact point, or the ball's centre
    Vec2 normal{0, 0};      ///< unit, from the surface to the ball
    /// m/s. hit, ball_hit: normal approach speed. kick: what the part adds along the normal. end_stop: of the part's farthest point as it
    /// meets the stop. launch: of the rod when it is let go. drain: of the ball. leave: the hardest approach of the touch. 0 for the others.
    double speed = 0;
    /// The part that it is about, by its index in Program::parts. hit, kick: whose surface it is, the domain being a part too; drain: the
    /// drain; press, release: the part that the input works; end_stop, launch: the part that moves; jam: the one that presses. -1: none.
    int part = -1;
    /// hit, kick, leave: what the surface is made of there, by its index in Program::materials. -1 for the others.
    int material = -1;
    BallId other{};       ///< the other one of two balls
    double duration = 0;  ///< leave: seconds from the first impulse to the last
};

/// As many as EventKind has.
inline constexpr int event_kinds = static_cast<int>(EventKind::stuck) + 1;

}  // namespace pinfield

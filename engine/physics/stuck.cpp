// Balls that lie where nobody can play them: told, and searched for as machines do, by firing what kicks. Only what touches the ball can
// move it, so only that fires.
#include <algorithm>

#include "engine/core/at.h"
#include "engine/physics/state.h"

namespace pinfield {

namespace {

constexpr double stuck_time = 3;      // seconds
constexpr double still_within = 0.5;  // ball radii: what rocks in a hollow by less is stuck as well

/// Calls f with each of a ball's touches, those of the balls that it touches included as seen from the other side.
template <class F>
void each_touch(const WorldState& w, BallId ball, F&& f) {
    for (const BallTouch& touch : w.open_touches)
        if (touch.ball == ball || touch.other == ball) f(touch);
}

/// Does a mover that has inputs touch the ball, or a ball that touches it, and so on? Then somebody holds it, or can play it.
bool is_played(const WorldState& w, BallId ball) {
    std::vector<BallId> found{ball};
    for (std::size_t k = 0; k < found.size(); ++k) {
        bool played = false;
        each_touch(w, found[k], [&](const BallTouch& touch) {
            if (touch.ball == found[k] && touch.part >= 0 && at(w.program().parts, touch.part).mover >= 0)
                played = played || !at(w.program().parts, touch.part).inputs.empty();
            if (!touch.other) return;
            const BallId next = touch.ball == found[k] ? touch.other : touch.ball;
            if (std::find(found.begin(), found.end(), next) == found.end()) found.push_back(next);
        });
        if (played) return true;
    }
    return false;
}

/// What the ball lies on: of what touches it, what pushes up most. Null: nothing.
const BallTouch* support_of(const WorldState& w, BallId ball) {
    const BallTouch* best = nullptr;
    const auto up = [&](const BallTouch& touch) { return -dot(touch.normal, w.physics.gravity); };
    for (const BallTouch& touch : w.open_touches)
        if (touch.ball == ball && touch.node && (!best || up(touch) > up(*best))) best = &touch;
    return best;
}

/// Parts that kick, and touch the ball, do so however slow it is. True when one did.
bool search(WorldState& w, std::size_t i) {
    Ball& ball = w.balls[i];
    bool kicked = false;
    for (BallTouch& touch : w.open_touches) {
        if (touch.ball != ball.id || touch.part < 0 || w.options.restitution) continue;
        const double kick = kick_of(at(w.program().parts, touch.part), infinity);
        if (kick <= 0) continue;
        wake(w, i);
        ball.velocity += kick * touch.normal;
        touch.off = kick;
        const Vec2 point = ball.position - w.physics.ball_radius * touch.normal;
        w.events.push_back({w.tick, w.start_time() + w.physics.step, EventKind::kick, ball.id, touch.node, point, touch.normal, kick, touch.part,
                            touch.material});
        kicked = true;
    }
    return kicked;
}

}  // namespace

void look_for_stuck_balls(WorldState& w) {
    const auto enough = static_cast<int>(stuck_time / w.physics.step);
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        BallMemory& memory = w.memories[i];
        const Ball& ball = w.balls[i];
        const bool moved = length(ball.position - memory.still_place) > still_within * w.physics.ball_radius;
        if (!is_on_table(ball) || moved) {
            memory.still_place = ball.position;
            memory.still_ticks = 0;
            memory.stuck = false;
            continue;
        }
        if (memory.stuck && memory.still_ticks >= enough) continue;  // nothing that kicks touches it
        if (++memory.still_ticks < enough) continue;
        if (is_played(w, ball.id)) {
            memory.still_ticks = 0;
            continue;
        }
        if (!memory.stuck) {
            const BallTouch* support = support_of(w, ball.id);
            w.events.push_back({w.tick, w.start_time() + w.physics.step, EventKind::stuck, ball.id, support ? support->node : NodeId{}, ball.position,
                                {0, 0}, 0, support ? support->part : -1});
        }
        memory.stuck = true;
        if (search(w, i)) memory.still_ticks = 0;
    }
}

}  // namespace pinfield

// Touches: what the impulses between a ball and one surface come to. A bat that pushes a ball, a loop that turns it and a jam that holds it
// make hundreds of impulses; a player feels, hears and counts one touch.
#include <algorithm>

#include "engine/core/at.h"
#include "engine/physics/state.h"

namespace pinfield {

namespace {

constexpr double longest_pause = 0.01;  // seconds without an impulse: a switch needs as long to close again, and an ear to hear two sounds
constexpr double away = 0.8;            // ball radii: one that went so far off its surface has left it
constexpr double same_side = 0.7;       // cosine between normals of one touch: around a corner a node is touched anew
constexpr int most_told = 32;           // hits and kicks of one ball in a tick; at 1000 m/s a dense table has about that many

double end_of_tick(const WorldState& w) { return w.start_time() + w.physics.step; }

std::size_t index_of(const WorldState& w, BallId id) {
    const auto found = std::lower_bound(w.balls.begin(), w.balls.end(), id, [](const Ball& ball, BallId wanted) { return ball.id < wanted; });
    return static_cast<std::size_t>(found - w.balls.begin());
}

bool is_over(const WorldState& w, const BallTouch& touch, double time) {
    const double since = time - touch.last;
    return since > std::max(longest_pause, 1.5 * w.physics.step) || touch.off * since > away * w.physics.ball_radius;
}

void tell_end(WorldState& w, const BallTouch& touch, double time) {
    if (!touch.told) return;
    const Vec2 place = w.balls[index_of(w, touch.ball)].position - w.physics.ball_radius * touch.normal;
    w.events.push_back({w.tick, time, EventKind::leave, touch.ball, touch.node, place, touch.normal, touch.hardest, touch.part, touch.material,
                        touch.other, touch.last - touch.since});
}

/// May one more event of this ball be told in this tick? The first that may not is told as a flood.
bool has_room(WorldState& w, const Impulse& impulse) {
    BallWork& work = w.work[index_of(w, impulse.ball)];
    if (++work.told <= most_told) return true;
    if (work.told == most_told + 1)
        w.events.push_back({w.tick, impulse.time, EventKind::flood, impulse.ball, impulse.of.node, impulse.point, {0, 0}, 0, impulse.of.part});
    return false;
}

void tell(WorldState& w, const Impulse& impulse, EventKind kind, double speed) {
    const bool is_ball = static_cast<bool>(impulse.other);
    w.events.push_back({w.tick, impulse.time, kind, impulse.ball, impulse.of.node, impulse.point, impulse.normal, speed, impulse.of.part,
                        is_ball ? -1 : impulse.of.material, impulse.other});
}

BallTouch& touch_of(WorldState& w, const Impulse& impulse) {
    const auto before = [](const BallTouch& touch, BallId ball) { return touch.ball < ball; };
    auto touch = std::lower_bound(w.open_touches.begin(), w.open_touches.end(), impulse.ball, before);
    for (; touch != w.open_touches.end() && touch->ball == impulse.ball; ++touch)
        if (touch->node == impulse.of.node && touch->other == impulse.other && dot(touch->normal, impulse.normal) > same_side) break;
    const bool is_new = touch == w.open_touches.end() || touch->ball != impulse.ball;
    if (is_new) touch = w.open_touches.insert(touch, BallTouch{});
    if (!is_new && !is_over(w, *touch, impulse.time)) return *touch;
    if (!is_new) tell_end(w, *touch, impulse.time);
    *touch = {};
    touch->ball = impulse.ball;
    touch->node = impulse.of.node;
    touch->other = impulse.other;
    touch->part = impulse.of.part;
    touch->material = impulse.other ? -1 : impulse.of.material;
    touch->since = impulse.time;
    return *touch;
}

void take(WorldState& w, const Impulse& impulse) {
    BallTouch& touch = touch_of(w, impulse);
    touch.normal = impulse.normal;
    touch.last = impulse.time;
    touch.off = std::max(0.0, impulse.off);
    touch.hardest = std::max(touch.hardest, impulse.approach);
    touch.along = impulse.along;
    touch.slip = impulse.slip;
    touch.load += impulse.pressed * w.physics.ball_mass / w.physics.step;
    if (impulse.tells && !touch.told && has_room(w, impulse)) {
        touch.told = true;
        tell(w, impulse, impulse.other ? EventKind::ball_hit : EventKind::hit, impulse.approach);
    }
    if (impulse.kick > 0 && has_room(w, impulse)) tell(w, impulse, EventKind::kick, impulse.kick);
}

}  // namespace

void note(WorldState& w, const Impulse& impulse) {
    if (!w.impulses.empty()) {
        Impulse& last = w.impulses.back();
        const bool same = last.ball == impulse.ball && last.other == impulse.other && last.of.node == impulse.of.node && last.time == impulse.time;
        if (same && dot(last.normal, impulse.normal) > same_side) {
            const Impulse before = last;
            last = impulse;
            last.approach = std::max(before.approach, impulse.approach);
            last.pressed += before.pressed;
            last.kick += before.kick;
            last.tells = before.tells || impulse.tells;
            return;
        }
    }
    w.impulses.push_back(impulse);
}

void press(WorldState& w, BallId ball, const Vec2& normal, double gained) {
    for (std::size_t k = w.impulses.size(); k-- > 0 && w.impulses[k].ball == ball;) {
        if (dot(w.impulses[k].normal, normal) < same_side) continue;
        w.impulses[k].pressed += gained;
        return;
    }
}

void tell_touches(WorldState& w) {
    const double now = end_of_tick(w);
    for (BallTouch& touch : w.open_touches) {
        if (w.balls[index_of(w, touch.ball)].state == BallState::resting) touch.last = now;
        else touch.load = 0;
    }
    for (const Impulse& impulse : w.impulses) take(w, impulse);
    w.impulses.clear();
    std::erase_if(w.open_touches, [&](const BallTouch& touch) {
        const bool gone = !is_on_table(w.balls[index_of(w, touch.ball)]) || (touch.other && !is_on_table(w.balls[index_of(w, touch.other)]));
        if (!gone && !is_over(w, touch, now)) return false;
        tell_end(w, touch, now);
        return true;
    });
}

}  // namespace pinfield

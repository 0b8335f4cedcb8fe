// Drains: where a ball's centre leaves the game, on its path as it is flown.
#include "engine/physics/drain.h"

#include <algorithm>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/scene/parts/drain.h"

namespace pinfield {

namespace {

// How far a centre may be in a drain before it is noticed, and how shallow a corner it may cut. A drain is no wall: it needs no certificate.
constexpr double least_advance = 1e-5;  // m

/// Seconds until the centre is in the sensor, by going on as far as the distance to it allows (conservative advancement); infinity when it
/// does not come there.
double entry_into(const Sensor& sensor, const Motion& path, double duration, LayerMask layers) {
    const double speed = path.top_speed(duration);
    for (double t = 0;;) {
        const double distance = nearest(sensor.field, path.at(t), layers).distance;
        if (distance < 0) return t;
        if (speed == 0 || t >= duration) return infinity;
        t = std::min(duration, t + std::max(distance, least_advance) / speed);
    }
}

}  // namespace

DrainEntry first_drain(const WorldState& w, std::size_t i, const Motion& path, double duration) {
    DrainEntry first;
    if (w.program().sensors.empty()) return first;
    const Box2 flown = path.bounds(duration);
    for (const Sensor& sensor : w.program().sensors) {
        const bool near = std::any_of(sensor.field.solids.begin(), sensor.field.solids.end(),
                                      [&](const Solid& solid) { return solid.bounds.overlaps(flown); });
        if (!near || !at(w.program().parts, sensor.part).is<parts::Drain>()) continue;
        const double time = entry_into(sensor, path, duration, w.balls[i].layer);
        if (time < first.time) first = {&sensor, time};
    }
    return first;
}

void fall_into(WorldState& w, std::size_t i, const Sensor& drain) {
    Ball& ball = w.balls[i];
    ball.state = BallState::drained;
    w.events.push_back({w.tick, w.start_time() + w.work[i].time, EventKind::drain, ball.id, at(w.program().parts, drain.part).origin,
                        ball.position, {0, 0}, length(ball.velocity), drain.part});
    w.work[i].time = w.physics.step;
}

void drain_where_it_stands(WorldState& w, std::size_t i) {
    w.work[i].time = w.physics.step;
    if (const DrainEntry entry = first_drain(w, i, {w.balls[i].position, {0, 0}, {0, 0}}, 0); entry.sensor) fall_into(w, i, *entry.sensor);
}

}  // namespace pinfield

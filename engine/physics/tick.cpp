// One tick: forces to accelerations to velocities to positions, each stage followed by its filter (Baraff and Witkin's
// constraint filters as taught in Stanford's CS248B), then continuous detection for the path that comes out of it.
#include <algorithm>

#include "engine/core/at.h"
#include "engine/physics/drain.h"
#include "engine/physics/state.h"
#include "engine/program/evaluate.h"

namespace pinfield {

namespace {

constexpr double depenetration_speed = 2;  // m/s: out of a solid by a ball's diameter in 14 ms, which an eye follows

bool finite(const Ball& b) { return b.position.allFinite() && b.velocity.allFinite() && std::isfinite(b.spin); }

/// Balls that are held feel no force.
void filter_accelerations(const WorldState& w, std::size_t i, Vec2& acceleration) {
    if (w.balls[i].state != BallState::rolling || w.work[i].frozen) acceleration = {0, 0};
}

/// Balls that are held do not move. (Contacts act on velocities too, as impulses: see respond.cpp.)
void filter_velocities(const WorldState& w, std::size_t i, Vec2& velocity) {
    if (w.balls[i].state != BallState::rolling) velocity = {0, 0};
}

/// A ball whose numbers are not finite leaves the simulation.
void filter_positions(WorldState& w, std::size_t i) {
    Ball& ball = w.balls[i];
    if (finite(ball)) return;
    ball.state = BallState::quarantined;
    w.events.push_back({w.tick, w.start_time() + w.physics.step, EventKind::quarantine, ball.id, {}, ball.start_position, {0, 0}, 0});
}

/// The velocity stage of both integrators; leaves the acceleration of the path in the ball's work.
void begin_tick(WorldState& w, std::size_t i) {
    Vec2 acceleration = w.physics.gravity;
    filter_accelerations(w, i, acceleration);
    Vec2 velocity = w.balls[i].velocity;
    if (w.physics.integrator == Integrator::symplectic_euler) {
        velocity += w.physics.step * acceleration;
        acceleration = {0, 0};  // the path is straight within the tick
    }
    filter_velocities(w, i, velocity);
    w.balls[i].velocity = velocity;
    w.work[i].acceleration = acceleration;
}

/// What the playfield takes of a ball that goes on it, as a force of fixed size against its way: v' = v - h a v / |v|. A ball that this
/// would turn back stands, and only what gravity, with what it touches, has more than the playfield sets it going. Spin dies likewise, at
/// the edge. Asked when contact has taken its share of gravity.
void resist(WorldState& w, std::size_t i) {
    const double taken = w.physics.step * w.physics.rolling_resistance;
    if (taken <= 0 || w.memories[i].embedded) return;
    Ball& ball = w.balls[i];
    BallWork& work = w.work[i];
    const auto left_of = [taken](double speed) { return speed > taken ? 1 - taken / speed : 0.0; };
    if (length(ball.velocity) <= taken) {
        const Vec2 later = ball.velocity + w.physics.step * work.acceleration;
        ball.velocity = {0, 0};
        work.acceleration = left_of(length(later)) / w.physics.step * later;
        if (work.acceleration == Vec2(0, 0)) work.held = {};
    } else {
        ball.velocity *= left_of(length(ball.velocity));
    }
    ball.spin *= left_of(w.physics.ball_radius * std::fabs(ball.spin));
}

double longest_way(const WorldState& w, std::size_t i) {
    const Motion path{w.balls[i].position, w.balls[i].velocity, w.work[i].acceleration};
    return path.travel(w.physics.step);
}

void apply_inputs(WorldState& w) {
    for (const InputEdge& edge : w.edges) {
        if (at(w.pressed, edge.input) == edge.pressed) continue;
        at(w.pressed, edge.input) = edge.pressed;
        for (const Mover& mover : w.program().movers) {
            const Part& part = at(w.program().parts, mover.part);
            if (std::find(part.inputs.begin(), part.inputs.end(), edge.input) == part.inputs.end()) continue;
            w.events.push_back({w.tick, w.start_time(), edge.pressed ? EventKind::press : EventKind::release, {}, part.origin,
                                mover.pivot, {0, 0}, 0, mover.part});
        }
    }
    w.edges.clear();
}

void drive_movers(WorldState& w) {
    w.mover_work.assign(w.movers.size(), {});
    for (std::size_t m = 0; m < w.movers.size(); ++m) {
        const Mover& mover = w.program().movers[m];
        const Part& part = at(w.program().parts, mover.part);
        const bool held = std::any_of(part.inputs.begin(), part.inputs.end(),
                                      [&](int input) { return at(w.pressed, input) != 0; });
        switch_mover(w.movers[m], held);
        if (drive_mover(w.program(), static_cast<int>(m), w.movers[m], w.physics.step))
            w.events.push_back({w.tick, w.start_time(), EventKind::launch, {}, part.origin, mover.pivot, mover.axis,
                                std::fabs(w.movers[m].rate), mover.part});
    }
}

bool mover_near(const WorldState& w, std::size_t i, double way, bool moving_only) {
    for (std::size_t m = 0; m < w.movers.size(); ++m) {
        const MoverState& s = w.movers[m];
        if (moving_only && s.rate == 0 && s.acceleration == 0) continue;
        const double reach = mover_reach(w.program(), static_cast<int>(m), s) + w.physics.ball_radius + 2 * w.band.tolerance;
        if (length(w.balls[i].position - w.program().movers[m].pivot) <= reach + way) return true;
    }
    return false;
}

/// Marks the balls whose ticks have to be run together: those that may meet each other, those near movers, and whoever these
/// may be pushed against.
void mark_coupled(WorldState& w) {
    w.ways.clear();
    for (std::size_t i = 0; i < w.balls.size(); ++i) w.ways.push_back(w.in_play(i) ? longest_way(w, i) : 0.0);
    const std::vector<double>& ways = w.ways;
    const double touch = 2 * w.physics.ball_radius + 2 * w.band.tolerance;
    const double longest = *std::max_element(ways.begin(), ways.end());
    const auto runs = [&](std::size_t i) { return w.in_play(i) && !w.memories[i].embedded; };
    const auto within = [&](std::size_t i, std::size_t j, double reach) {
        const Vec2 apart = w.balls[i].position - w.balls[j].position;
        return dot(apart, apart) <= reach * reach;
    };
    for (std::size_t i = 0; i < w.balls.size(); ++i)
        w.work[i].coupled = runs(i) && mover_near(w, i, ways[i], w.balls[i].state == BallState::resting);
    w.order.take(w.balls);
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        if (!runs(i) || w.balls[i].state != BallState::rolling) continue;
        w.order.near(w.balls[i].position, touch + ways[i] + longest, w.nearby);
        for (const int near : w.nearby) {
            const std::size_t j = to_index(near);
            if (j != i && runs(j) && within(i, j, touch + ways[i] + ways[j])) w.work[i].coupled = w.work[j].coupled = true;
        }
    }
    w.coupled.clear();
    for (std::size_t i = 0; i < w.balls.size(); ++i)
        if (w.work[i].coupled) w.coupled.push_back(static_cast<int>(i));
    for (std::size_t k = 0; k < w.coupled.size(); ++k) {
        const std::size_t i = to_index(w.coupled[k]);
        w.order.near(w.balls[i].position, touch + 2 * longest, w.nearby);
        for (const int near : w.nearby) {
            const std::size_t j = to_index(near);
            if (w.work[j].coupled || !runs(j) || !within(i, j, touch + longest + ways[j])) continue;
            w.work[j].coupled = true;
            w.coupled.push_back(near);
        }
    }
}

/// A ball that did not change a bit in a whole tick, touching something, will not change in the next one either.
void rest_or_wake(WorldState& w, std::size_t i) {
    Ball& ball = w.balls[i];
    const Ball& before = w.balls_before[i];
    const bool still = ball.velocity.x() == 0 && ball.velocity.y() == 0 && ball.spin == 0 && ball.position == before.position &&
                       before.velocity.x() == 0 && before.velocity.y() == 0;
    if (ball.state == BallState::rolling && still && !w.work[i].piled && w.memories[i].slide_tick == w.tick && stands(w, w.memories[i].slide.mover))
        ball.state = BallState::resting;
}

/// Sorts this tick's events by time, then ids; each ball's are in order already.
void order_events(std::vector<Event>& events) {
    const auto before = [](const Event& a, const Event& b) {
        return a.time != b.time ? a.time < b.time : a.ball < b.ball;
    };
    if (!std::is_sorted(events.begin(), events.end(), before)) std::stable_sort(events.begin(), events.end(), before);
}

/// The tick of a ball that has `way` to go if nothing adds speed. False, with the ball back at the tick's start, when a kick sends it
/// farther: then it may meet what is not near.
bool try_uncoupled(WorldState& w, std::size_t i, double way) {
    const Ball ball = w.balls[i];
    const BallWork work = w.work[i];
    const BallMemory memory = w.memories[i];
    const std::size_t events = w.events.size(), paths = w.paths.size(), impulses = w.impulses.size();
    const Impulse last = impulses > 0 ? w.impulses.back() : Impulse{};  // to which one at this instant may be added
    // The limit leaves room for the rounding of a sum of at most 256 ways, less than 1e-13 of it, and for a gap that is restored.
    if (advance_uncoupled(w, i, way * (1 + 1e-9) + w.band.tolerance)) return true;
    w.balls[i] = ball;
    w.work[i] = work;
    w.memories[i] = memory;
    w.events.resize(events);
    w.paths.resize(paths);
    w.impulses.resize(impulses);
    if (impulses > 0) w.impulses.back() = last;
    return false;
}

/// The tick starts again for all balls, together.
void couple_everybody(WorldState& w) {
    for (std::size_t i = 0; i < w.balls.size(); ++i)
        if (w.work[i].time > 0 && !w.memories[i].embedded) {
            w.balls[i] = w.balls_before[i];
            w.work[i] = {};
            std::erase_if(w.impulses, [&](const Impulse& impulse) { return impulse.ball == w.balls[i].id; });
            begin_tick(w, i);
            keep_contact(w, i);
            resist(w, i);
        }
    std::erase_if(w.events, [](const Event& event) { return event.ball.value != 0; });
    w.paths.clear();
    w.order.take(w.balls);
    w.coupled.clear();
    for (std::size_t i = 0; i < w.balls.size(); ++i)
        if (w.in_play(i) && !w.memories[i].embedded) w.coupled.push_back(static_cast<int>(i));
}

/// Ticks of balls that surely meet no mover and no other ball; the others are put into w.coupled.
void run_uncoupled(WorldState& w) {
    const bool pairs = w.options.balls_collide && w.balls.size() > 1;
    if (pairs) mark_coupled(w);
    w.coupled.clear();
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        if (!w.in_play(i)) continue;
        if (w.memories[i].embedded) { depenetrate(w, i); continue; }
        Ball& ball = w.balls[i];
        const double way = longest_way(w, i);
        const bool rests = ball.state == BallState::resting;
        if (!pairs && !rests && way < ball.free_path && w.options.sweep) {
            advance_ball(w, i, w.physics.step);
            ball.free_path -= way;
            ++w.stats.free_steps;
        } else if (pairs ? w.work[i].coupled : mover_near(w, i, way, rests)) {
            w.coupled.push_back(static_cast<int>(i));
        } else if (!rests && !try_uncoupled(w, i, way)) {
            if (pairs) return couple_everybody(w);  // those that have run already may be in its way
            w.coupled.push_back(static_cast<int>(i));
        }
    }
}

/// What stands still has no speed, whatever the mover that presses it gave it.
void stop_jammed(Ball& ball) {
    ball.state = BallState::jammed;
    ball.velocity = {0, 0};
    ball.spin = 0;
}

}  // namespace

double room_without_mechanisms(const WorldState& w, const Vec2& centre) {
    double room = infinity;
    for (std::size_t m = 0; m < w.movers.size(); ++m) {
        const double reach = mover_reach(w.program(), static_cast<int>(m), w.movers[m]) + w.physics.ball_radius + 2 * w.band.tolerance;
        room = std::min(room, length(centre - w.program().movers[m].pivot) - reach);
    }
    for (const Sensor& sensor : w.program().sensors)
        for (const Solid& solid : sensor.field.solids) room = std::min(room, solid.bounds.distance(centre));
    return room;
}

void depenetrate(WorldState& w, std::size_t i) {
    Ball& ball = w.balls[i];
    const double r = w.physics.ball_radius, h = w.physics.step;
    std::vector<double> q;
    for (const MoverState& s : w.movers) q.push_back(s.q);
    const Gap gap = gap_at(w.program(), q, ball.position, ball.layer, 2 * r);
    const double missing = r + w.band.target() - gap.distance, size = length(gap.gradient);
    ball.free_path = 0;
    if (missing <= w.band.accepted() || size == 0) {
        w.memories[i].embedded = false;
        return;
    }
    const Vec2 n = gap.gradient / size;
    const Vec2 moved = std::min(missing, depenetration_speed * h) * n;
    if (w.recording) w.paths.push_back({ball.id, w.start_time(), h, ball.position, moved / h, {0, 0}});
    ball.position += moved;
    const double into = dot(n, ball.velocity);
    if (into < 0) ball.velocity -= into * n;
    if (w.physics.integrator == Integrator::symplectic_euler) ball.velocity -= h * w.physics.gravity;  // held: no weight yet
    ball.state = BallState::rolling;
    w.work[i].time = h;
}

void run_tick(WorldState& w) {
    w.events.clear();
    w.paths.clear();
    w.mover_paths.clear();
    w.work.assign(w.balls.size(), {});
    w.near.resize(w.balls.size());
    apply_inputs(w);
    drive_movers(w);
    for (std::size_t i = 0; i < w.balls.size(); ++i)
        if (w.memories[i].waiting) try_put_back(w, i);
    w.balls_before = w.balls;
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        if (w.balls[i].state == BallState::jammed) w.balls[i].state = BallState::rolling;  // it tries again
        if (w.balls[i].state == BallState::resting && mover_near(w, i, 0, true)) wake(w, i);
    }
    wake_piles(w);
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        if (w.balls_before[i].state == BallState::resting) w.balls_before[i].state = w.balls[i].state;
        if (w.in_play(i)) begin_tick(w, i);
    }
    settle_piles(w);
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        if (w.memories[i].slide_tick == w.tick - 1 && w.in_play(i) && !w.work[i].piled) keep_contact(w, i);
        if (w.in_play(i)) resist(w, i);
    }
    run_uncoupled(w);
    advance_coupled(w);
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        if (!w.in_play(i)) continue;
        if (w.balls[i].state == BallState::rolling) w.balls[i].velocity += w.work[i].late_kick;
        filter_positions(w, i);
        if (w.in_play(i)) drain_where_it_stands(w, i);
        rest_or_wake(w, i);
        if (w.work[i].jammed && w.in_play(i)) stop_jammed(w.balls[i]);
    }
    rest_piles(w);
    tell_touches(w);
    look_for_stuck_balls(w);
    order_events(w.events);
    w.stats.sweeps = w.sweeps.sweeps;
    w.stats.evaluations = w.sweeps.evaluations;
    w.stats.capped_queries = w.sweeps.capped;
    w.stats.most_evaluations = w.sweeps.most_evaluations;
    ++w.tick;
}

}  // namespace pinfield

// The event loops inside a tick: one ball against the static field, and several balls and movers together.
#include <algorithm>
#include <utility>

#include "engine/core/at.h"
#include "engine/physics/contact.h"
#include "engine/physics/drain.h"

namespace pinfield {

namespace {

constexpr double longest_slice = 4;  // ball radii: fast balls look for contacts a piece of their way at a time
constexpr double most_slices = 64;   // of a tick's way: a ball of a nanometre would look at it a million times

Motion motion_of(const WorldState& w, std::size_t i) {
    if (w.work[i].frozen || w.balls[i].state != BallState::rolling) return {w.balls[i].position, {0, 0}, {0, 0}};
    return {w.balls[i].position, w.balls[i].velocity, w.work[i].acceleration};
}

Contact contact_of(const WorldState& w, const FieldHit& hit, int mover) {
    return {hit.normal, w.band.target(), hit.concave_radius, mover, hit.solid, hit.leaf, hit.piece};
}

/// The budget is spent: the ball loses the rest of the tick, never its distance.
void freeze(WorldState& w, std::size_t i) {
    w.work[i].frozen = true;
    ++w.stats.capped_ticks;
}

/// On its way along a surface a ball gains what it falls, and loses what friction takes of its slip. A parabola beside a circle turns the
/// velocity rightly but changes its length by what the turn is off: the force that turns does no work.
void keep_energy(WorldState& w, std::size_t i, const Motion& path, double dt) {
    Ball& ball = w.balls[i];
    const Held& held = w.work[i].held;
    const double r = w.physics.ball_radius;
    const auto slip = [&](const Vec2& velocity) { return dot(velocity, held.along) - r * ball.spin; };
    const Vec2 way = dt * path.velocity + (0.5 * dt * dt) * path.acceleration;
    const double slip_before = slip(path.velocity), kinetic = twice_kinetic(w.physics, ball, path.velocity);
    ball.spin += dt * held.spin_acceleration;
    const double rubbed = held.friction * (slip_before + slip(ball.velocity)) * dt;
    const double kept = kinetic + 2 * dot(w.physics.gravity, way) + rubbed, now = twice_kinetic(w.physics, ball, ball.velocity);
    if (now <= 0) return;
    const double scale = kept > 0 ? std::sqrt(kept / now) : 0.0;
    ball.velocity *= scale;
    ball.spin *= scale;
}

}  // namespace

void advance_ball(WorldState& w, std::size_t i, double dt) {
    Ball& ball = w.balls[i];
    BallWork& work = w.work[i];
    if (dt <= 0) return;
    const Motion path = motion_of(w, i);
    const DrainEntry entry = first_drain(w, i, path, dt);
    dt = std::min(dt, entry.time);
    if (w.recording)
        w.paths.push_back({ball.id, w.start_time() + work.time, dt, path.position, path.velocity, path.acceleration});
    ball.position = path.at(dt);
    if (!path.is_straight()) ball.velocity = path.velocity_at(dt);
    if (work.held.by_surface) keep_energy(w, i, path, dt);
    work.time += dt;
    if (entry.sensor) fall_into(w, i, *entry.sensor);
}

Slice sweep_slice(WorldState& w, std::size_t i, double rest, double room) {
    const double r = w.physics.ball_radius;
    const Motion path = motion_of(w, i);
    const double speed = path.top_speed(rest), longest = std::max(longest_slice * r, speed * w.physics.step / most_slices);
    Slice slice;
    slice.duration = speed * rest > longest ? longest / speed : rest;
    const double travel = path.travel(slice.duration);
    slice.sweep = w.prepared->fixed.sweep(path, slice.duration, r, w.band, w.balls[i].layer, std::max(room, travel), w.sweeps, &w.near[i]);
    return slice;
}

bool advance_uncoupled(WorldState& w, std::size_t i, double limit) {
    const double h = w.physics.step;
    Ball& ball = w.balls[i];
    BallWork& work = w.work[i];
    while (work.time < h) {
        const double rest = h - work.time;
        if (!w.options.sweep) {  // test hook
            advance_ball(w, i, rest);
            break;
        }
        const Slice slice = sweep_slice(w, i, rest, w.physics.ball_radius);
        const FieldHit& hit = slice.sweep.hit;
        const double dt = std::min({slice.duration, hit.time, slice.sweep.clear_until});
        const double way = motion_of(w, i).travel(dt);
        work.travelled += way;
        if (work.travelled > limit) return false;
        advance_ball(w, i, dt);
        if (ball.state == BallState::drained) return true;
        if (hit.time > slice.duration && slice.sweep.clear_until >= slice.duration) {
            ball.free_path = std::min(slice.sweep.free_path - way, room_without_mechanisms(w, ball.position));
            if (dt == rest) break;
            continue;
        }
        if (hit.time > slice.duration || ++work.impacts > most_impacts) {
            freeze(w, i);
            break;
        }
        respond(w, i, contact_of(w, hit, -1));
    }
    work.time = h;
    return true;
}

void plan_stop(WorldState& w, std::size_t m) {
    const MoverState& s = w.movers[m];
    MoverWork& work = w.mover_work[m];
    work.stop_time = infinity;
    if (work.stalled || (s.rate == 0 && s.acceleration == 0)) return;
    const double up = first_zero(std::max(0.0, s.q_max - s.q), -s.rate, -s.acceleration);
    const double down = first_zero(std::max(0.0, s.q - s.q_min), s.rate, s.acceleration);
    work.stop_time = work.time + std::min(up, down);
}

void advance_mover(WorldState& w, std::size_t m, double time) {
    MoverState& s = w.movers[m];
    MoverWork& work = w.mover_work[m];
    const double dt = time - work.time;
    if (dt <= 0) return;
    const bool still = work.stalled || (s.rate == 0 && s.acceleration == 0);
    if (w.recording)
        w.mover_paths.push_back(
            {static_cast<int>(m), w.start_time() + work.time, dt, s.q, still ? 0.0 : s.rate, still ? 0.0 : s.acceleration});
    if (!still) {
        s.q = std::clamp(s.q + dt * s.rate + 0.5 * dt * dt * s.acceleration, s.q_min, s.q_max);
        s.rate += dt * s.acceleration;
    }
    work.time = time;
}

namespace {

/// The loop over balls and movers that may meet. Every ball and mover keeps its own time; only those that take part in an
/// event are brought to it, and only plans that it changes are made again.
class CoupledTick {
public:
    explicit CoupledTick(WorldState& w)
        : w_(w), h_(w.physics.step), pairs_(w.options.balls_collide && w.options.sweep && w.balls.size() > 1) {}

    void run() {
        for (std::size_t m = 0; m < w_.movers.size(); ++m) plan_stop(w_, m);
        w_.plans.resize(w_.balls.size());
        for (const int i : w_.coupled) {
            plan_fixed(to_index(i));
            plan_movers(to_index(i));
        }
        for (const int i : w_.coupled) at(w_.work, i).coupled = true;
        for (const int i : w_.coupled) widen_reach(to_index(i));
        for (const int i : w_.coupled) plan_pairs(to_index(i));
        while (step()) {}
        for (const int i : w_.coupled) {
            BallWork& work = at(w_.work, i);
            if (!work.frozen) advance_ball(w_, to_index(i), h_ - work.time);
            else if (w_.recording && work.time < h_) w_.paths.push_back(standing(to_index(i)));
            work.time = h_;
        }
        for (std::size_t m = 0; m < w_.movers.size(); ++m) advance_mover(w_, m, h_);
    }

private:
    bool moves(std::size_t i) const { return w_.balls[i].state == BallState::rolling && !w_.work[i].frozen; }
    PathSegment standing(std::size_t i) const {
        const BallWork& work = w_.work[i];
        return {w_.balls[i].id, w_.start_time() + work.time, h_ - work.time, w_.balls[i].position, {0, 0}, {0, 0}};
    }

    /// Runs the earliest event; false when none is left in the tick.
    bool step() {
        double earliest = h_;
        int mover = -1, ball = -1;
        for (std::size_t m = 0; m < w_.movers.size(); ++m)
            if (w_.mover_work[m].stop_time < earliest) {
                earliest = w_.mover_work[m].stop_time;
                mover = static_cast<int>(m);
            }
        for (const int i : w_.coupled) {
            const BallPlan& plan = at(w_.plans, i);
            const double next = std::min({plan.fixed_time, plan.mover_time, plan.pair_time});
            if (next < earliest) {
                earliest = next;
                ball = i;
                mover = -1;
            }
        }
        if (ball >= 0) {
            run_ball_event(to_index(ball));
            return true;
        }
        if (mover >= 0) run_stop(to_index(mover));
        return mover >= 0;
    }

    void run_stop(std::size_t m) {
        MoverState& s = w_.movers[m];
        const double time = w_.mover_work[m].stop_time;
        advance_mover(w_, m, time);
        s.q = s.rate > 0 || (s.rate == 0 && s.acceleration > 0) ? s.q_max : s.q_min;
        const Mover& mover = w_.program().movers[m];
        const double speed = std::fabs(s.rate) * (mover.slides ? 1.0 : mover.bounding_radius);
        hit_end_stop(w_.program(), static_cast<int>(m), s, h_);
        if (++w_.mover_work[m].stops > most_impacts) stall(m);
        const int side = s.q >= s.q_max ? 1 : -1;
        const bool heard = speed > 10 * w_.physics.rest_speed;  // slower ones are the end of a train of rebounds
        if (heard && std::exchange(s.rung, side) != side)
            w_.events.push_back({w_.tick, w_.start_time() + time, EventKind::end_stop, {}, at(w_.program().parts, mover.part).origin,
                                 mover.pivot, {0, 0}, speed, mover.part});
        replan_mover(m);
    }

    void stall(std::size_t m) {
        w_.mover_work[m].stalled = true;
        w_.movers[m].rate = w_.movers[m].acceleration = 0;
    }

    void replan_mover(std::size_t m) {
        plan_stop(w_, m);
        for (const int i : w_.coupled) plan_movers(to_index(i));
    }

    void run_ball_event(std::size_t i) {
        BallWork& work = w_.work[i];
        const BallPlan& plan = w_.plans[i];
        if (plan.pair_time < plan.fixed_time && plan.pair_time < plan.mover_time) return run_pair(i, to_index(plan.partner));
        const bool by_mover = plan.mover_time < plan.fixed_time;
        const double time = by_mover ? plan.mover_time : plan.fixed_time;
        advance_ball(w_, i, time - work.time);
        if (!w_.in_play(i)) return replan_ball(i);  // it has fallen into a drain
        work.time = time;
        const FieldHit hit = by_mover ? plan.mover_hit : plan.fixed_hit;
        const bool capped = by_mover ? plan.mover_capped : plan.fixed_capped;
        if (hit.solid < 0 && !capped) return replan_ball(i);  // the end of a slice
        if (by_mover) advance_mover(w_, to_index(plan.mover), time);
        if (by_mover && !moves(i)) {
            meet_immovable(i, to_index(plan.mover));
            return;
        }
        if (capped || ++work.impacts > most_impacts) {
            freeze(w_, i);
            replan_ball(i);
            return;
        }
        rates_.clear();
        for (std::size_t m = 0; m < w_.movers.size(); ++m) {
            if (near(i, m)) advance_mover(w_, m, time);
            rates_.push_back(w_.movers[m].rate);
        }
        respond(w_, i, contact_of(w_, hit, by_mover ? plan.mover : -1));
        // A mover that was only brought to this time goes on as planned: what others planned against it stands.
        for (std::size_t m = 0; m < w_.movers.size(); ++m)
            if (w_.movers[m].rate != rates_[m]) replan_mover(m);
        replan_ball(i);
    }

    bool near(std::size_t i, std::size_t m) const {
        const double reach = mover_reach(w_.program(), static_cast<int>(m), w_.movers[m]) + w_.physics.ball_radius + 2 * w_.band.tolerance;
        return length(w_.balls[i].position - w_.program().movers[m].pivot) <= reach;
    }

    /// A mover meets a ball that does not move: one at rest wakes, one whose budget is spent stops the mover.
    void meet_immovable(std::size_t i, std::size_t m) {
        if (w_.balls[i].state == BallState::resting) {
            wake(w_, i);
            replan_ball(i);
            return;
        }
        const bool jams = w_.movers[m].inverse_inertia == 0 && !w_.work[i].jammed;
        w_.work[i].jammed = w_.work[i].jammed || jams;
        const int part = w_.program().movers[m].part;
        if (jams && w_.balls_before[i].state != BallState::jammed)
            w_.events.push_back({w_.tick, w_.start_time() + w_.work[i].time, EventKind::jam, w_.balls[i].id,
                                 at(w_.program().parts, part).origin, w_.balls[i].position, {0, 0}, 0, part});
        stall(m);
        replan_mover(m);
    }

    void run_pair(std::size_t i, std::size_t j) {
        const double time = w_.plans[i].pair_time;
        for (const std::size_t k : {i, j}) {
            advance_ball(w_, k, time - w_.work[k].time);
            if (w_.in_play(k)) w_.work[k].time = time;
        }
        if (!w_.in_play(i) || !w_.in_play(j)) {
            replan_ball(i);
            return replan_ball(j);
        }
        if (++w_.work[i].impacts > most_impacts) freeze(w_, i);
        if (++w_.work[j].impacts > most_impacts) freeze(w_, j);
        for (const std::size_t k : {i, j})
            if (w_.balls[k].state == BallState::resting) wake(w_, k);
        respond_to_ball(w_, i, j);
        replan_ball(i);
        replan_ball(j);
    }

    void replan_ball(std::size_t i) {
        plan_fixed(i);
        plan_movers(i);
        if (!pairs_) return;
        widen_reach(i);
        plan_pairs(i);
        reachable(i, partners_);
        for (const int k : partners_)
            if (at(w_.plans, k).partner == static_cast<int>(i) && to_index(k) != i) plan_pairs(to_index(k));
    }

    void plan_fixed(std::size_t i) {
        const BallWork& work = w_.work[i];
        BallPlan& plan = w_.plans[i];
        plan.fixed_time = infinity;
        plan.fixed_hit = {};
        plan.fixed_capped = false;
        if (!moves(i) || work.time >= h_ || !w_.options.sweep) return;
        const double rest = h_ - work.time;
        const Slice slice = sweep_slice(w_, i, rest, 0);
        plan.fixed_hit = slice.sweep.hit;
        plan.fixed_capped = slice.sweep.clear_until < slice.duration;
        if (plan.fixed_capped) plan.fixed_time = work.time + slice.sweep.clear_until;
        else if (slice.sweep.hit.time <= slice.duration) plan.fixed_time = work.time + slice.sweep.hit.time;
        else if (slice.duration < rest) plan.fixed_time = work.time + slice.duration;
        w_.balls[i].free_path = 0;
    }

    void plan_movers(std::size_t i) {
        const BallWork& work = w_.work[i];
        BallPlan& plan = w_.plans[i];
        plan.mover_time = infinity;
        plan.mover_hit = {};
        plan.mover_capped = false;
        if (work.time >= h_ || !w_.in_play(i) || !w_.options.sweep) return;
        const Motion ball = motion_of(w_, i);
        for (std::size_t m = 0; m < w_.movers.size(); ++m) {
            MoverState state = w_.movers[m];
            const MoverWork& motion = w_.mover_work[m];
            if (motion.stalled) state.rate = state.acceleration = 0;
            if (!moves(i) && state.rate == 0 && state.acceleration == 0) continue;
            // Both from the later of their two times on: the ball and the mover go on as planned until then.
            const double from = std::max(work.time, motion.time), until = std::min(h_, motion.stop_time);
            if (from >= until) continue;
            const double dt = from - motion.time;
            state.q += dt * state.rate + 0.5 * dt * dt * state.acceleration;
            state.rate += dt * state.acceleration;
            const MoverHit found = sweep_mover(w_.prepared->movers[m], w_.program().movers[m], state, ball.from(from - work.time),
                                               until - from, w_.physics.ball_radius, w_.band, w_.balls[i].layer, w_.sweeps);
            const bool capped = found.clear_until < until - from;
            const double time = from + (capped ? found.clear_until : found.hit.time);
            if (time >= plan.mover_time || !(capped || found.hit.time <= until - from)) continue;
            plan.mover_time = time;
            plan.mover_hit = found.hit;
            plan.mover_capped = capped;
            plan.mover = static_cast<int>(m);
        }
    }

    /// First meeting of two balls: their relative motion against a disc of twice the radius.
    double meeting(std::size_t i, std::size_t j) {
        const BallWork &a = w_.work[i], &b = w_.work[j];
        const double from = std::max(a.time, b.time);
        if (from >= h_) return infinity;
        const Motion p = motion_of(w_, i).from(from - a.time), q = motion_of(w_, j).from(from - b.time);
        const Motion relative{p.position - q.position, p.velocity - q.velocity, p.acceleration - q.acceleration};
        if (relative.velocity == Vec2(0, 0) && relative.is_straight()) return infinity;
        SweepPiece disc{sdf::Piece::circle({0, 0}, w_.physics.ball_radius)};
        disc.corner_a = disc.corner_b = false;
        int evaluations = 0;
        return from + sweep_piece(disc, relative, h_ - from, w_.physics.ball_radius, w_.band, evaluations).time;
    }

    /// How far ball i may come from its place when the tick began, as it moves by now.
    void widen_reach(std::size_t i) {
        if (!pairs_) return;
        BallWork& work = w_.work[i];
        const double way = moves(i) ? motion_of(w_, i).travel(std::max(0.0, h_ - work.time)) : 0.0;
        work.reach = std::max(work.reach, length(w_.balls[i].position - w_.order.place(i)) + way);
        longest_reach_ = std::max(longest_reach_, work.reach);
    }

    /// The balls that may have met ball i when the tick is over, or plan to. Two that are too far from each other for what they do by now
    /// are asked again when one of them is replanned.
    void reachable(std::size_t i, std::vector<int>& out) const {
        const double touch = 2 * w_.physics.ball_radius + 2 * w_.band.tolerance;
        w_.order.near(w_.order.place(i), touch + w_.work[i].reach + longest_reach_, out);
        std::erase_if(out, [&](int k) {
            const BallWork& other = at(w_.work, k);
            const double reach = touch + w_.work[i].reach + other.reach;
            const Vec2 apart = w_.order.place(i) - w_.order.place(to_index(k));
            return !other.coupled || dot(apart, apart) > reach * reach;
        });
    }

    void plan_pairs(std::size_t i) {
        BallPlan& plan = w_.plans[i];
        plan.pair_time = infinity;
        plan.partner = -1;
        if (!pairs_ || !w_.in_play(i)) return;
        reachable(i, w_.nearby);
        for (const int k : w_.nearby) {
            const std::size_t j = to_index(k);
            if (j == i || !w_.in_play(j) || (!moves(i) && !moves(j)) || !share_layer(w_.balls[i], w_.balls[j])) continue;
            const double time = meeting(std::min(i, j), std::max(i, j));
            if (time < plan.pair_time) {
                plan.pair_time = time;
                plan.partner = k;
            }
            if (time < w_.plans[j].pair_time) {
                w_.plans[j].pair_time = time;
                w_.plans[j].partner = static_cast<int>(i);
            }
        }
    }

    WorldState& w_;
    double h_;
    bool pairs_;                 ///< balls may meet each other
    double longest_reach_ = 0;
    std::vector<double> rates_;
    std::vector<int> partners_;
};

}  // namespace

void advance_coupled(WorldState& w) {
    if (w.coupled.empty() && w.movers.empty()) return;
    CoupledTick(w).run();
}

}  // namespace pinfield

// Balls that lie on each other. Where they touch when a tick begins, contact is a constraint on the velocities at its end: no two
// approach, none enters a surface, and no contact pulls. Projected Gauss-Seidel over accumulated impulses finds the nearest such
// velocities (Jean and Moreau's contact dynamics; Catto, "Iterative dynamics with temporal coherence", 2005), friction included on
// surfaces; balls do not rub each other. What closes faster than a resting ball does is an impact, and left to the events of the tick.
// Where others are on parabolas, these move straight with their mean velocity, as far as their parabola would take them, and get the
// other half of their acceleration when the tick ends.
#include <algorithm>

#include "engine/core/at.h"
#include "engine/physics/contact.h"
#include "engine/program/evaluate.h"
#include "engine/program/pose.h"

namespace pinfield {

namespace {

// Of the impulses. A row of n balls needs some n^2; each round of twenty balls takes less than a microsecond.
constexpr int most_rounds = 1000;
constexpr double converged = 1e-9;         // of the rest speed: at 5e-12 m/s an hour makes 18 nm
constexpr double quiet = 1e-3;             // of the rest speed: slower balls may fall asleep; until then they move by 1.3 um
constexpr double quiet_time = 0.25;        // seconds
constexpr double separation_speed = 2;     // m/s: of balls that an author put into each other; as out of a solid
constexpr double least_slant = 0.1;        // cosine: a way out that leads more along a wall than this is none

/// Metres within which a slow ball may arrive in a tick.
double arriving(const WorldState& w) { return std::max(w.band.touching(), w.physics.step * slowest_pair_bounce(w, 0)); }

double touching_distance(const WorldState& w) { return 2 * w.physics.ball_radius + arriving(w); }

double slack_of(const WorldState& w, double gap) { return std::max(0.0, gap - w.band.target()) / w.physics.step; }

bool near_enough(const WorldState& w, std::size_t i, std::size_t j, double distance) {
    if (!share_layer(w.balls[i], w.balls[j])) return false;
    const Vec2 apart = w.balls[i].position - w.balls[j].position;
    return dot(apart, apart) <= distance * distance;
}

bool takes_part(const WorldState& w, std::size_t i) { return w.in_play(i) && !w.memories[i].embedded; }

/// Unit, from b to a. Balls at one place part along gravity, on which nothing else need agree.
Vec2 normal_of(const WorldState& w, std::size_t a, std::size_t b) {
    const Vec2 apart = w.balls[a].position - w.balls[b].position;
    const double distance = length(apart), g = length(w.physics.gravity);
    if (distance > 0) return apart / distance;
    return g > 0 ? Vec2(-w.physics.gravity / g) : Vec2(0, 1);
}

double height_of(const WorldState& w, std::size_t i) { return -dot(w.physics.gravity, w.balls[i].position); }

/// Is a above b? Lists of balls decide where gravity does not.
bool above(const WorldState& w, std::size_t a, std::size_t b) {
    const double ha = height_of(w, a), hb = height_of(w, b);
    return ha != hb ? ha > hb : a > b;
}

void take_pairs(WorldState& w) {
    const double reach = touching_distance(w);
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        w.order.near(w.balls[i].position, reach, w.nearby);
        for (const int near : w.nearby) {
            const std::size_t j = to_index(near);
            if (j <= i || !takes_part(w, i) || !takes_part(w, j) || !share_layer(w.balls[i], w.balls[j])) continue;
            if (w.balls[i].state == BallState::resting && w.balls[j].state == BallState::resting) continue;
            const bool over = above(w, i, j);
            PileContact c;
            c.ball = static_cast<int>(over ? i : j);
            c.below = static_cast<int>(over ? j : i);
            c.normal = normal_of(w, to_index(c.ball), to_index(c.below));
            const double e = w.options.restitution ? *w.options.restitution : w.physics.ball_restitution;
            const double closing = -dot(c.normal, at(w.balls, c.ball).velocity - at(w.balls, c.below).velocity);
            const bool overlap = near_enough(w, i, j, 2 * w.physics.ball_radius - w.band.tolerance);
            if (!overlap && closing > slowest_pair_bounce(w, e)) continue;
            c.slack = slack_of(w, length(w.balls[i].position - w.balls[j].position) - 2 * w.physics.ball_radius);
            w.pile.push_back(c);
            w.work[i].piled = w.work[j].piled = true;
        }
    }
}

/// What ball i stands on, of a field that stands still as `pose` says.
void take_surfaces(WorldState& w, std::size_t i, const SweptField& field, int mover, const Pose& pose) {
    const Ball& ball = w.balls[i];
    const double h = w.physics.step;
    const bool euler = w.physics.integrator == Integrator::symplectic_euler;
    w.touches.clear();
    field.touching(pose.place_from_world(ball.position), w.physics.ball_radius, arriving(w), ball.layer, w.touches);
    for (const Touch& touch : w.touches) {
        PileContact c;
        c.ball = static_cast<int>(i);
        c.normal = mover < 0 ? touch.normal : pose.to_world(touch.normal);
        c.surface = {mover, touch.solid, touch.piece};
        c.slack = slack_of(w, touch.gap);
        const Contact contact{c.normal, touch.gap, touch.concave_radius, mover, touch.solid, touch.leaf, touch.piece};
        c.of = surface_of(w, contact);
        const MaterialRecord& material = at(w.program().materials, c.of.material);
        const double e = w.options.restitution ? *w.options.restitution : material.restitution;
        const bool rubs = !w.options.restitution && material.tangential < 1;
        c.friction = rubs ? material.friction : 0.0;
        const double weight = h * std::max(0.0, -dot(c.normal, w.physics.gravity)) * (1 + 1e-9);
        const double closing = -dot(c.normal, ball.velocity) + (euler ? 0.0 : weight);
        if (closing <= (e < 1 ? std::max(w.physics.rest_speed, weight) : weight)) w.pile.push_back(c);
    }
    w.touches.clear();
}

void take_all_surfaces(WorldState& w) {
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        if (!w.work[i].piled) continue;
        take_surfaces(w, i, w.prepared->fixed, -1, {});
        for (std::size_t m = 0; m < w.movers.size(); ++m) {
            const MoverState& state = w.movers[m];
            if (state.rate != 0 || state.acceleration != 0) continue;
            const Mover& mover = w.program().movers[m];
            const double reach = mover_reach(w.program(), static_cast<int>(m), state) + w.physics.ball_radius + w.band.tolerance;
            if (length(w.balls[i].position - mover.pivot) > reach) continue;
            take_surfaces(w, i, w.prepared->movers[m], static_cast<int>(m), pose_of(mover, state.q));
        }
    }
}

/// One contact's step of Gauss-Seidel. Returns by how much it changed a velocity.
double relax(WorldState& w, PileContact& c) {
    Ball& ball = at(w.balls, c.ball);
    if (c.below >= 0) {
        Ball& below = at(w.balls, c.below);
        const double before = c.pressed, apart = dot(c.normal, ball.velocity - below.velocity) + c.slack;
        c.pressed = std::max(0.0, before - 0.5 * apart);
        ball.velocity += (c.pressed - before) * c.normal;
        below.velocity -= (c.pressed - before) * c.normal;
        return std::fabs(c.pressed - before);
    }
    const double before = c.pressed, r = w.physics.ball_radius;
    c.pressed = std::max(0.0, before - dot(c.normal, ball.velocity) - c.slack);
    ball.velocity += (c.pressed - before) * c.normal;
    double change = std::fabs(c.pressed - before);
    if (c.friction > 0) {
        const Vec2 t = perpendicular(c.normal);
        const double rubbed = c.rubbed, slip = dot(t, ball.velocity) - r * ball.spin, cone = c.friction * c.pressed;
        c.rubbed = std::clamp(rubbed - slip / slip_yield(w.physics), -cone, cone);
        ball.velocity += (c.rubbed - rubbed) * t;
        ball.spin += spin_gained(w.physics, c.rubbed - rubbed);
        change = std::max(change, std::fabs(c.rubbed - rubbed));
    }
    return change;
}

void relax_all(WorldState& w) {
    const double enough = converged * w.physics.rest_speed;
    for (int round = 0; round < most_rounds; ++round) {
        double change = 0;
        for (PileContact& c : w.pile) change = std::max(change, relax(w, c));
        for (std::size_t k = w.pile.size(); k-- > 0;) change = std::max(change, relax(w, w.pile[k]));
        if (change <= enough) return;
    }
}

/// What lies on a part that kicks however slow it is touched is kicked.
void note_contact(WorldState& w, const PileContact& c) {
    if (c.below >= 0) return note_meeting(w, to_index(c.ball), to_index(c.below), 0, 2 * c.pressed, false);
    Ball& ball = at(w.balls, c.ball);
    const double r = w.physics.ball_radius;
    const double kick = c.of.part >= 0 && !w.options.restitution ? kick_of(at(w.program().parts, c.of.part), 0) : 0.0;
    if (kick > 0) ball.velocity += kick * c.normal;
    const double along = dot(ball.velocity, perpendicular(c.normal));
    note(w, {ball.id, {}, c.of, ball.position - r * c.normal, c.normal, w.start_time(), 0, dot(ball.velocity, c.normal), along,
             along - r * ball.spin, c.pressed, kick, kick > 0});
}

/// Velocities are to be those at the end of the tick: symplectic Euler's are already. On parabolas what still closes is taken away first,
/// at the tick's start, so that only weight is left to be spread.
void solve(WorldState& w) {
    relax_all(w);
    if (w.physics.integrator != Integrator::symplectic_euler) {
        for (std::size_t i = 0; i < w.balls.size(); ++i) {
            if (!w.work[i].piled) continue;
            w.work[i].late_kick = w.balls[i].velocity;
            w.balls[i].velocity += w.physics.step * w.work[i].acceleration;
            w.work[i].acceleration = {0, 0};
        }
        for (PileContact& c : w.pile) c.pressed = c.rubbed = 0;
        relax_all(w);
        for (std::size_t i = 0; i < w.balls.size(); ++i) {
            if (!w.work[i].piled) continue;
            const Vec2 last = w.balls[i].velocity;
            w.balls[i].velocity = 0.5 * (w.work[i].late_kick + last);
            w.work[i].late_kick = last - w.balls[i].velocity;
        }
    }
    for (const PileContact& c : w.pile) {
        if (c.pressed == 0) continue;
        note_contact(w, c);
        if (c.below >= 0) continue;
        at(w.memories, c.ball).slide = c.surface;
        at(w.memories, c.ball).slide_tick = w.tick;
    }
}

/// Moves ball i by `by` along n, or along the surfaces that it touches and that are in the way. False where there is no room.
bool push(WorldState& w, std::size_t i, const Vec2& n, double by) {
    Vec2 way = n;
    for (const PileContact& c : w.pile)
        if (c.below < 0 && to_index(c.ball) == i && dot(c.normal, way) < 0) way -= dot(c.normal, way) * c.normal;
    const double size = length(way), slant = size > 0 ? dot(way, n) / size : 0.0;
    if (slant < least_slant) return false;
    const Vec2 place = w.balls[i].position + (by / slant / size) * way;
    std::vector<double> q;
    for (const MoverState& s : w.movers) q.push_back(s.q);
    const double r = w.physics.ball_radius;
    if (gap_at(w.program(), q, place, w.balls[i].layer, 2 * r).distance < r + 0.125 * w.band.tolerance) return false;
    w.balls[i].position = place;
    w.balls[i].free_path = 0;
    return true;
}

/// Puts the gaps between balls back that rounding ate, from below to above, and moves balls apart that were put into each other: by
/// place, so that no speed comes of it.
void separate(WorldState& w) {
    const double r = w.physics.ball_radius, most = separation_speed * w.physics.step;
    for (const PileContact& c : w.pile) {
        if (c.below < 0) continue;
        const std::size_t over = to_index(c.ball), under = to_index(c.below);
        const double gap = length(w.balls[over].position - w.balls[under].position) - 2 * r;
        if (gap >= 0.25 * w.band.tolerance) continue;
        const Vec2 n = normal_of(w, over, under);
        const double by = std::min(w.band.target() - gap, most);
        if (!push(w, over, n, by)) push(w, under, -n, by);
    }
}

}  // namespace

double slowest_pair_bounce(const WorldState& w, double restitution) {
    const bool euler = w.physics.integrator == Integrator::symplectic_euler;
    const double weight = w.physics.step * length(w.physics.gravity) * (euler ? 1 + 1e-9 : 0.5 * (1 - restitution));
    return restitution < 1 ? std::max(w.physics.rest_speed, weight) : 1e-6 * w.physics.rest_speed;
}

void wake(WorldState& w, std::size_t i) {
    if (w.balls[i].state == BallState::resting) w.balls[i].state = BallState::rolling;
    w.memories[i].quiet_ticks = 0;
    if (!w.options.balls_collide) return;
    for (std::size_t j = 0; j < w.balls.size(); ++j)
        if (w.balls[j].state == BallState::resting && near_enough(w, i, j, touching_distance(w) + w.band.tolerance)) wake(w, j);
}

void wake_piles(WorldState& w) {
    const auto rests = [](const Ball& ball) { return ball.state == BallState::resting; };
    if (!w.options.balls_collide || std::none_of(w.balls.begin(), w.balls.end(), rests)) return;
    w.order.take(w.balls);
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        if (w.balls[i].state != BallState::rolling) continue;
        w.order.near(w.balls[i].position, touching_distance(w), w.nearby);
        for (const int j : w.nearby)
            if (rests(at(w.balls, j)) && share_layer(w.balls[i], at(w.balls, j))) wake(w, to_index(j));
    }
}

void settle_piles(WorldState& w) {
    w.pile.clear();
    if (!w.options.balls_collide || !w.options.sweep || w.balls.size() < 2) return;
    w.order.take(w.balls);
    take_pairs(w);
    if (w.pile.empty()) return;
    std::sort(w.pile.begin(), w.pile.end(), [&](const PileContact& a, const PileContact& b) {
        return a.ball != b.ball ? above(w, to_index(b.ball), to_index(a.ball)) : a.below < b.below;
    });
    take_all_surfaces(w);
    separate(w);
    solve(w);
}

void rest_piles(WorldState& w) {
    if (w.pile.empty()) return;
    const double slow = quiet * w.physics.rest_speed;
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        const bool still = w.work[i].piled && w.balls[i].state == BallState::rolling && !w.work[i].frozen && length(w.balls[i].velocity) <= slow &&
                           w.physics.ball_radius * std::fabs(w.balls[i].spin) <= slow;
        w.memories[i].quiet_ticks = still ? w.memories[i].quiet_ticks + 1 : 0;
        w.work[i].piled = static_cast<double>(w.memories[i].quiet_ticks) * w.physics.step >= quiet_time;
    }
    // All that touch fall asleep together: who touches one that stays awake stays awake.
    for (bool changed = true; changed;) {
        changed = false;
        for (const PileContact& c : w.pile) {
            if (c.below < 0 || at(w.work, c.ball).piled == at(w.work, c.below).piled) continue;
            at(w.work, c.ball).piled = at(w.work, c.below).piled = false;
            changed = true;
        }
    }
    for (std::size_t i = 0; i < w.balls.size(); ++i) {
        if (!w.work[i].piled) continue;
        w.balls[i].state = BallState::resting;
        w.balls[i].velocity = {0, 0};
        w.balls[i].spin = 0;
    }
}

}  // namespace pinfield

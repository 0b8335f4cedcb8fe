// Impulses: what a ball and a surface, or two balls, do to each other's velocities when they meet.
// Restitution and the Coulomb cone as in Mirtich, "Impulse-based dynamic simulation of rigid body systems" (1996), for a disc or
// a sphere in the plane; contacts at one instant are resolved one after the other in the order of their ids until none closes.
#include <algorithm>

#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "engine/core/trig.h"
#include "engine/physics/contact.h"

namespace pinfield {

namespace {

// Of resolving simultaneous contacts. Two surfaces hand an impulse back and forth, times the square of their normals' cosine each round: at
// 45 degrees 32 rounds leave less than 1e-9 of it; of a narrower wedge the next tick takes the rest.
constexpr int most_rounds = 32;
constexpr int hops_per_tick = 16;    // of a ball that follows a hollow or an accelerating surface
constexpr double steepest_hop = 0.1; // its normal speed per speed along the hollow: fast balls in narrow ones take more hops instead
constexpr int impacts_of_a_crowd = 16;  // of one ball in one tick: balls that rattle between others stop doing so, unless they bounce for ever
// Of the sum of two velocities, as a share of their lengths: some 450 roundings of a double, more than one impact makes. A contact that
// closes slower than this has been resolved already.
constexpr double rounding_of_speeds = 1e-13;

/// Can an end-stop take a change of the mover's rate with this sign, so that the mover does not yield?
bool stop_holds(const MoverState& s, double change) {
    return (s.q >= s.q_max && s.rate + change > 0) || (s.q <= s.q_min && s.rate + change < 0);
}

/// Would its drive have a mover that leans on its stop back there within half a tick, were its rate changed so? Then it does not yield: a
/// bat carries what lies on it, and bounces off it do not turn into many.
bool drive_holds(const WorldState& w, int mover, double change) {
    if (!stands(w, mover)) return false;
    return std::fabs(change) <= 0.5 * w.physics.step * leaning(w.program(), mover, at(w.movers, mover));
}

struct Impact {
    double approach = 0;     ///< normal speed, m/s, of the velocity that energy is made of
    double restitution = 0;
    double hop = 0;          ///< normal speed it leaves with instead, m/s, to follow a surface that comes after it
    double turned = 0;       ///< normal speed, m/s, that weight and the surface's bend may have given it within a tick
    bool collapsed = false;
};

/// Does the ball still bounce? A train of bounces under the pressing acceleration p lasts 2 u / (p (1 - e)) altogether, so when
/// that is less than what is left of the tick all of it ends in there (exactly: infinitely many bounces).
Impact judge(const WorldState& w, const BallWork& work, const Contact& c, const MaterialRecord& material,
             const SurfaceMotion& surface, double closing, double lead, double sliding) {
    Impact impact;
    const double u = std::max(0.0, closing), h = w.physics.step;
    impact.approach = std::max(0.0, closing - lead);
    const double e0 = w.options.restitution ? *w.options.restitution : material.restitution;
    const double e = w.options.restitution ? e0 : e0 / (1 + material.falloff * impact.approach);
    const double weight = std::max(0.0, -dot(c.normal, w.physics.gravity));
    const double bend = c.concave_radius > w.physics.ball_radius ? sliding * sliding / (c.concave_radius - w.physics.ball_radius) : 0.0;
    const double pushed = std::max(0.0, surface.acceleration);
    const double press = weight + bend + pushed, left = h - work.time;
    // On a parabola a train of bounces slower than this ends within a tick. Euler hands a ball that lies a whole tick's weight before it
    // moves, which must not bounce: 1e-9 of it is far above its rounding, and far below what is seen.
    const bool euler = w.physics.integrator == Integrator::symplectic_euler;
    const double rest = std::max(w.physics.rest_speed, weight * h * (euler ? 1 + 1e-9 : 0.5 * (1 - e)));
    // A millionth of the rest speed is rounding, not even e = 1 bounces with it: at 5 nm/s a tick is 5e-5 of the usual tolerance.
    impact.collapsed = u <= 1e-6 * w.physics.rest_speed || (e < 1 && (u <= rest || 2 * u <= press * (1 - e) * left));
    impact.restitution = impact.collapsed ? 0.0 : e;
    const double hop_time = 0.5 * std::min(left, h / hops_per_tick);
    if (impact.collapsed) impact.hop = std::min(bend * hop_time, steepest_hop * std::fabs(sliding)) + pushed * hop_time;
    return impact;
}

void scatter(const WorldState& w, Ball& ball, const Contact& c, const MaterialRecord& material, int draw) {
    if (material.scatter_degrees <= 0 || w.options.restitution) return;
    CounterRng rng(w.options.seed, static_cast<std::uint64_t>(w.tick));
    rng.set_counter(std::uint64_t{ball.id.value} * 1024 + static_cast<std::uint64_t>(draw));
    const SineCosine turn = sine_cosine_degrees(rng.in(-material.scatter_degrees, material.scatter_degrees));
    const Vec2 v{turn.cosine * ball.velocity.x() - turn.sine * ball.velocity.y(),
                 turn.sine * ball.velocity.x() + turn.cosine * ball.velocity.y()};
    if (dot(v, c.normal) > 0) ball.velocity = v;
}

/// One contact of a ball that is being resolved.
struct Meeting {
    WorldState& w;
    std::size_t index;  ///< of the ball
    Ball& ball;
    Contact& c;
    Vec2 n, t;  ///< unit, world: out of the surface, and along it
    SurfaceMotion surface;
    const MaterialRecord& material;
    Impact impact;
    Vec2 lead;    ///< lead_of() the ball
    double mass;  ///< of the ball, kg
};

/// Along the normal; returns the ball's gain of speed. `normal`: its speed off the surface before.
double bounce(Meeting& m, double normal) {
    const double off = m.impact.restitution * m.impact.approach - dot(m.n, m.lead);  // Newton's law for the velocity of which energy is made
    const double leaves = m.impact.collapsed ? m.impact.hop : std::max(0.0, off);
    double gained = std::max(0.0, normal > 0 ? m.impact.hop - normal : leaves - normal);  // impulses in units of the ball's mass
    if (m.surface.yielding > 0) {
        MoverState& state = at(m.w.movers, m.c.mover);
        const double share = m.mass * m.surface.lever_normal * m.surface.lever_normal * m.surface.yielding;
        const double change = -(gained / (1 + share)) * m.mass * m.surface.lever_normal * m.surface.yielding;
        if (stop_holds(state, change) || drive_holds(m.w, m.c.mover, change)) {
            m.surface.yielding = 0;
        } else {
            gained /= 1 + share;
            state.rate += change;
        }
    }
    m.ball.velocity += gained * m.n;
    return gained;
}

/// Along the surface: slip' = e_t slip within the Coulomb cone. Where the ball stays, its slip is to be gone when the tick ends; where it
/// bounces, the law is for the slip of which energy is made. Either way friction does no work: it reverses that slip at most. Returns what
/// it takes, in units of twice_kinetic().
double rub(Meeting& m, double slip, double gained) {
    const bool frictionless = m.w.options.restitution.has_value();
    const double tangential = frictionless ? 1.0 : m.impact.collapsed && m.material.tangential < 1 ? 0.0 : m.material.tangential;
    const double true_slip = slip + dot(m.t, m.lead);
    if (tangential == 1 || (slip == 0 && true_slip == 0)) return 0;
    const double share = m.mass * m.surface.lever_tangent * m.surface.lever_tangent * m.surface.yielding, yields = slip_yield(m.w.physics), easily = yields + share;
    const double wanted = m.impact.collapsed ? -slip / easily : -(1 - tangential) * true_slip / easily;
    const double cone = m.material.friction * gained, reversed = -2 * true_slip / easily;
    const double pull = std::clamp(std::clamp(wanted, -cone, cone), std::min(0.0, reversed), std::max(0.0, reversed));
    m.ball.velocity += pull * m.t;
    m.ball.spin += spin_gained(m.w.physics, pull);
    if (m.surface.yielding > 0) at(m.w.movers, m.c.mover).rate -= pull * m.mass * m.surface.lever_tangent * m.surface.yielding;
    return -pull * (2 * true_slip + yields * pull);
}

/// Kicks the ball where the part does, and notes the impact. True when it kicked.
bool report(Meeting& m, const Surface& of, const Vec2& point, double gained, bool tells) {
    WorldState& w = m.w;
    const double kick = of.part >= 0 && !w.options.restitution ? kick_of(at(w.program().parts, of.part), m.impact.approach) : 0.0;
    if (kick > 0) m.ball.velocity += kick * m.n;
    const Vec2 moves = m.c.mover < 0 ? Vec2(0, 0) : surface_motion_of(w, m.c, point, m.t).velocity;
    const Vec2 relative = m.ball.velocity - moves;
    const double along = dot(relative, m.t), time = w.start_time() + w.work[m.index].time;
    note(w, {m.ball.id, {}, of, point, m.n, time, m.impact.approach, dot(relative, m.n), along, along - w.physics.ball_radius * m.ball.spin, gained,
             kick, tells || kick > 0});
    return kick > 0;
}

/// Charges an impact to the ball's budget. A ball that follows a surface is turned by it, which costs nothing; what it closes with beyond
/// that, and what it closes with where it arrives anew, it loses.
void charge(Budget& budget, const WorldState& w, const Meeting& m, const BallMemory& memory, double closing, double rubbed) {
    const Impact& impact = m.impact;
    const bool follows = impact.collapsed && stands(w, m.c.mover) && memory.slide_tick >= w.tick - 1 && m.c.surface() == memory.slide;
    const double excess = std::max(0.0, closing - impact.turned);
    budget.lost += rubbed + (follows ? excess * std::max(0.0, 2 * impact.approach - excess) : 0.0);
    budget.turns = budget.turns && follows && impact.turned > 0;
    budget.open = budget.open || !stands(w, m.c.mover);
}

/// Changes velocities at one contact. True when the contact was closing.
bool resolve(WorldState& w, std::size_t i, Contact& c, bool forced, Budget& budget) {
    Ball& ball = w.balls[i];
    const BallWork& work = w.work[i];
    BallMemory& memory = w.memories[i];
    const double r = w.physics.ball_radius;
    const Vec2 n = c.normal, t = perpendicular(n), point = ball.position - r * n, lead = lead_of(w, i);
    const SurfaceMotion surface = surface_motion_of(w, c, point, t);
    const Vec2 relative = ball.velocity - surface.velocity;
    const double normal = dot(relative, n), slip = dot(relative, t) - r * ball.spin;
    if (normal >= 0 && !forced) return false;
    if (!forced && -normal <= rounding_of_speeds * (length(ball.velocity) + length(surface.velocity))) return false;
    const Surface of = surface_of(w, c);
    const MaterialRecord& material = at(w.program().materials, of.material);
    Impact impact = judge(w, work, c, material, surface, -normal, dot(lead, n), dot(relative, t));
    if (impact.collapsed && stands(w, c.mover)) {
        const double bend = bend_of(w, ball, c, dot(relative, t));
        if (bend > 0) impact.turned = w.physics.step * (bend + std::max(0.0, -dot(n, w.physics.gravity)));
    }
    Meeting m{w, i, ball, c, n, t, surface, material, impact, lead, w.physics.ball_mass};
    c.collapsed = impact.collapsed;
    ++w.stats.impacts;

    const double gained = bounce(m, normal);
    charge(budget, w, m, memory, -normal, rub(m, slip, gained));
    if (c.collapsed) {
        memory.slide = c.surface();
        memory.slide_tick = w.tick;
    } else {
        scatter(w, ball, c, material, work.impacts);
    }
    const bool tells = !impact.collapsed || impact.approach > w.physics.rest_speed;
    c.told = c.told || tells;
    budget.open = report(m, of, point, gained, tells) || budget.open;
    return true;
}

/// Notes how fast the ball comes to each surface, before impulses change that.
void note_approaches(WorldState& w, std::size_t i) {
    const Ball& ball = w.balls[i];
    for (Contact& c : w.contacts) {
        const Vec2 point = ball.position - w.physics.ball_radius * c.normal;
        const Vec2 relative = ball.velocity + lead_of(w, i) - surface_motion_of(w, c, point, {0, 0}).velocity;
        c.approach = -dot(c.normal, relative);
    }
}

/// A ball that meets several surfaces at one instant may be thrown off all of them by the first impulse. It hit the others as well.
void tell_the_rest(WorldState& w, std::size_t i) {
    const Ball& ball = w.balls[i];
    for (Contact& c : w.contacts) {
        if (c.told || c.approach <= w.physics.rest_speed || c.gap > w.band.touching()) continue;
        const Surface of = surface_of(w, c);
        const auto tells = [&](const Contact& other) { return other.told && surface_of(w, other).node == of.node; };
        if (std::any_of(w.contacts.begin(), w.contacts.end(), tells)) continue;
        c.told = true;
        const Vec2 point = ball.position - w.physics.ball_radius * c.normal;
        const double along = dot(ball.velocity, perpendicular(c.normal));
        note(w, {ball.id, {}, of, point, c.normal, w.start_time() + w.work[i].time, c.approach, dot(ball.velocity, c.normal), along,
                 along - w.physics.ball_radius * ball.spin, 0, 0, true});
    }
}

/// Everything within the skin, in order of ids, `first` (which the sweep reported) included.
void gather(WorldState& w, std::size_t i, const Contact& first) {
    const Ball& ball = w.balls[i];
    const double r = w.physics.ball_radius, skin = w.band.tolerance;
    w.contacts.clear();
    const auto take = [&](int mover, const Pose& pose) {
        for (const Touch& touch : w.touches) {
            const Vec2 normal = mover < 0 ? touch.normal : pose.to_world(touch.normal);
            w.contacts.push_back({normal, touch.gap, touch.concave_radius, mover, touch.solid, touch.leaf, touch.piece});
        }
        w.touches.clear();
    };
    w.prepared->fixed.touching(ball.position, r, skin, ball.layer, w.touches);
    take(-1, {});
    for (std::size_t m = 0; m < w.movers.size(); ++m) {
        const Mover& mover = w.program().movers[m];
        const MoverState& state = w.movers[m];
        if (length(ball.position - mover.pivot) > mover_reach(w.program(), static_cast<int>(m), state) + r + skin) continue;
        MoverState now = state;  // the surface as it stands at the ball's time
        const double dt = w.work[i].time - w.mover_work[m].time;
        if (!w.mover_work[m].stalled) now.q += dt * state.rate + 0.5 * dt * dt * state.acceleration;
        const Pose pose = pose_of(mover, now.q);
        w.prepared->movers[m].touching(pose.place_from_world(ball.position), r, skin, ball.layer, w.touches);
        take(static_cast<int>(m), pose);
    }
    for (Contact& c : w.contacts)
        if (c.surface() == first.surface()) {
            c.normal = first.normal;
            return;
        }
    w.contacts.push_back(first);
    std::stable_sort(w.contacts.begin(), w.contacts.end(), [](const Contact& a, const Contact& b) {
        if (a.mover != b.mover) return a.mover < b.mover;
        return a.solid != b.solid ? a.solid < b.solid : a.piece < b.piece;
    });
}

}  // namespace

Surface surface_of(const WorldState& w, const Contact& c) {
    const Program& program = w.program();
    const Field& field = c.mover < 0 ? program.fixed : at(program.movers, c.mover).field;
    const Solid& solid = at(field.solids, c.solid);
    const Op& op = at(field.ops, c.leaf >= 0 ? c.leaf : solid.root);
    const int part = c.mover < 0 ? solid.part : at(program.movers, c.mover).part;
    return {part, op.material, part >= 0 ? at(program.parts, part).origin : op.origin};
}

SurfaceMotion surface_motion_of(const WorldState& w, const Contact& c, const Vec2& point, const Vec2& tangent) {
    SurfaceMotion m;
    if (c.mover < 0) return m;
    const Mover& mover = at(w.program().movers, c.mover);
    const MoverState& state = at(w.movers, c.mover);
    m.velocity = velocity_of(mover, state.rate, point);
    const Vec2 per_rate = velocity_of(mover, 1, point);
    m.lever_normal = dot(per_rate, c.normal);
    m.lever_tangent = dot(per_rate, tangent);
    m.acceleration = state.acceleration * m.lever_normal;
    m.yielding = at(w.mover_work, c.mover).stalled ? 0.0 : state.inverse_inertia;
    return m;
}

void respond(WorldState& w, std::size_t i, const Contact& first) {
    gather(w, i, first);
    Budget budget = budget_of(w, i);
    note_approaches(w, i);
    for (Contact& c : w.contacts)
        if (c.surface() == first.surface()) resolve(w, i, c, true, budget);
    bool closing = true;
    for (int round = 0; closing && round < most_rounds; ++round) {
        closing = false;
        for (Contact& c : w.contacts)
            if (resolve(w, i, c, false, budget)) closing = true;
        // Surfaces that do not push a ball into each other are done in one round. What still closes after three is a wedge.
        if (closing && round >= 3 && settle_in_wedge(w, i)) break;
    }
    tell_the_rest(w, i);
    rest_in_wedge(w, i);
    balance(w, i, budget, restore_gap(w, i, budget));
    constrain(w, i);
    w.balls[i].free_path = 0;
}

void respond_to_ball(WorldState& w, std::size_t i, std::size_t j) {
    Ball &a = w.balls[i], &b = w.balls[j];
    const Vec2 apart = a.position - b.position;
    const double distance = length(apart);
    const Vec2 n = distance > 0 ? Vec2(apart / distance) : Vec2(0, 1);
    const double closing = -dot(n, a.velocity - b.velocity);
    if (closing <= 0) return;
    const double e0 = w.options.restitution ? *w.options.restitution : w.physics.ball_restitution;
    const bool crowded = std::max(w.work[i].impacts, w.work[j].impacts) > impacts_of_a_crowd;
    const double e = e0 < 1 && (crowded || closing <= slowest_pair_bounce(w, e0)) ? 0.0 : e0;
    const double gained = (1 + e) * closing;
    const bool a_yields = !w.work[i].frozen, b_yields = !w.work[j].frozen;
    if (a_yields && b_yields) {
        a.velocity += (0.5 * gained) * n;
        b.velocity -= (0.5 * gained) * n;
    } else if (a_yields) {
        a.velocity += gained * n;
    } else if (b_yields) {
        b.velocity -= gained * n;
    }
    ++w.stats.impacts;
    a.free_path = b.free_path = 0;
    note_meeting(w, i, j, closing, gained, closing > w.physics.rest_speed);
}

void note_meeting(WorldState& w, std::size_t i, std::size_t j, double closing, double gained, bool tells) {
    const bool in_order = w.balls[i].id < w.balls[j].id;
    const Ball &a = w.balls[in_order ? i : j], &b = w.balls[in_order ? j : i];
    const Vec2 apart = a.position - b.position, relative = a.velocity - b.velocity;
    const double distance = length(apart);
    const Vec2 n = distance > 0 ? Vec2(apart / distance) : Vec2(0, 1);
    const double along = dot(relative, perpendicular(n));
    note(w, {a.id, b.id, {}, b.position + w.physics.ball_radius * n, n, w.start_time() + w.work[i].time, closing, dot(relative, n), along,
             along - w.physics.ball_radius * (a.spin + b.spin), 0.5 * gained, 0, tells});
}

}  // namespace pinfield

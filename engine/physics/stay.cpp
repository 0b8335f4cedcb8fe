// Lasting contact: what a ball that stays on a surface keeps of its energy, how gravity and friction act on it, and when it rests.
#include <algorithm>

#include "engine/core/at.h"
#include "engine/physics/contact.h"
#include "engine/program/pose.h"

namespace pinfield {

namespace {

// Sine of the angle between two normals below which they count as one: a normal has 15 digits, and a quotient by less would keep under 7.
constexpr double least_wedge = 1e-9;
// What taking away gravity's part along one normal may leave of it along another that takes it up as well: some 5000 roundings.
constexpr double rounding_of_gravity = 1e-12;
// Of the rest speed: what is slower is rounding (as in judge()), and is not amplified.
constexpr double rounding_of_rest = 1e-6;

/// How a surface treats a ball that is about to come to rest on it.
struct Grip {
    bool bounces = false;  ///< for ever: e = 1
    bool rubs = false;     ///< slip dies on it
};

Grip grip_of(const WorldState& w, const Contact& c) {
    if (w.options.restitution) return {*w.options.restitution >= 1, false};
    const MaterialRecord& material = at(w.program().materials, surface_of(w, c).material);
    return {material.restitution >= 1, material.friction > 0 && material.tangential < 1};
}

/// How far the ball's centre is from the centre of curvature of the surface that it touches: infinity on what is straight or hollow.
double turning_radius(const WorldState& w, const Ball& ball, const Contact& c) {
    if (c.piece < 0) return infinity;
    const double r = w.physics.ball_radius;
    if (c.mover < 0) return nearest_on(at(w.prepared->fixed.pieces(), c.piece), ball.position).convex_radius + r;
    const Vec2 seen = pose_of(at(w.program().movers, c.mover), at(w.movers, c.mover).q).place_from_world(ball.position);
    return nearest_on(at(w.prepared->movers, c.mover).pieces()[to_index(c.piece)], seen).convex_radius + r;
}

/// Friction on a ball that is pressed onto a surface at rest with this acceleration, `along` being that of its centre without friction:
/// what ends the slip when the tick ends, within the Coulomb cone. It opposes the mean slip of that time and so never does work.
double friction_of(const WorldState& w, std::size_t i, const Contact& c, double press, double along) {
    const Ball& ball = w.balls[i];
    const double left = w.physics.step - w.work[i].time;
    if (left <= 0 || press <= 0 || !grip_of(w, c).rubs) return 0;
    const double slip = dot(ball.velocity, perpendicular(c.normal)) - w.physics.ball_radius * ball.spin;
    const double cone = at(w.program().materials, surface_of(w, c).material).friction * press;
    const double yields = slip_yield(w.physics);
    const double wanted = -(slip / left + along) / yields, reversed = -(2 * slip / left + along) / yields;
    return std::clamp(std::clamp(wanted, -cone, cone), std::min(0.0, reversed), std::max(0.0, reversed));
}

}  // namespace

double bend_of(const WorldState& w, const Ball& ball, const Contact& c, double along) {
    const double r = w.physics.ball_radius;
    return along * along / (c.concave_radius > r ? c.concave_radius - r : turning_radius(w, ball, c));
}

Vec2 lead_of(const WorldState& w, std::size_t i) {
    if (w.physics.integrator != Integrator::symplectic_euler) return {0, 0};
    return (w.work[i].time - 0.5 * w.physics.step) * w.physics.gravity;
}

Budget budget_of(const WorldState& w, std::size_t i) {
    Budget budget;
    budget.kinetic = twice_kinetic(w.physics, w.balls[i], w.balls[i].velocity + lead_of(w, i));
    return budget;
}

// The speed is scaled, so that the ball keeps its direction, which no surface bars, and a ball that rolls goes on rolling:
// twice_kinetic() of k v + lead and k spin = budget is a quadratic for k.
void balance(WorldState& w, std::size_t i, const Budget& budget, const Vec2& lifted) {
    if (budget.open) return;
    Ball& ball = w.balls[i];
    const Vec2 lead = lead_of(w, i);
    const double target = budget.kinetic - budget.lost + 2 * dot(w.physics.gravity, lifted);
    const double moves = twice_kinetic(w.physics, ball, ball.velocity), least = rounding_of_rest * w.physics.rest_speed;
    if (moves <= least * least) return;
    const bool grows = twice_kinetic(w.physics, ball, ball.velocity + lead) > target;
    if (!grows && !budget.turns) return;
    const double along = dot(ball.velocity, lead), spare = target - dot(lead, lead), root = along * along + moves * spare;
    const double scale = std::max(0.0, ((root > 0 ? std::sqrt(root) : 0.0) - along) / moves);
    ball.velocity *= grows ? std::min(scale, 1.0) : scale;
    ball.spin *= grows ? std::min(scale, 1.0) : scale;
}

/// With the surfaces' speeds s1 and s2: v.n1 = s1 and v.n2 = s2.
bool settle_in_wedge(WorldState& w, std::size_t i) {
    const Contact* first = nullptr;
    Ball& ball = w.balls[i];
    for (const Contact& c : w.contacts) {
        if (!c.collapsed) continue;
        if (!first) { first = &c; continue; }
        const double wedge = cross(first->normal, c.normal);
        if (std::fabs(wedge) < least_wedge) continue;
        const Vec2 point = ball.position - w.physics.ball_radius * c.normal;
        const Vec2 other = ball.position - w.physics.ball_radius * first->normal;
        const double s1 = dot(first->normal, surface_motion_of(w, *first, other, {0, 0}).velocity);
        const double s2 = dot(c.normal, surface_motion_of(w, c, point, {0, 0}).velocity);
        ball.velocity = Vec2(s1 * c.normal.y() - s2 * first->normal.y(), s2 * first->normal.x() - s1 * c.normal.x()) / wedge;
        return true;
    }
    return false;
}

void rest_in_wedge(WorldState& w, std::size_t i) {
    Ball& ball = w.balls[i];
    const Vec2& g = w.physics.gravity;
    if (length(ball.velocity) > w.physics.rest_speed) return;
    const bool spins = w.physics.ball_radius * std::fabs(ball.spin) > w.physics.rest_speed;
    for (std::size_t a = 0; a < w.contacts.size(); ++a)
        for (std::size_t b = a + 1; b < w.contacts.size(); ++b) {
            const Contact &first = w.contacts[a], &second = w.contacts[b];
            if (!stands(w, first.mover) || !stands(w, second.mover)) continue;
            const double wedge = cross(first.normal, second.normal);
            if (std::fabs(wedge) < least_wedge) continue;
            const double on_first = -cross(g, second.normal) / wedge, on_second = -cross(first.normal, g) / wedge;
            if (on_first < 0 || on_second < 0) continue;
            const Grip grips[] = {grip_of(w, first), grip_of(w, second)};
            const bool rubs = grips[0].rubs || grips[1].rubs;
            if (grips[0].bounces || grips[1].bounces || (rubs && spins)) continue;
            ball.velocity = {0, 0};
            if (rubs) ball.spin = 0;
            return;
        }
}

/// In contact, gravity is taken up by the surfaces the ball stays on: what is left of it lies in the cone they leave free. On something
/// round part of it turns the ball about the centre of curvature, as long as there is enough of it; a faster ball flies off.
void constrain(WorldState& w, std::size_t i) {
    BallWork& work = w.work[i];
    work.held = {};
    if (w.physics.integrator == Integrator::symplectic_euler || work.piled) return;
    const Vec2& g = w.physics.gravity;
    work.acceleration = g;
    const Contact* only = nullptr;
    int holding = 0;
    Vec2 a = g;
    for (const Contact& c : w.contacts) {
        if (!c.collapsed || !stands(w, c.mover)) continue;
        const double into = dot(c.normal, a);
        if (into < 0) a -= into * c.normal;
        only = &c;
        ++holding;
    }
    if (holding == 0) return;
    for (const Contact& c : w.contacts)
        if (c.collapsed && stands(w, c.mover) && dot(c.normal, a) < -rounding_of_gravity * length(g)) a = {0, 0};
    if (holding == 1) {
        const Vec2 n = only->normal, t = perpendicular(n);
        const double along = dot(w.balls[i].velocity, t), turning = along * along / turning_radius(w, w.balls[i], *only);
        const double load = -dot(n, g) - turning;
        if (turning > 0 && load <= 0) return;  // it flies off
        const double friction = friction_of(w, i, *only, load, dot(t, a));
        press(w, w.balls[i].id, n, std::max(0.0, load) * (w.physics.step - work.time));
        a += friction * t - turning * n;
        work.held = {true, t, friction, spin_gained(w.physics, friction)};
    } else {
        work.held.by_surface = true;
    }
    work.acceleration = a;
}

/// Where nothing is in the way, to half the tolerance. Below a quarter of it the ball has crept as close as it may
/// (ContactBand::floor_below). What it is lifted it has fallen before, and pays for; one that cannot stays where it is.
Vec2 restore_gap(WorldState& w, std::size_t i, const Budget& budget) {
    const Vec2 lead = lead_of(w, i);
    for (const Contact& c : w.contacts) {
        if (!c.collapsed || c.gap >= 0.25 * w.band.tolerance) continue;
        const bool room = std::all_of(w.contacts.begin(), w.contacts.end(),
                                      [&](const Contact& other) { return dot(other.normal, c.normal) >= 0; });
        const Vec2 lift = (w.band.target() - c.gap) * c.normal;
        const bool affordable = budget.open || budget.kinetic - budget.lost + 2 * dot(w.physics.gravity, lift) >= dot(lead, lead);
        if (!room || (c.gap > 0 && !affordable)) continue;
        w.balls[i].position += lift;
        return lift;
    }
    return {0, 0};
}

void keep_contact(WorldState& w, std::size_t i) {
    const BallMemory& memory = w.memories[i];
    Ball& ball = w.balls[i];
    const int mover = memory.slide.mover;
    if (memory.slide_tick != w.tick - 1 || ball.state != BallState::rolling || !w.options.sweep || !stands(w, mover)) return;
    const bool euler = w.physics.integrator == Integrator::symplectic_euler;
    const Vec2 before = euler ? Vec2(ball.velocity - w.physics.step * w.physics.gravity) : ball.velocity;
    const Pose pose = mover < 0 ? Pose{} : pose_of(at(w.program().movers, mover), at(w.movers, mover).q);
    const SweptField& field = mover < 0 ? w.prepared->fixed : at(w.prepared->movers, mover);
    w.touches.clear();
    field.touching(pose.place_from_world(ball.position), w.physics.ball_radius, w.band.touching(), ball.layer, w.touches);
    for (const Touch& touch : w.touches) {
        const Vec2 normal = mover < 0 ? touch.normal : pose.to_world(touch.normal);
        const Contact c{normal, touch.gap, touch.concave_radius, mover, touch.solid, touch.leaf, touch.piece};
        const double weight = -dot(c.normal, w.physics.gravity);
        const double bend = bend_of(w, ball, c, dot(before, perpendicular(c.normal)));
        const bool flies_off = c.concave_radius == 0 && bend > weight;
        if (weight <= 0 || flies_off) continue;
        if (dot(before, c.normal) > std::max(rounding_of_rest * w.physics.rest_speed, bend * w.physics.step)) continue;
        w.touches.clear();
        return respond(w, i, c);
    }
    w.touches.clear();
}

}  // namespace pinfield

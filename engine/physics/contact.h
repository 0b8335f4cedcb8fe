// What impacts (respond.cpp) and lasting contact (stay.cpp) ask of the surface that a ball touches. Not part of the layer's interface.
#pragma once
#include "engine/physics/state.h"

namespace pinfield {

Surface surface_of(const WorldState& w, const Contact& c);

/// How a surface moves at the contact, and how it yields to an impulse.
struct SurfaceMotion {
    Vec2 velocity{0, 0};
    double acceleration = 0;    ///< along the normal, of the drive
    double lever_normal = 0, lever_tangent = 0;  ///< change of the surface's velocity per change of rate
    double yielding = 0;        ///< inverse inertia
};
SurfaceMotion surface_motion_of(const WorldState& w, const Contact& c, const Vec2& point, const Vec2& tangent);

/// What turns a ball that keeps to a surface at this speed along it, m/s^2 towards the centre of curvature: 0 on what is straight, and
/// on what is known as a tree alone.
double bend_of(const WorldState& w, const Ball& ball, const Contact& c, double along);

/// The velocity of which energy is made is v + lead. Symplectic Euler gives a ball the weight of a whole tick at its start, v + h g, and
/// moves it straight along; the places at the ends of ticks lie on a parabola, and s seconds into the tick that parabola has the velocity
/// w = v + (s - h/2) g. With it
///     |w|^2 / 2 - g.x - (s - h/2)^2 |g|^2 / 2
/// is constant along the straight path and from each tick to the next, as its derivatives show; at the ends of ticks it is
///     |v|^2 / 2 - g.x + (h/2) g.v,
/// the energy that the integrator keeps exactly in free flight. Impacts are judged by w, so that bounces keep it as well: reflecting v
/// instead would add (h/2 - s) g.dv. On exact parabolas the lead is zero.
Vec2 lead_of(const WorldState& w, std::size_t i);

/// Twice the kinetic energy per mass of a ball with this velocity.
inline double twice_kinetic(const PhysicsRecord& p, const Ball& ball, const Vec2& velocity) {
    return dot(velocity, velocity) + p.ball_inertia * p.ball_radius * p.ball_radius * ball.spin * ball.spin;
}
/// How much more easily than its centre the place where a ball touches yields to an impulse along the surface: it turns away as well.
inline double slip_yield(const PhysicsRecord& p) { return 1 + 1 / p.ball_inertia; }
/// What such an impulse, per mass, adds to the spin.
inline double spin_gained(const PhysicsRecord& p, double impulse) { return -impulse / p.ball_inertia / p.ball_radius; }

/// What the impulses at one instant may leave of a ball's energy, in units of twice_kinetic().
struct Budget {
    double kinetic = 0;   ///< before
    double lost = 0;      ///< to friction, and of impacts that do not bounce
    bool open = false;    ///< movers and kicks do work: there is no limit
    bool turns = true;    ///< nothing but surfaces that the ball follows: the whole budget is kept
};
Budget budget_of(const WorldState& w, std::size_t i);

/// After the impulses at one instant: sets the ball's speed, and `lifted`, by which it was moved, against its budget.
void balance(WorldState& w, std::size_t i, const Budget& budget, const Vec2& lifted);
/// Puts back what rounding ate of the gap of a ball that stays in contact. Returns by how much the ball was moved.
Vec2 restore_gap(WorldState& w, std::size_t i, const Budget& budget);
/// A ball between two surfaces on which it no longer bounces stands relative to both. False when there are no such two.
bool settle_in_wedge(WorldState& w, std::size_t i);
/// A slow ball on two surfaces between which gravity holds it comes to rest: alternating impulses alone would leave it creeping,
/// and rolling up one side and down the other by nanometres.
void rest_in_wedge(WorldState& w, std::size_t i);
/// Sets the acceleration of a ball's path on what it touches.
void constrain(WorldState& w, std::size_t i);

}  // namespace pinfield

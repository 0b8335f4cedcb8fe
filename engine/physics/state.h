// What a World holds, for the files that run its tick. Not part of the layer's interface.
#pragma once
#include <memory>
#include <vector>

#include "engine/core/at.h"
#include "engine/physics/ball_order.h"
#include "engine/physics/mechanisms/mechanism.h"
#include "engine/physics/persistent_state.h"
#include "engine/physics/sweep_field.h"
#include "engine/physics/sweep_mover.h"
#include "engine/physics/world.h"

namespace pinfield {

/// A surface that a ball touches: of the static field, or of a mover.
struct Contact {
    Vec2 normal{0, 0};    ///< unit, world, out of the surface
    double gap = 0;
    double concave_radius = 0;
    int mover = -1;       ///< -1: the static field
    int solid = -1, leaf = -1, piece = -1;
    bool collapsed = false;  ///< it no longer bounces: the ball stays on it
    double approach = 0;     ///< m/s along the normal, of the velocity of which energy is made, before any impulse
    bool told = false;       ///< by an event

    SurfaceRef surface() const { return {mover, solid, piece}; }
};

/// What the surface of a contact is made of, and to whom it belongs.
struct Surface {
    int part = -1, material = 0;  ///< indices into the program's
    NodeId node;
};

/// An impulse on a ball, of a surface or of another ball: what touches are made of when the tick is over.
struct Impulse {
    BallId ball, other;          ///< other: none for surfaces
    Surface of;
    Vec2 point{0, 0}, normal{0, 0};
    double time = 0;             ///< seconds since the world's start
    double approach = 0, off = 0, along = 0, slip = 0;  ///< m/s, as in BallTouch
    double pressed = 0;          ///< m/s: of the ball's mass
    double kick = 0;             ///< m/s that the part added
    bool tells = false;          ///< hard enough for an event
};

/// What surfaces that a ball stays on do to it on its way.
struct Held {
    bool by_surface = false;
    Vec2 along{0, 0};             ///< unit, of the surface that rubs
    double friction = 0;          ///< m/s^2 along it; part of the path's acceleration
    double spin_acceleration = 0; ///< rad/s^2
};

/// A contact of a pile: of a ball with one below it, or with a surface at rest.
struct PileContact {
    int ball = -1, below = -1;     ///< below -1: a surface
    Vec2 normal{0, 0};             ///< unit, towards `ball`
    SurfaceRef surface;
    Surface of;
    double slack = 0;              ///< m/s at which it may close: the gap that is left for the tick
    double friction = 0;
    double pressed = 0, rubbed = 0;  ///< impulses per mass so far, m/s: along the normal, and along the surface
};

/// A ball's place in the tick that is being run.
struct BallWork {
    double time = 0;             ///< seconds into the tick that its position and velocity stand for
    Vec2 acceleration{0, 0};     ///< of its path
    int impacts = 0;
    bool frozen = false;         ///< its budget is spent: it stands still until the next tick
    double travelled = 0;        ///< metres, since the tick began
    Held held;                   ///< what surfaces do to it on its way: on parabolas only
    bool coupled = false;        ///< its tick is run together with others'
    bool piled = false;          ///< it touches other balls, and its contacts were settled together: its path is straight
    double reach = 0;            ///< metres: how far from its place in `order` it may come in this tick, as it moves by now
    Vec2 late_kick{0, 0};        ///< m/s: what of its acceleration, on what would be a parabola, it gets when the tick ends
    int told = 0;                ///< hits and kicks
    bool jammed = false;         ///< a mover that does not yield has pressed it against what does not either, in this tick
};

/// The earliest events of a ball whose tick is run together with others'.
struct BallPlan {
    FieldHit fixed_hit, mover_hit;
    double fixed_time = infinity, mover_time = infinity, pair_time = infinity;
    bool fixed_capped = false, mover_capped = false;
    int mover = -1, partner = -1;
};

/// A mover's place in the tick that is being run; its MoverState stands for `time`.
struct MoverWork {
    double time = 0;
    double stop_time = infinity;  ///< when it meets its end-stop
    int stops = 0;
    bool stalled = false;         ///< a ball that cannot yield is in its way: it stands still until the next tick
};

/// A Program made ready for sweeping; shared by snapshots.
struct PreparedProgram {
    explicit PreparedProgram(ProgramPtr from);
    ProgramPtr program;
    SweptField fixed;
    std::vector<SweptField> movers;
};

/// What the program and the options come to. It is no state: worlds are compared on one program.
struct WorldSetup {
    std::shared_ptr<const PreparedProgram> prepared;
    PhysicsRecord physics;  ///< the program's, with the options' overrides
    ContactBand band;
};

/// For whoever watches: the events of the last tick, and what was counted. Nothing in a tick reads it.
struct WorldReport {
    std::vector<Event> events;
    WorldStats stats;
    SweepStats sweeps;
    bool recording = false;
    std::vector<PathSegment> paths;
    std::vector<MoverSegment> mover_paths;
};

/// Made anew within each tick, and kept only so that the steady state allocates nothing. A snapshot leaves it behind: that a copy
/// goes on as the original does shows that it decides nothing.
struct WorldScratch {
    std::vector<BallWork> work;      ///< one a ball
    std::vector<MoverWork> mover_work;
    std::vector<Contact> contacts;
    std::vector<Touch> touches;
    std::vector<int> coupled;
    std::vector<double> ways;        ///< metres that each ball goes in this tick if nothing adds speed
    BallOrder order;                 ///< where balls are when they are asked for their neighbours
    std::vector<int> nearby;
    std::vector<BallPlan> plans;     ///< of the balls in `coupled`, by their index among all
    std::vector<Ball> balls_before;
    std::vector<PileContact> pile;
    std::vector<Impulse> impulses;   ///< of this tick; each ball's in order of time
    /// Of each ball, in the static field. It outlasts the tick, as a cache: what a sweep finds has the same bits without it (decision 16).
    /// (A ball's free_path is no such thing: whether the field is asked at all depends on it, and so does where a budget runs out.)
    std::vector<Neighbours> near;
};

struct WorldState : WorldSetup, PersistentState, WorldReport, WorldScratch {
    WorldState() = default;
    /// The scratch begins anew.
    WorldState(const WorldState& other)  // NOLINT(bugprone-copy-constructor-init)
        : WorldSetup(other), PersistentState(other), WorldReport(other) {}
    WorldState& operator=(const WorldState&) = delete;

    const Program& program() const { return *prepared->program; }
    double start_time() const { return static_cast<double>(tick) * physics.step; }
    bool in_play(std::size_t ball) const {
        return balls[ball].state == BallState::rolling || balls[ball].state == BallState::resting;
    }
};

inline std::size_t to_index(int i) { return static_cast<std::size_t>(i); }

inline constexpr int most_impacts = 256;  ///< of one ball in one tick

/// Does this surface stand still in this tick: the static field (-1), or a mover that neither moves nor is driven?
inline bool stands(const WorldState& w, int mover) {
    return mover < 0 || (at(w.movers, mover).rate == 0 && at(w.movers, mover).acceleration == 0);
}

/// Runs one tick.
void run_tick(WorldState& w);

/// Ball i meets a surface now (its state stands for its work's time): gathers everything it touches and resolves impulses.
void respond(WorldState& w, std::size_t i, const Contact& first);
/// A ball that slid along a surface at rest when the last tick ended, and neither left it nor flies off, is in contact from the
/// beginning of this one: it does not fall through the band of tolerance first.
void keep_contact(WorldState& w, std::size_t i);
/// Before a tick: wakes resting balls that one which does not rest touches.
void wake_piles(WorldState& w);
/// Once velocities are those of the tick: settles the contacts of balls that touch each other.
void settle_piles(WorldState& w);
/// After a tick: piles in which nothing moves fall asleep.
void rest_piles(WorldState& w);
/// Ball i does not rest any more, nor do those that rest on it.
void wake(WorldState& w, std::size_t i);
/// Closing speed, m/s, up to which two balls do not bounce.
double slowest_pair_bounce(const WorldState& w, double restitution);
/// Notes an impulse; several on one surface at one instant are one.
void note(WorldState& w, const Impulse& impulse);
/// Adds what weight presses onto a surface, m/s, to what has been noted last of it and this ball.
void press(WorldState& w, BallId ball, const Vec2& normal, double gained);
/// After a tick: makes touches and their events of its impulses.
void tell_touches(WorldState& w);
/// After a tick: looks for balls that have hardly moved for long, tells them, and has what kicks and touches them kick.
void look_for_stuck_balls(WorldState& w);
/// Balls i and j meet.
void respond_to_ball(WorldState& w, std::size_t i, std::size_t j);
/// Notes an impulse between balls i and j: `gained`, m/s, is what they part with more than before.
void note_meeting(WorldState& w, std::size_t i, std::size_t j, double closing, double gained, bool tells);
/// Moves ball i along its path by dt.
void advance_ball(WorldState& w, std::size_t i, double dt);
/// Moves mover m along its motion to `time` of the tick.
void advance_mover(WorldState& w, std::size_t m, double time);
/// Finds the end-stop that mover m will meet.
void plan_stop(WorldState& w, std::size_t m);

/// The part of the ball's free path that movers and sensors leave: distance to the nearest place where they may be.
double room_without_mechanisms(const WorldState& w, const Vec2& centre);

/// Runs the rest of the tick for one ball that meets nothing but the static field. False, with the ball anywhere, when it
/// would travel farther than `limit`.
bool advance_uncoupled(WorldState& w, std::size_t i, double limit);
/// Runs the tick for the balls in w.coupled and all movers, events in order of time.
void advance_coupled(WorldState& w);
/// Puts a waiting ball back where it starts, unless a mover stands there.
void try_put_back(WorldState& w, std::size_t i);
/// One tick of a ball that sits in a solid after an edit: out along the gradient at bounded speed.
void depenetrate(WorldState& w, std::size_t i);

/// One slice of a sweep against the static field from the ball's present place: at most `rest` seconds, less for fast balls.
struct Slice {
    double duration = 0;
    FieldSweep sweep;
};
Slice sweep_slice(WorldState& w, std::size_t i, double rest, double room);

}  // namespace pinfield

// The simulation: balls and movers on a Program, one fixed tick at a time. Same inputs, same bits.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/physics/ball.h"
#include "engine/physics/event.h"
#include "engine/program/program.h"

namespace pinfield {

/// Where a mover is and how it moves: q is an angle in radians, or, of a mover that slides, a distance in metres.
struct MoverState {
    double q = 0, rate = 0, acceleration = 0;
    double q_min = 0, q_max = 0;  ///< end-stops
    double drive_time = 0;        ///< seconds since the drive began: the torque ramp
    bool driven = false;
    double inverse_inertia = 0;   ///< 1/(kg m^2) or 1/kg; 0: kinematic
    double launch_rate = 0;       ///< m/s of a plunger on its way forward
    int rung = 0;                 ///< the end-stop that it met last, if it was not halfway to the other since, nor switched: -1 q_min, 1 q_max
};

/// A touch: from the first impulse between a ball and a surface of a node (or another ball) to the last, rebounds that hardly leave it
/// included. What one hears of it while it lasts: sliding where `slip` is, rolling where only `along` is, as loud as `load` says.
struct BallTouch {
    BallId ball;
    NodeId node;         ///< none: another ball
    BallId other;        ///< the other ball
    int part = -1, material = -1;
    Vec2 normal{0, 0};   ///< unit, towards `ball`, at the last impulse
    double since = 0, last = 0;  ///< of the first and the last impulse, seconds since the world's start
    double off = 0;      ///< m/s along the normal with which the last impulse left it
    double hardest = 0;  ///< approach speed, m/s
    double along = 0;    ///< m/s of the ball's centre along the surface, after the last impulse
    double slip = 0;     ///< m/s of its rim against the surface: 0 while it rolls
    double load = 0;     ///< N: the last tick's impulses over its length
    bool told = false;   ///< there was an event when it began: there is one when it ends
};

/// A stretch of a mover's motion within a tick: q + rate s + acceleration s^2 / 2 for s seconds after `start`.
struct MoverSegment {
    int mover = 0;
    double start = 0, duration = 0;  ///< seconds since the world's start
    double q = 0, rate = 0, acceleration = 0;
    double at(double s) const { return q + rate * s + 0.5 * acceleration * s * s; }
};

struct WorldOptions {
    std::uint64_t seed = 1;
    std::optional<double> restitution;      ///< sets every e; falloff, friction, scatter and kicks become 0
    std::optional<Integrator> integrator;
    std::optional<double> step;             ///< seconds
    bool balls_collide = true;              ///< false: balls ignore each other
    bool sweep = true;                      ///< test hook: without continuous detection balls tunnel, and the auditor must say so
};

/// A straight or parabolic stretch of one ball's path within a tick, for auditors and traces.
struct PathSegment {
    BallId ball;
    double start = 0, duration = 0;  ///< seconds since the world's start
    Vec2 position{0, 0}, velocity{0, 0}, acceleration{0, 0};
    Vec2 at(double t) const { return position + t * velocity + (0.5 * t * t) * acceleration; }
};

/// Counters of the work done, for tests and the status bar.
struct WorldStats {
    std::int64_t sweeps = 0, evaluations = 0, impacts = 0, capped_queries = 0, capped_ticks = 0;
    std::int64_t free_steps = 0;  ///< ball-steps that the free path paid for, without any query
    int most_evaluations = 0;     ///< of one sweep
};

class World {
public:
    World(ProgramPtr program, WorldOptions options = {});
    ~World();
    World(const World&);  ///< a snapshot: it goes on as the original does, bit for bit
    World& operator=(const World&);
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    /// One tick.
    void step();

    /// Input i of Program::inputs is pressed (value > 0) or released from the next tick on. False when that changes nothing, or the
    /// table has no such input.
    bool set_input(int input, double value);
    /// Adds a ball; it starts again here after a drain when put back.
    BallId add_ball(const Vec2& position, const Vec2& velocity, double spin = 0);
    /// Adds one ball per spawn of the table. One that cannot start there is held back like one that is put back.
    void add_spawned_balls();
    /// Puts a drained ball back where it started, or, where it cannot be (start.h) or another ball is, at the start of the first tick in
    /// which it can. An event tells that a ball is held back, and by what; not of movers, which come and go.
    void put_back(BallId ball);
    /// Moves a ball (the editor's throw). Balls that overlap then move apart at bounded speed, without energy.
    void set_ball(BallId ball, const Vec2& position, const Vec2& velocity);

    /// Swaps in an edited program at this step boundary: balls keep rolling, movers keep their state, a ball that now sits in
    /// a solid is moved out along the gradient at bounded speed, without energy. Balls start where their spawns are by now; inputs stay pressed, by their names.
    void set_program(ProgramPtr program);

    const Program& program() const;
    const ProgramPtr& shared_program() const;
    std::int64_t tick() const;
    double step_length() const;  ///< seconds
    double time() const;         ///< tick * step
    bool balls_collide() const;  ///< or ignore each other
    std::span<const Ball> balls() const;
    const Ball* find(BallId ball) const;
    std::span<const MoverState> movers() const;
    /// Events of the last tick, in order; none after a change of the program, whose parts and materials they index.
    std::span<const Event> events() const;
    /// What balls touch, in order of the balls; after a change of the program they begin anew.
    std::span<const BallTouch> touches() const;
    const WorldStats& stats() const;
    /// Kinetic + spin + m g y of one ball, J. Of one that rolls on the playfield without that rolling, and with what it leaves of gravity: what
    /// contact keeps or takes.
    double energy(const Ball& ball) const;
    double energy() const;
    /// Of everything that the future depends on, bit for bit, beside the program and the inputs to come: worlds on one program with
    /// equal hashes stay equal under equal inputs.
    std::uint64_t state_hash() const;

    /// Collect the path segments of each tick (cleared at the next one).
    void record_paths(bool on);
    std::span<const PathSegment> paths() const;
    /// Likewise of the movers, in order of time for each.
    std::span<const MoverSegment> mover_paths() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Distance of a point to all that is solid for a ball now: static field and movers at their present place.
struct Gap {
    double distance = infinity;  ///< signed
    Vec2 gradient{0, 0};
    NodeId node;
    int mover = -1;              ///< index, or -1 for the static field
};
Gap gap_at(const World& world, const Vec2& p, LayerMask layers = ground_layer);
/// The same with every mover where `q` says (one value per mover).
Gap gap_at(const Program& program, std::span<const double> q, const Vec2& p, LayerMask layers = ground_layer,
           double reach = infinity);

}  // namespace pinfield

// A game on a table: a World, and what is agreed about it. `simulate`, `test` and the editor play the same one, so that a hit, a
// drained ball and its return mean the same everywhere.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "engine/physics/world.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// The node in which each node is, in the scene: so that a group knows of the hits of what is in it.
using NodeParents = std::map<NodeId, NodeId>;
NodeParents parents_of(const Scene& scene);

struct GameOptions {
    double seconds_until_back = 1;  ///< that a drained ball stays away (decision 31)
    bool launched_come_back = true; ///< those, too, that did not start at a spawn
};

/// An input changes at the start of this tick.
struct InputChange {
    std::int64_t tick = 0;
    int input = 0;     ///< index into Program::inputs, of the program as it was then
    double value = 0;  ///< > 0: pressed
    bool operator==(const InputChange&) const = default;
};

/// The World decides what moves, by its program alone; the Game what comes of it, at the ends of ticks. Rules and scores, when there
/// are any, run there: after the tick, over its events, with what is counted here.
class Game {
public:
    /// The world brings seed, options and balls; without parents, hits are counted for the nodes that events name, and no others.
    explicit Game(World world, NodeParents parents = {}, GameOptions options = {});

    /// Puts balls back that are due, runs one tick and counts its events.
    void step();
    /// From the next tick on; recorded unless it changes nothing. One that the table does not have is ignored.
    void set_input(int input, double value);
    /// Goes on with an edited program: counters stay, balls come back where their spawns are by then.
    void set_program(ProgramPtr program) { world_.set_program(std::move(program)); }
    /// The same where nodes may have come, gone or moved into others.
    void set_program(ProgramPtr program, NodeParents parents);
    /// Takes balls that an edit has put into something solid out of it: to the nearest free place, or, where there is none within
    /// `reach` metres, to where they start. Returns what each of them was in.
    std::vector<NodeId> free_balls(double reach = 0.25);
    void record_paths(bool on) { world_.record_paths(on); }

    const World& world() const { return world_; }
    const NodeParents& parents() const { return parents_; }

    /// How often balls touched a node or anything in it, fast enough for an event: once a touch, however often the ball bounced in it, and
    /// once for each ball and tick, however many surfaces it met then. Of a drain: how many balls it took.
    std::int64_t hits_of(NodeId node) const;
    std::int64_t bumper_hits() const { return bumper_hits_; }  ///< of all bumpers, of those too that are gone by now
    std::int64_t drained() const { return events_[static_cast<std::size_t>(EventKind::drain)]; }
    /// How many events there were, by EventKind.
    const std::array<std::int64_t, event_kinds>& events() const { return events_; }

    /// Every change of an input since the start, in order. Played again to a fresh game of the same program, seed and options it gives
    /// the same game, as long as the program is not edited.
    const std::vector<InputChange>& input_log() const { return input_log_; }
    /// Of the world, of the balls that are to come back and of what is counted.
    std::uint64_t state_hash() const;

private:
    struct Return {
        std::int64_t tick = 0;  ///< at whose start
        BallId ball;
    };
    struct Touched {
        BallId ball;
        NodeId node;
        bool is_bumper = false;
        auto operator<=>(const Touched&) const = default;
    };

    void put_balls_back();
    void expect_back(BallId ball);
    void count_events();

    World world_;
    NodeParents parents_;
    GameOptions options_;
    std::vector<Return> returns_;
    std::array<std::int64_t, event_kinds> events_{};
    std::map<NodeId, std::int64_t> hits_;
    std::int64_t bumper_hits_ = 0;
    std::vector<InputChange> input_log_;
    std::vector<Touched> touched_;  ///< scratch
};

}  // namespace pinfield

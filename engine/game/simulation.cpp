#include "engine/game/simulation.h"

#include <chrono>
#include <cmath>

#include "engine/core/at.h"
#include "engine/physics/start.h"

namespace pinfield {

namespace {

using Clock = std::chrono::steady_clock;  // for the report only; nothing in the simulation reads it

bool escaped(const Program& program, const Ball& ball, double distance) {
    return distance < -program.physics.ball_radius || (distance < 0 && is_outside(program, ball.position, ball.layer));
}

/// Everything that is judged at the end of a tick.
class Referee {
public:
    Referee(const World& world, SimulationSummary& summary) : summary_(summary), escaped_(world.balls().size(), false) {}

    void after_tick(const World& world) {
        const double r = world.program().physics.ball_radius;
        for (const MoverState& s : world.movers()) q_.push_back(s.q);
        for (std::size_t i = 0; i < world.balls().size(); ++i) {
            const Ball& ball = world.balls()[i];
            if (!is_on_table(ball)) continue;
            const double distance = gap_at(world.program(), q_, ball.position, ball.layer, 2 * r).distance;
            summary_.max_penetration = std::max(summary_.max_penetration, r - distance);
            if (i < escaped_.size() && !escaped_[i] && escaped(world.program(), ball, distance)) {
                escaped_[i] = true;
                ++summary_.escaped;
            }
        }
        summary_.max_overlap = std::max(summary_.max_overlap, overlap_of_balls(world));
        summary_.max_penetration = std::max(summary_.max_penetration, summary_.max_overlap);
        q_.clear();
    }

private:
    SimulationSummary& summary_;
    std::vector<bool> escaped_;
    std::vector<double> q_;
};

}  // namespace

SimulationSummary simulate(Game& game, const SimulationOptions& options) {
    const World& world = game.world();
    SimulationSummary summary;
    summary.ticks = std::llround(options.seconds / world.step_length());
    summary.balls = static_cast<int>(world.balls().size());
    summary.energy_first = world.energy();
    game.record_paths(options.audit);
    const auto before = game.events();
    const WorldStats stats_before = world.stats();
    Auditor auditor;
    Referee referee(world, summary);
    auto input = options.inputs.begin();
    Clock::duration spent{};
    std::int64_t ball_steps = 0;
    for (std::int64_t k = 0; k < summary.ticks; ++k) {
        for (; input != options.inputs.end() && input->tick <= world.tick(); ++input) game.set_input(input->input, input->value);
        const auto start = Clock::now();
        game.step();
        spent += Clock::now() - start;
        ball_steps += static_cast<std::int64_t>(world.balls().size());
        referee.after_tick(world);
        if (options.audit) auditor.after_tick(world);
        if (options.observer) options.observer->after_tick(world);
    }
    for (int kind = 0; kind < event_kinds; ++kind) at(summary.events, kind) = at(game.events(), kind) - at(before, kind);
    summary.drained = at(summary.events, EventKind::drain);
    summary.finite = at(summary.events, EventKind::quarantine) == 0;
    summary.wall_seconds = std::chrono::duration<double>(spent).count();
    summary.ball_steps_per_second = summary.wall_seconds > 0 ? static_cast<double>(ball_steps) / summary.wall_seconds : 0;
    summary.capped_ticks = world.stats().capped_ticks - stats_before.capped_ticks;
    summary.capped_queries = world.stats().capped_queries - stats_before.capped_queries;
    summary.energy_last = world.energy();
    summary.state_hash = world.state_hash();
    if (options.audit) summary.audit = auditor.report();
    game.record_paths(false);
    return summary;
}

}  // namespace pinfield

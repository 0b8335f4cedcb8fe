// A run of a table from start to end with everything counted: what `pinfield simulate` and `pinfield test` print.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/game/game.h"
#include "engine/physics/audit.h"

namespace pinfield {

/// Watches a run: traces, event logs.
class SimulationObserver {
public:
    virtual ~SimulationObserver() = default;
    virtual void after_tick(const World& world) = 0;
};

struct SimulationOptions {
    double seconds = 10;
    bool audit = false;
    std::vector<InputChange> inputs;  ///< in order of ticks
    SimulationObserver* observer = nullptr;
};

struct SimulationSummary {
    std::int64_t ticks = 0;
    int balls = 0;
    double wall_seconds = 0;           ///< of the ticks alone, without checks
    double ball_steps_per_second = 0;
    int escaped = 0;                   ///< balls whose centre left the domain or sat in a solid deeper than their radius
    std::int64_t drained = 0;
    double max_penetration = 0;        ///< metres, of balls into solids and into each other, at the ends of ticks
    double max_overlap = 0;            ///< metres, of two balls alone
    std::int64_t capped_ticks = 0;     ///< times that a ball stood still for the rest of a tick, as it had spent its share of impacts or searches
    std::int64_t capped_queries = 0;   ///< searches for the next contact that ended undecided, and were taken up again
    double energy_first = 0, energy_last = 0;        ///< J, of all balls
    std::array<std::int64_t, event_kinds> events{};  ///< by EventKind
    std::uint64_t state_hash = 0;      ///< of the world
    bool finite = true;                ///< no ball was quarantined
    std::optional<AuditReport> audit;
};

/// Runs round(seconds / step) ticks.
SimulationSummary simulate(Game& game, const SimulationOptions& options);

}  // namespace pinfield

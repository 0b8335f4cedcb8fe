// A run of a table from start to end with everything counted: what `pinfield simulate` and `pinfield test` print.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/physics/audit.h"
#include "engine/physics/world.h"

namespace pinfield {

/// An input changes at the start of this tick.
struct InputChange {
    std::int64_t tick = 0;
    int input = 0;     ///< index into Program::inputs
    double value = 0;  ///< > 0: pressed
};

/// Watches a run: traces, event logs.
class SimulationObserver {
public:
    virtual ~SimulationObserver() = default;
    virtual void after_tick(const World& world) = 0;
};

struct SimulationOptions {
    double seconds = 10;
    double seconds_until_back = 1;    ///< that a drained ball stays away
    bool audit = false;
    std::vector<InputChange> inputs;  ///< in order of ticks
    SimulationObserver* observer = nullptr;
};

inline constexpr int event_kinds = static_cast<int>(EventKind::jam) + 1;

struct SimulationSummary {
    std::int64_t ticks = 0;
    int balls = 0;
    double wall_seconds = 0;           ///< of the ticks alone, without checks
    double ball_steps_per_second = 0;
    int escaped = 0;                   ///< balls whose centre left the domain or sat in a solid deeper than their radius
    std::int64_t drained = 0;
    double max_penetration = 0;        ///< metres, at the ends of ticks
    double energy_first = 0, energy_last = 0;        ///< J, of all balls
    std::array<std::int64_t, event_kinds> events{};  ///< by EventKind
    std::uint64_t state_hash = 0;
    bool finite = true;                ///< no ball was quarantined
    std::optional<AuditReport> audit;
};

/// Runs round(seconds / step) ticks. A drained ball is counted and, after a while, put back where it starts.
SimulationSummary simulate(World& world, const SimulationOptions& options);

}  // namespace pinfield

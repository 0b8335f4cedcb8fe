// How fast the simulation runs: what `pinfield bench` prints of it.
#pragma once
#include "engine/physics/world.h"

namespace pinfield {

struct BenchResult {
    std::int64_t ball_steps = 0;
    double seconds = 0;
    double ball_steps_per_second = 0;
    double evaluations_per_sweep = 0;
    double sweeps_per_step = 0, impacts_per_step = 0;
    double free_share = 0;           ///< of the ball-steps that cost no query
    int most_evaluations = 0;        ///< of one sweep
    double energy_drift = 0;         ///< |last - first| / first, over all balls
};

/// `balls` balls of `speed` that ignore each other, every contact elastic, on one thread for `ticks` ticks of 1 ms after a short
/// warm-up. The clock is steady wall time.
BenchResult bench_simulation(const ProgramPtr& program, int balls, double speed, int ticks, std::uint64_t seed = 777);

}  // namespace pinfield

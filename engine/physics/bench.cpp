#include "engine/physics/bench.h"

#include <chrono>

#include "engine/physics/scatter.h"

namespace pinfield {

BenchResult bench_simulation(const ProgramPtr& program, int balls, double speed, int ticks, std::uint64_t seed) {
    WorldOptions options;
    options.restitution = 1;
    options.integrator = Integrator::ballistic;
    options.step = 1e-3;
    options.balls_collide = false;
    World world(program, options);
    scatter_balls(world, balls, speed, seed);
    constexpr int warm_up = 50;
    for (int i = 0; i < warm_up; ++i) world.step();
    const WorldStats before = world.stats();
    const double energy = world.energy();
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < ticks; ++i) world.step();
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    const WorldStats& after = world.stats();

    BenchResult result;
    result.ball_steps = static_cast<std::int64_t>(world.balls().size()) * ticks;
    result.seconds = spent.count();
    const double steps = static_cast<double>(result.ball_steps), sweeps = static_cast<double>(after.sweeps - before.sweeps);
    result.ball_steps_per_second = steps / result.seconds;
    result.evaluations_per_sweep = sweeps > 0 ? static_cast<double>(after.evaluations - before.evaluations) / sweeps : 0;
    result.sweeps_per_step = sweeps / steps;
    result.impacts_per_step = static_cast<double>(after.impacts - before.impacts) / steps;
    result.free_share = static_cast<double>(after.free_steps - before.free_steps) / steps;
    result.most_evaluations = after.most_evaluations;
    result.energy_drift = std::fabs(world.energy() - energy) / std::fabs(energy);
    return result;
}

}  // namespace pinfield

#include "engine/physics/scatter.h"

#include <algorithm>

#include "engine/core/rng.h"
#include "engine/core/trig.h"
#include "engine/physics/mechanisms/mechanism.h"

namespace pinfield {

int scatter_balls(World& world, int n, double speed, std::uint64_t seed) {
    constexpr double spare = 1e-3;    // metres
    constexpr int most_tries = 1000;  // a ball, before the table counts as full
    constexpr int most_refused = 100; // a ball, before they are let overlap
    const Program& program = world.program();
    const double r = program.physics.ball_radius;
    CounterRng rng(seed, 0x5ca77e2);
    const auto overlaps = [&](const Vec2& p) {
        const auto balls = world.balls();
        return std::any_of(balls.begin(), balls.end(), [&](const Ball& b) { return length(b.position - p) < 2 * r + spare; });
    };
    int placed = 0, refused = 0;
    for (int tries = 0; placed < n && tries < most_tries * n; ++tries) {
        const Vec2 p{rng.in(0, program.size.x()), rng.in(0, program.size.y())};  // braces: the order of evaluation is the written one
        if (gap_at(world, p).distance < r + spare) continue;
        if (std::any_of(program.sensors.begin(), program.sensors.end(), [&](const Sensor& s) { return drains(program, s, p, ground_layer); })) continue;
        if (world.balls_collide() && overlaps(p) && ++refused < most_refused * n) continue;
        const SineCosine direction = sine_cosine(rng.in(0, two_pi));
        world.add_ball(p, speed * Vec2(direction.cosine, direction.sine));
        ++placed;
    }
    return placed;
}

}  // namespace pinfield

// Rings about the ball, the narrowest first; then a bisection back towards the ball.
#include "engine/physics/free_place.h"

#include <algorithm>

#include "engine/core/trig.h"

namespace pinfield {
namespace {

constexpr int directions = 64;
constexpr double rings_per_radius = 6;

bool is_free(const World& world, const Ball& ball, const Vec2& p) {
    const PhysicsRecord& physics = world.program().physics;
    const double r = physics.ball_radius, touch = r + 0.5 * physics.tolerance;
    if (gap_at(world, p, ball.layer).distance < touch) return false;
    const auto meets = [&](const Ball& other) { return other.id != ball.id && is_on_table(other) && share_layer(ball, other) && length(other.position - p) < r + touch; };
    return std::none_of(world.balls().begin(), world.balls().end(), meets);
}

/// The free place of a ring that is deepest in the open, or nothing.
std::optional<Vec2> on_ring(const World& world, const Ball& ball, double radius) {
    std::optional<Vec2> best;
    double most = -infinity;
    for (int i = 0; i < directions; ++i) {
        const SineCosine turn = sine_cosine_degrees(360.0 * i / directions);
        const Vec2 p = ball.position + radius * Vec2(turn.cosine, turn.sine);
        if (!is_free(world, ball, p)) continue;
        const double room = gap_at(world, p, ball.layer).distance;
        if (room > most) most = room, best = p;
    }
    return best;
}

}  // namespace

double overlap_of(const World& world, const Ball& ball) {
    if (!is_on_table(ball)) return 0;
    const PhysicsRecord& physics = world.program().physics;
    const double missing = physics.ball_radius - gap_at(world, ball.position, ball.layer).distance;
    return missing > physics.tolerance ? missing : 0.0;
}

std::optional<Vec2> free_place(const World& world, const Ball& ball, double reach) {
    const double step = world.program().physics.ball_radius / rings_per_radius;
    for (int ring = 1; ring * step <= reach; ++ring) {
        const std::optional<Vec2> found = on_ring(world, ball, ring * step);
        if (!found) continue;
        double blocked = 0, open = 1;  // of the way there
        for (int i = 0; i < 20; ++i) {
            const double middle = 0.5 * (blocked + open);
            (is_free(world, ball, ball.position + middle * (*found - ball.position)) ? open : blocked) = middle;
        }
        return ball.position + open * (*found - ball.position);
    }
    return {};
}

}  // namespace pinfield

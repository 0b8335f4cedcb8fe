// Rings about the place, the narrowest first; then a bisection back towards it.
#include "engine/physics/free_place.h"

#include <algorithm>
#include <functional>

#include "engine/core/trig.h"
#include "engine/physics/start.h"
#include "engine/program/evaluate.h"

namespace pinfield {
namespace {

constexpr int directions = 64;
constexpr double rings_per_radius = 6;

/// Metres to the nearest solid where a ball may be; nothing where it may not.
using Room = std::function<std::optional<double>(const Vec2&)>;

/// The free place of a ring that is deepest in the open, or nothing.
std::optional<Vec2> on_ring(const Room& room_at, const Vec2& centre, double radius) {
    std::optional<Vec2> best;
    double most = -infinity;
    for (int i = 0; i < directions; ++i) {
        const SineCosine turn = sine_cosine_degrees(360.0 * i / directions);
        const Vec2 p = centre + radius * Vec2(turn.cosine, turn.sine);
        const std::optional<double> room = room_at(p);
        if (room && *room > most) most = *room, best = p;
    }
    return best;
}

std::optional<Vec2> nearest_free(const Room& room_at, const Vec2& centre, double ball_radius, double reach) {
    const double step = ball_radius / rings_per_radius;
    for (int ring = 1; ring * step <= reach; ++ring) {
        const std::optional<Vec2> found = on_ring(room_at, centre, ring * step);
        if (!found) continue;
        double blocked = 0, open = 1;  // of the way there
        for (int i = 0; i < 20; ++i) {
            const double middle = 0.5 * (blocked + open);
            (room_at(centre + middle * (*found - centre)) ? open : blocked) = middle;
        }
        return centre + open * (*found - centre);
    }
    return {};
}

}  // namespace

double overlap_of(const World& world, const Ball& ball) {
    if (!is_on_table(ball)) return 0;
    const PhysicsRecord& physics = world.program().physics;
    const double missing = physics.ball_radius - gap_at(world, ball.position, ball.layer).distance;
    return missing > physics.tolerance ? missing : 0.0;
}

std::optional<Vec2> free_place(const World& world, const Ball& ball, double reach) {
    const PhysicsRecord& physics = world.program().physics;
    const double r = physics.ball_radius, touch = r + 0.5 * physics.tolerance;
    const Room room_at = [&](const Vec2& p) -> std::optional<double> {
        const double room = gap_at(world, p, ball.layer).distance;
        if (room < touch) return {};
        const auto meets = [&](const Ball& other) {
            return other.id != ball.id && is_on_table(other) && share_layer(ball, other) && length(other.position - p) < r + touch;
        };
        if (std::any_of(world.balls().begin(), world.balls().end(), meets)) return {};
        return room;
    };
    return nearest_free(room_at, ball.position, r, reach);
}

std::optional<Vec2> free_start(const Program& program, const Vec2& near, LayerMask layers, double reach) {
    const Room room_at = [&](const Vec2& p) -> std::optional<double> {
        if (start_at(program, p, layers).hindrance != Hindrance::none) return {};
        return nearest(program.fixed, p, layers).distance;
    };
    return nearest_free(room_at, near, program.physics.ball_radius, reach);
}

}  // namespace pinfield

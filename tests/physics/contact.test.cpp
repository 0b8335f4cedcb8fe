// Lasting contact: what a ball that rolls, slides or lies on a surface does with its energy.
#include <cstdio>

#include "engine/core/rng.h"
#include "engine/core/trig.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double r = 0.0135;

std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", x);
    return text;
}

std::string point(double x, double y) {
    return "[" + number(x) + ", " + number(y) + "]";
}

/// What the integrator keeps exactly in free flight. Symplectic Euler, v' = v + h g, x' = x + h v', keeps |v|^2 / 2 - g.x + (h/2) g.v:
/// |v'|^2 - |v|^2 = 2 h g.v' - h^2 g^2, and the last term gives back the h^2 g^2. Exact parabolas keep the energy itself.
double kept_energy(const World& world, const Ball& ball, Integrator integrator) {
    const PhysicsRecord& physics = world.program().physics;
    const double lead = integrator == Integrator::symplectic_euler ? 0.5 * world.step_length() * dot(physics.gravity, ball.velocity) : 0.0;
    return world.energy(ball) + physics.ball_mass * lead;
}

/// Corners at n directions from (0.5, 0.5), 12 to 20 cm away.
std::vector<Vec2> random_corners(CounterRng& rng, int n) {
    std::vector<Vec2> corners;
    const double first = rng.in(0, two_pi);
    for (int k = 0; k < n; ++k) {
        const double angle = first + two_pi * k / n, away = rng.in(0.12, 0.2);
        corners.push_back({0.5 + away * std::cos(angle), 0.5 + away * std::sin(angle)});
    }
    return corners;
}

/// The closed curve of quadratic pieces that the corners pull: smooth everywhere.
std::string smooth_path(const std::vector<Vec2>& corners) {
    std::string points;
    const std::size_t n = corners.size();
    for (std::size_t k = 0; k <= n; ++k) {
        const Vec2 middle = 0.5 * (corners[(k + n - 1) % n] + corners[k % n]);
        points += point(middle.x(), middle.y());
        if (k < n) points += ", " + point(corners[k].x(), corners[k].y()) + ", ";
    }
    return "path: {fill: true, thickness: 0, pieces: quadratic, points: [" + points + "]}";
}

/// Lines and arcs in turns, with corners between them.
std::string mixed_path(const std::vector<Vec2>& corners) {
    std::string points = point(corners[0].x(), corners[0].y());
    const std::size_t n = corners.size();
    for (std::size_t k = 0; k < n; ++k) {
        const Vec2 &a = corners[k], &b = corners[(k + 1) % n];
        const Vec2 bulge = 0.5 * (a + b) + 0.1 * perpendicular(a - b);
        if (k % 2) points += ", " + point(bulge.x(), bulge.y());
        points += ", " + point(b.x(), b.y());
    }
    return "path: {fill: true, thickness: 0, pieces: [line, arc], points: [" + points + "]}";
}

std::string polygon(const std::vector<Vec2>& corners) {
    std::string points;
    for (const Vec2& corner : corners) points += (points.empty() ? "" : ", ") + point(corner.x(), corner.y());
    return "polygon: {points: [" + points + "]}";
}

std::string random_outline(CounterRng& rng, int kind) {
    const std::string turn = ", turn: " + number(rng.in(0, 360)) + ", at: [0.5, 0.5]}";
    switch (kind % 6) {
        case 0: return "circle: {radius: " + number(rng.in(0.03, 0.2)) + turn;
        case 1: return "ellipse: {radii: " + point(rng.in(0.1, 0.2), rng.in(0.06, 0.15)) + turn;
        case 2: return "box: {size: " + point(rng.in(0.2, 0.4), rng.in(0.15, 0.3)) + ", round: " + number(rng.in(0.02, 0.07)) + turn;
        case 3: return smooth_path(random_corners(rng, 5));
        case 4: return mixed_path(random_corners(rng, 6));
        default: return polygon(random_corners(rng, 3 + static_cast<int>(rng.in(0, 30))));
    }
}

struct Trial {
    std::string text;
    Integrator integrator = Integrator::symplectic_euler;
    double step = 1e-3;
};

/// A disc or a sphere, that glides or rolls on a playfield that resists or does not.
std::string random_ball(int n) {
    CounterRng rng(static_cast<std::uint64_t>(n), 0xba115ba9e);
    const bool sphere = rng.uniform() < 0.5, rolls = rng.uniform() < 0.5, resists = rng.uniform() < 0.5;
    return "physics: {ball_inertia: " + std::string(sphere ? "sphere" : "disc") + ", ball_rolls: " + (rolls ? "true" : "false") +
           ", rolling_resistance: " + number(resists ? rng.in(0, 0.05) : 0.0) + "}\n";
}

/// A random outline, as a hollow for even numbers and as a bump in a room for odd ones, of some material on some slope, with some ball.
Trial random_trial(int n) {
    CounterRng rng(static_cast<std::uint64_t>(n), 0xc0117ac7);
    Trial trial;
    trial.integrator = n / 2 % 2 ? Integrator::ballistic : Integrator::symplectic_euler;
    trial.step = 1e-4 * std::pow(100.0, rng.uniform());
    const double friction[] = {0, 0, 0.1, 0.5, 100};
    const std::string outline = random_outline(rng, n / 4);
    trial.text = "pinfield: 1\ntable: {size: [1, 1], slope: " + number(rng.in(2, 90)) + "}\n" + random_ball(n) + "materials: {default: {restitution: " +
                 number(rng.in(0, 0.8)) + ", friction: " + number(friction[n / 24 % 5]) + "}}\nscene:\n";
    if (n % 2) trial.text += "  - domain: {children: [box: {size: [1, 1], at: [0.5, 0.5]}]}\n  - " + outline + "\n";
    else trial.text += "  - domain: {children: [" + outline + "]}\n";
    return trial;
}

/// The most by which the kept energy of a ball per mass ever rose above what it had been before, in units of (h g)^2 / 8. A ball that lies
/// still has that much more of it than one whose parabola has its top there; it gains so much at most, and once, when it comes to lie.
double most_gained(int n, double seconds) {
    const Trial trial = random_trial(n);
    WorldOptions options;
    options.integrator = trial.integrator;
    options.step = trial.step;
    World world(program_of(trial.text), options);
    CounterRng rng(static_cast<std::uint64_t>(n), 0xba11);
    Vec2 start(0.5, 0.5);
    for (int tries = 0; tries < 1000; ++tries) {
        start = n % 2 ? Vec2(0.5 + rng.in(-0.1, 0.1), 0.5 + rng.in(0, 0.25)) : Vec2(0.5 + rng.in(-0.2, 0.2), 0.5 + rng.in(-0.2, 0.2));
        const double gap = gap_at(world, start).distance - r;
        if (gap > 0 && gap < 0.02) break;
    }
    world.add_ball(start, 0.3 * Vec2(rng.in(-1, 1), rng.in(-1, 1)), rng.in(-20, 20));
    const double mass = world.program().physics.ball_mass, g = length(world.program().physics.gravity);
    double least = kept_energy(world, world.balls()[0], trial.integrator), gained = 0;
    const auto ticks = static_cast<int>(seconds / trial.step);
    for (int t = 0; t < ticks; ++t) {
        world.step();
        const double now = kept_energy(world, world.balls()[0], trial.integrator);
        gained = std::max(gained, now - least);
        least = std::min(least, now);
    }
    CHECK(gap_at(world, world.balls()[0].position).distance - r > -1e-9);
    const double rounding = 1e-11 * mass * g;  // of heights of a metre, over a million ticks
    return (gained - rounding) / (mass * trial.step * trial.step * g * g / 8);
}

void check_law(int first, int count, double seconds) {
    for (int n = first; n < first + count; ++n) {
        INFO("table " << n << '\n' << random_trial(n).text << "step " << random_trial(n).step);
        CHECK(most_gained(n, seconds) <= 1);
    }
}

}  // namespace

// A disc that rolls has half as much again of inertia: T = 2 pi sqrt(1.5 R / g) for small swings, R from the hollow's centre to the ball's.
TEST_CASE("a slow ball in a hollow is a pendulum: it turns in time and never climbs above its start") {
    for (const Integrator integrator : {Integrator::symplectic_euler, Integrator::ballistic})
        for (const bool smooth : {false, true}) {
            const double height = 0.5 - std::sqrt(0.2365 * 0.2365 - 0.01 * 0.01);
            WorldOptions options;
            options.integrator = integrator;
            World world(program_of("pinfield: 1\ntable: {size: [0.52, 1.06], slope: 6.5}\nmaterials: {default: {friction: " +
                                   std::string(smooth ? "0" : "0.3") +
                                   "}}\nscene:\n  - domain: {children: [circle: {at: [0.26, 0.5], radius: 0.25}]}\n"),
                        options);
            world.add_ball({0.27, height + 1e-7}, {0, 0});
            const double g = -world.program().physics.gravity.y();
            const double half = pi * std::sqrt((smooth ? 1.0 : 1.5) * 0.2365 / g), top = world.balls()[0].position.y() + g * 1e-6 / 8;
            int turns = 0;
            double before = 0, first = 0, last = 0, highest = 0;
            while (world.time() < 60) {
                world.step();
                const double v = world.balls()[0].velocity.x();
                highest = std::max(highest, world.balls()[0].position.y());
                if (v * before < 0) {
                    if (turns++ == 0) first = world.time();
                    last = world.time();
                }
                if (v != 0) before = v;
            }
            INFO("integrator " << static_cast<int>(integrator) << ", smooth " << smooth);
            CHECK(highest <= top);
            REQUIRE(turns > 10);
            CHECK((last - first) / (turns - 1) == Approx(half).epsilon(0.002));
            CHECK(world.energy() > 0.08 * g * (0.5 - 0.2365));
        }
}

TEST_CASE("the energy of a ball never grows in contact with fifty random outlines") {
    check_law(0, 50, 3);
}

TEST_CASE("the energy of a ball never grows in contact with a thousand random outlines", "[slow]") {
    check_law(50, 1000, 5);
}

// Along a plane at angle a a disc that rolls gathers 2/3 of g sin a, one that slides g (sin a - mu cos a); Coulomb's law divides them at
// mu = tan(a) / 3.
TEST_CASE("a disc on an incline rolls or slides as its friction says, with both integrators") {
    for (const Integrator integrator : {Integrator::symplectic_euler, Integrator::ballistic})
        for (const double friction : {0.0, 0.05, 0.1, 0.13, 1.0}) {
            WorldOptions options;
            options.integrator = integrator;
            World world(program_of("pinfield: 1\ntable: {size: [4, 4], slope: 30}\nmaterials: {default: {restitution: 0, friction: " +
                                   number(friction) + "}}\nscene:\n  - half_plane: {at: [2, 2], turn: 20}\n"),
                        options);
            const double a = radians(20), g = -world.program().physics.gravity.y();
            world.add_ball(Vec2(2, 2) + (r + 1e-7) * Vec2(-std::sin(a), std::cos(a)), {0, 0});
            const int ticks = 800;
            for (int i = 0; i < ticks; ++i) world.step();
            const double rolls = g * std::sin(a) * 2 / 3, slides = g * (std::sin(a) - friction * std::cos(a));
            const Ball& ball = world.balls()[0];
            INFO("integrator " << static_cast<int>(integrator) << ", friction " << friction);
            CHECK(length(ball.velocity) / (ticks * 1e-3) == Approx(std::max(rolls, slides)).epsilon(2e-3));
            if (rolls > slides) CHECK(r * std::fabs(ball.spin) == Approx(length(ball.velocity)).epsilon(1e-6));
        }
}

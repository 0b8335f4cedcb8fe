// Free flight against the closed forms of mechanics.
#include "engine/core/trig.h"
#include "tests/physics/support.h"

using namespace pinfield;
using namespace pinfield::physics_test;

namespace {

constexpr double g = 9.81;

ProgramPtr open_space(const std::string& integrator, const std::string& step = "1ms") {
    return program_of("pinfield: 1\ntable: {size: [40, 40], slope: 90}\nphysics: {integrator: " + integrator + ", step: " + step +
                      "}\nscene: []\n");
}

/// Position after n ticks of a ball thrown from the middle.
Vec2 thrown(const ProgramPtr& program, const Vec2& velocity, int ticks) {
    World world(program);
    world.add_ball({20, 20}, velocity);
    for (int i = 0; i < ticks; ++i) world.step();
    return world.balls()[0].position - Vec2(20, 20);
}

}  // namespace

// Range v^2 sin(2a) / g, height v^2 sin(a)^2 / (2g), time 2 v sin(a) / g; at any time the parabola itself (Galilei).
TEST_CASE("a ballistic projectile has the range, the height and the time of the parabola") {
    const double speed = 12, angle = radians(50);
    const Vec2 v(speed * std::cos(angle), speed * std::sin(angle));
    for (const int ticks : {1, 700, 937, 1400}) {
        const double t = ticks * 1e-3;
        const Vec2 p = thrown(open_space("ballistic"), v, ticks);
        CHECK(relative_error(p.x(), v.x() * t) < 1e-9);
        CHECK(std::fabs(p.y() - (v.y() * t - 0.5 * g * t * t)) < 1e-9 * v.y() * t);
    }
    // Tick length chosen so that the flight is a whole number of ticks: back at the height of the start.
    const double flight = 2 * v.y() / g;
    WorldOptions options;
    options.step = flight / 1024;
    World world(open_space("ballistic"), options);
    world.add_ball({20, 20}, v);
    double top = 0;
    for (int i = 0; i < 1024; ++i) {
        world.step();
        top = std::max(top, world.balls()[0].position.y() - 20);
    }
    CHECK(relative_error(world.balls()[0].position.x() - 20, speed * speed * std::sin(2 * angle) / g) < 1e-9);
    CHECK(std::fabs(world.balls()[0].position.y() - 20) < 1e-9);
    CHECK(relative_error(top, v.y() * v.y() / (2 * g)) < 1e-9);
}

// y_n = y0 + v0 n h - g h^2 n (n + 1) / 2, summed by hand from v_n = v0 - g h n.
TEST_CASE("symplectic Euler takes exactly its own closed form") {
    const double h = 1e-3;
    for (const int n : {1, 10, 1000}) {
        const Vec2 p = thrown(open_space("symplectic_euler"), {1, 4}, n);
        CHECK(std::fabs(p.y() - (4 * n * h - g * h * h * n * (n + 1.0) / 2)) < 1e-9);
        const double exact = 4 * n * h - 0.5 * g * n * h * n * h;
        CHECK(std::fabs(p.y() - exact) <= 2 * g * h * (n * h));
    }
}

// The global error of symplectic Euler is g h t / 2: halving the step halves it.
TEST_CASE("symplectic Euler converges with order one, the ballistic integrator is exact at every step") {
    const double exact = 3.0 - 0.5 * g;
    double before = 0;
    for (const int n : {125, 250, 500, 1000, 2000}) {
        WorldOptions options;
        options.step = 1.0 / n;
        World world(open_space("symplectic_euler"), options), ballistic(open_space("ballistic"), options);
        for (World* w : {&world, &ballistic}) {
            w->add_ball({20, 20}, {0, 3});
            for (int i = 0; i < n; ++i) w->step();
        }
        const double error = std::fabs(world.balls()[0].position.y() - 20 - exact);
        if (before > 0) CHECK(std::log2(before / error) == Approx(1).margin(0.1));
        before = error;
        CHECK(std::fabs(ballistic.balls()[0].position.y() - 20 - exact) < 1e-9);
    }
}

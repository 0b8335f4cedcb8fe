// Walls along curves, against a scan of the curve and against shapes that are known from elsewhere.
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>

#include "engine/sdf/nodes/arc.h"
#include "engine/sdf/nodes/circle_wave.h"
#include "engine/sdf/nodes/cubic_bezier.h"
#include "engine/sdf/nodes/quadratic_bezier.h"
#include "engine/sdf/nodes/segment.h"
#include "engine/sdf/nodes/spiral.h"
#include "tests/sdf/support.h"

namespace pinfield::sdf {
namespace {

const double full_turn = 6.283185307179586;

/// Least distance from p to at(0) ... at(1) by scanning and then halving about every local minimum of the scan, first coarsely over all
/// of the curve and then finely about the nearest place found: slow, plain, good to 1e-15.
template <class At, class Velocity>
double distance_by_scan(const Vec2& p, const At& at, const Velocity& velocity, int n, double from = 0, double to = 1) {
    double best = std::min(length(at(from) - p), length(at(to) - p)), nearest = from;
    const auto slope_at = [&](double t) { return pinfield::dot(Vec2(at(t) - p), velocity(t)); };
    double slope = slope_at(from);
    for (int i = 0; i < n; ++i) {
        double low = from + (to - from) * i / n, high = from + (to - from) * (i + 1) / n;
        if (length(at(high) - p) < length(at(nearest) - p)) nearest = high;
        const double next = slope_at(high);
        if (slope <= 0 && next >= 0) {
            for (int step = 0; step < 60; ++step) {
                const double middle = 0.5 * (low + high);
                (slope_at(middle) < 0 ? low : high) = middle;
            }
            best = std::min(best, length(at(0.5 * (low + high)) - p));
        }
        slope = next;
    }
    if (to - from < 1) return best;
    return std::min(best, distance_by_scan(p, at, velocity, n, std::max(nearest - 1.0 / n, 0.0), std::min(nearest + 1.0 / n, 1.0)));
}

Point<double> random_point(CounterRng& rng, double half) {
    const double x = rng.in(-half, half);
    return {x, rng.in(-half, half)};
}

/// Random points, and some centres of curvature, where feet are born: the hardest places for a search.
template <class At, class Velocity>
std::vector<Vec2> hard_points(const At& at, const Velocity& velocity) {
    std::vector<Vec2> out = points_within(0.2, 60);
    for (int i = 0; i <= 12; ++i) {
        const double t = i / 12.0, h = 1e-4;
        const Vec2 v = velocity(t), w = (velocity(t + h) - velocity(t - h)) / (2 * h);
        const double turn = pinfield::cross(v, w);
        out.push_back(at(t));
        if (std::fabs(turn) > 1e-6) out.emplace_back(at(t) + pinfield::dot(v, v) / turn * perpendicular(v));
    }
    return out;
}

template <class Wall>
double worst_of_bezier(const Wall& wall) {
    const auto at = [&](double t) { return wall.point_at(t); };
    const auto velocity = [&](double t) { return wall.velocity_at(t); };
    double worst = 0;
    for (const Vec2& p : hard_points(at, velocity)) {
        const double truth = distance_by_scan(p, at, velocity, 500) - 0.5 * wall.thickness;
        const double error = std::fabs(wall.distance({p.x(), p.y()}) - truth) / std::max(0.1, length(p));
        if (error > 1e-12) UNSCOPED_INFO(fmt::format("at {} {}: {} for {}", p.x(), p.y(), wall.distance({p.x(), p.y()}), truth));
        worst = std::max(worst, error);
    }
    return worst;
}

template <class A, class B>
double largest_difference(const A& a, const B& b, double half) {
    double worst = 0;
    for (const Vec2& p : points_within(half))
        worst = std::max(worst, std::fabs(a.distance({p.x(), p.y()}) - b.distance({p.x(), p.y()})));
    return worst;
}

}  // namespace

TEST_CASE("a quadratic Bezier wall is exact to twelve digits wherever the control points lie") {
    CounterRng rng(21);
    for (int i = 0; i < 60; ++i) {
        QuadraticBezier<double> wall{.thickness = 0.01};
        wall.a = random_point(rng, 0.1);
        wall.b = random_point(rng, 0.1);
        wall.c = i % 4 == 0 ? Point<double>{wall.a.x + 1e-3 * rng.in(-1, 1), wall.a.y} : random_point(rng, 0.1);
        if (i % 5 == 0) wall.b = (wall.a + wall.c) * 0.5 + random_point(rng, std::pow(10.0, -2.0 - i % 12));  // nearly straight
        INFO(fmt::format("{} {}, {} {}, {} {}", wall.a.x, wall.a.y, wall.b.x, wall.b.y, wall.c.x, wall.c.y));
        CHECK(worst_of_bezier(wall) < 1e-12);
    }
}

TEST_CASE("a quadratic Bezier wall without a bend is a segment, also when it runs back over itself") {
    const Point<double> a{-0.04, -0.02}, b{0.04, 0.02};
    const auto segment = ready(Segment<double>{.a = a, .b = b, .thickness = 0.01});
    CHECK(largest_difference(QuadraticBezier<double>{a, {0, 0}, b, 0.01}, segment, 0.2) < 1e-15);
    CHECK(largest_difference(QuadraticBezier<double>{a, {0.02, 0.01}, b, 0.01}, segment, 0.2) < 1e-15);
    CHECK(largest_difference(QuadraticBezier<double>{a, a, b, 0.01}, segment, 0.2) < 1e-15);
    CHECK(largest_difference(QuadraticBezier<double>{a, b, b, 0.01}, segment, 0.2) < 1e-15);
    const QuadraticBezier<double> back{a, {0.12, 0.06}, a, 0.01};  // turns round halfway to its control point
    CHECK(largest_difference(back, segment, 0.2) < 1e-9);          // where it turns its foot is known to half the digits only
    const QuadraticBezier<double> dot{a, a, a, 0.01};
    for (const Vec2& p : points_within(0.2))
        CHECK(dot.distance({p.x(), p.y()}) == Approx(length(p - Vec2(a.x, a.y)) - 0.005).margin(1e-16));
}

TEST_CASE("a cubic Bezier wall is exact to twelve digits wherever the control points lie") {
    CounterRng rng(22);
    for (int i = 0; i < 80; ++i) {
        CubicBezier<double> wall{.thickness = 0.01};
        wall.a = random_point(rng, 0.1);
        wall.b = random_point(rng, 0.1);
        wall.c = random_point(rng, 0.1);
        wall.d = i % 4 == 0 ? wall.a : random_point(rng, 0.1);
        if (i % 7 == 0) wall.b = wall.a;
        if (i % 28 == 0) wall.d = random_point(rng, 0.1);
        INFO(fmt::format("{} {}, {} {}, {} {}, {} {}", wall.a.x, wall.a.y, wall.b.x, wall.b.y, wall.c.x, wall.c.y, wall.d.x, wall.d.y));
        CHECK(worst_of_bezier(wall) < 1e-12);
    }
}

TEST_CASE("a cubic Bezier wall raised from a quadratic or a straight one is that wall") {
    CounterRng rng(23);
    for (int i = 0; i < 20; ++i) {
        const Point<double> a = random_point(rng, 0.1), b = random_point(rng, 0.1), c = random_point(rng, 0.1);
        const auto third = [](const Point<double>& near, const Point<double>& far) { return (near + far * 2.0) * (1.0 / 3); };
        const CubicBezier<double> raised{a, third(a, b), third(c, b), c, 0.01};
        CHECK(largest_difference(raised, QuadraticBezier<double>{a, b, c, 0.01}, 0.2) < 1e-13);
        const CubicBezier<double> straight{a, third(c, a), third(a, c), c, 0.01};
        CHECK(largest_difference(straight, ready(Segment<double>{.a = a, .b = c, .thickness = 0.01}), 0.2) < 1e-13);
    }
    const Point<double> a{0.01, 0.02};
    const CubicBezier<double> back{a, a, {-0.08, 0.05}, a, 0.01};  // turns round four ninths of the way to its third control point
    const auto segment = ready(Segment<double>{.a = a, .b = {0.01 - 0.04, 0.02 + 0.04 / 3}, .thickness = 0.01});
    CHECK(largest_difference(back, segment, 0.2) < 1e-8);
    const CubicBezier<double> dot{a, a, a, a, 0.01};
    CHECK(dot.distance({0.04, 0.06}) == Approx(0.045));
}

TEST_CASE("a cubic Bezier wall with a cusp or a loop is exact outside and as a middle line") {
    const CubicBezier<double> cusp{{-0.05, 0}, {0.05, 0.06}, {-0.05, 0.06}, {0.05, 0}, 0.01},
        loop{{-0.05, 0}, {0.1, 0.06}, {-0.1, 0.06}, {0.05, 0}, 0.01};
    CHECK(cusp.velocity_at(0.5).norm() < 1e-15);
    CHECK(worst_of_bezier(cusp) < 1e-12);
    CHECK(worst_of_bezier(loop) < 1e-12);
    CHECK(cusp.exactness().inside == Side::bound);
    CHECK(loop.exactness().inside == Side::bound);
}

TEST_CASE("a wall along a curve is exact inside until it fills its bend") {
    const auto arch = [](double thickness) {
        return QuadraticBezier<double>{{-0.06, 0}, {0, 0.06}, {0.06, 0}, thickness}.exactness().inside;
    };
    // Radius of curvature on its top: |B'|^3 / |B' x B''| = 0.12^3 / (0.12 * 0.24) = 0.06.
    CHECK(arch(0.11) == Side::exact);
    CHECK(arch(0.121) == Side::bound);
    const auto hairpin = [](double thickness) {
        return QuadraticBezier<double>{{-0.01, 0}, {0, 0.4}, {0.01, 0}, thickness}.exactness().inside;
    };
    CHECK(hairpin(0.0004) == Side::exact);
    CHECK(hairpin(0.0006) == Side::bound);  // 0.02^2 / 0.8 = 0.0005
    const auto snake = [](double thickness) {
        return CubicBezier<double>{{-0.06, -0.03}, {-0.03, 0.09}, {0.03, -0.09}, {0.06, 0.03}, thickness}.exactness().inside;
    };
    CHECK(snake(0.02) == Side::exact);
    CHECK(snake(0.08) == Side::bound);
}

TEST_CASE("a circle wave of one arc is an arc, of more the union of its arcs") {
    for (const double angle : {30.0, 90.0, 180.0, 220.0, 300.0})
        for (const int count : {1, 2, 3, 8}) {
            const auto wave = ready(CircleWave<double>{.radius = 0.02, .angle = angle, .count = count, .thickness = 0.006});
            const auto up = ready(Arc<double>{.radius = 0.02, .from = 90 - angle / 2, .to = 90 + angle / 2, .thickness = 0.006});
            const double half = angle * full_turn / 720, chord = 0.04 * std::sin(half), lift = 0.02 * std::cos(half);
            for (const Vec2& p : points_within(0.3, 100)) {
                double truth = infinity;
                for (int i = 0; i < count; ++i) {
                    const double side = i % 2 == 0 ? 1 : -1, x = p.x() - (i - 0.5 * (count - 1)) * chord;
                    truth = std::min(truth, up.distance({x, side * p.y() + lift}));
                }
                CHECK(wave.distance({p.x(), p.y()}) == Approx(truth).margin(1e-14));
            }
        }
}

TEST_CASE("the arcs of a circle wave join without a corner on the local x axis") {
    const auto wave = ready(CircleWave<double>{.radius = 0.02, .angle = 140, .count = 4, .thickness = 0.01});
    Outline pieces;
    wave.outline(pieces);
    REQUIRE(pieces.size() == 10);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece &piece = pieces[i], &next = pieces[(i + 1) % pieces.size()];
        CHECK(length(piece.b - next.a) < 1e-16);
        const Vec2 arriving = piece.turn * perpendicular(Vec2(piece.b - piece.centre)) / piece.radius;
        const Vec2 leaving = next.turn * perpendicular(Vec2(next.a - next.centre)) / next.radius;
        CHECK(length(arriving - leaving) < 1e-12);
    }
    for (int i = 0; i <= 4; ++i) CHECK(wave.distance({wave.joint(i).x(), 0}) == Approx(-0.005).margin(1e-15));
    CHECK(wave.exactness().inside == Side::exact);
    CHECK(ready(CircleWave<double>{.radius = 0.02, .angle = 280, .count = 3, .thickness = 0.02}).exactness().inside == Side::bound);
}

TEST_CASE("a spiral is exact to twelve digits, tight or wide, from its centre or a ring, for a tenth of a turn or twelve turns") {
    for (const auto& [radius, pitch, turns] : {std::tuple(0.015, 0.018, 2.25),
                                               {0.0, 0.02, 3.0},
                                               {0.001, 0.05, 1.3},
                                               {0.05, 0.001, 12.0},
                                               {0.03, 0.1, 0.1},
                                               {0.002, 0.3, 0.5},
                                               {0.02, 0.02, 0.9},
                                               {0.0, 0.008, 12.0},
                                               {0.01, 0.06, 1.0}}) {
        const auto wall = ready(Spiral<double>{.radius = radius, .pitch = pitch, .turns = turns, .thickness = 0.001});
        const double total = full_turn * turns, b = pitch / full_turn, r0 = radius;
        const auto at = [&](double t) { return Vec2((r0 + b * t * total) * Vec2(std::cos(t * total), std::sin(t * total))); };
        const auto velocity = [&](double t) {
            const double angle = t * total, r = r0 + b * angle;
            return Vec2(total * Vec2(b * std::cos(angle) - r * std::sin(angle), b * std::sin(angle) + r * std::cos(angle)));
        };
        const double extent = radius + pitch * turns;
        std::vector<Vec2> points = hard_points(at, velocity);
        for (const Vec2& p : points_within(2 * extent, 150)) points.push_back(p);
        for (const Vec2& p : points_within(2 * b, 150)) points.push_back(p);
        double worst = 0;
        for (const Vec2& p : points) {
            const double truth = distance_by_scan(p, at, velocity, 3000) - 0.0005;
            const double error = std::fabs(wall.distance({p.x(), p.y()}) - truth) / std::max(extent, length(p));
            if (error > 1e-12) UNSCOPED_INFO(fmt::format("at {} {}: {} for {}", p.x(), p.y(), wall.distance({p.x(), p.y()}), truth));
            worst = std::max(worst, error);
        }
        INFO(radius << " " << pitch << " " << turns);
        CHECK(worst < 1e-12);
    }
}

TEST_CASE("a spiral's turns are a pitch apart along every ray, its ends are round") {
    const auto wall = ready(Spiral<double>{.radius = 0.02, .pitch = 0.01, .turns = 3, .thickness = 0.004});
    for (int turn = 0; turn <= 3; ++turn) CHECK(wall.distance({0.02 + 0.01 * turn, 0}) == Approx(-0.002).margin(1e-15));
    CHECK(wall.distance({0, 0}) == Approx(0.018));
    CHECK(wall.distance({0.02, -0.003}) == Approx(0.001));
    CHECK(wall.exactness().inside == Side::exact);
    CHECK(ready(Spiral<double>{.radius = 0.02, .pitch = 0.01, .turns = 3, .thickness = 0.0101}).exactness().inside == Side::bound);
}

TEST_CASE("the angle of a vector is the arc tangent's, on all sides of every axis and diagonal") {
    for (const Vec2& p : points_within(1)) {
        const double expected = std::atan2(p.y(), p.x());
        CHECK(angle_of(Point<double>{p.x(), p.y()}) == Approx(expected < 0 ? expected + full_turn : expected).margin(1e-15).epsilon(1e-15));
    }
    CHECK(angle_of(Point<double>{0, 0}) == 0);
}

}  // namespace pinfield::sdf

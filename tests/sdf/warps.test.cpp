// Operations that move the point they ask their child about.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "engine/core/trig.h"
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/capsule.h"
#include "engine/sdf/operations/bend.h"
#include "engine/sdf/operations/displace.h"
#include "engine/sdf/operations/elongate.h"
#include "engine/sdf/operations/stretch.h"
#include "engine/sdf/operations/twist.h"
#include "tests/sdf/support.h"

namespace pinfield::sdf {
namespace {

template <class W>
Vec2 sent(const W& warp, const Vec2& p) {
    const Point<double> q = warp.warp({p.x(), p.y()});
    return {q.x, q.y};
}

/// Larger singular value of the warp's derivative at p, by differences.
template <class W>
double stretch_at(const W& warp, const Vec2& p) {
    const double h = 1e-7;
    const Vec2 x = (sent(warp, p + Vec2(h, 0)) - sent(warp, p - Vec2(h, 0))) / (2 * h);
    const Vec2 y = (sent(warp, p + Vec2(0, h)) - sent(warp, p - Vec2(0, h))) / (2 * h);
    const double xx = pinfield::dot(x, x), yy = pinfield::dot(y, y), xy = pinfield::dot(x, y);
    return std::sqrt(0.5 * (xx + yy + std::hypot(xx - yy, 2 * xy)));
}

template <class W>
double greatest_stretch(const W& warp, double half) {
    double greatest = 0;
    for (const Vec2& p : points_within(half)) greatest = std::max(greatest, stretch_at(warp, p));
    return greatest;
}

}  // namespace

TEST_CASE("the sine by turns is the sine") {
    for (int i = -4000; i <= 4000; ++i) {
        const double turns = i / 1000.0;
        CHECK(std::fabs(sine_of_turns(turns) - std::sin(two_pi * (turns - std::nearbyint(turns)))) < 4e-16);
        CHECK(std::fabs(cosine_of_turns(turns) - std::cos(two_pi * (turns - std::nearbyint(turns)))) < 1e-15);
    }
    for (int quarter = -8; quarter <= 8; ++quarter) CHECK(std::fabs(sine_of_turns(0.25 * quarter)) == (quarter % 2 ? 1.0 : 0.0));
}

TEST_CASE("a disc pulled apart along x is a capsule, along both axes and filled a rounded box, both exact") {
    const double r = 0.02;
    const Elongate<double> along{{0.06, 0}, true}, both_ways{{0.06, 0.03}, true};
    const Capsule<double> capsule{0.06, r};
    const Box<double> box{{0.06 + 2 * r, 0.03 + 2 * r}, r};
    for (const Vec2& p : points_within(0.1)) {
        CHECK(pinfield::length(sent(along, p)) - r == Approx(capsule.distance({p.x(), p.y()})).margin(1e-16));
        const double filled = pinfield::length(sent(both_ways, p)) - r + both_ways.lift({p.x(), p.y()});
        CHECK(filled == Approx(box.distance({p.x(), p.y()})).margin(1e-16));
    }
}

TEST_CASE("a stretch by the same factor both ways is a scale") {
    const Stretch<double> twice{{2, 2}};
    for (const Vec2& p : points_within(0.1)) CHECK(sent(twice, p) == 0.5 * p);
    CHECK(twice.factor() == 2);
    CHECK(twice.exactness(std::array{Exactness{}}) == Exactness{});
    CHECK(Stretch<double>{{2, 1}}.exactness(std::array{Exactness{}}) == Exactness{Side::bound, Side::bound, 1});
}

TEST_CASE("a twist keeps every distance from its middle, turns that by its angle, and leaves alone what lies beyond its radius") {
    for (const double angle : {-300.0, 45.0, 720.0}) {
        const Twist<double> twist{angle, 0.08};
        for (const Vec2& p : points_within(0.2)) {
            const Vec2 q = sent(twist, p);
            CHECK(pinfield::length(q) == Approx(pinfield::length(p)).margin(1e-16));
            if (pinfield::length(p) >= 0.08) CHECK(q == p);
        }
        // The child is asked where the point was before it was turned.
        const Vec2 q = sent(twist, {1e-6, 0});
        const SineCosine back = sine_cosine_degrees(-angle);
        CHECK(pinfield::length(q - 1e-6 * Vec2(back.cosine, back.sine)) < 1e-14);
    }
}

TEST_CASE("a bend lifts the ends of its length by its sag and goes on straight") {
    const Bend<double> bend{.sag = 0.03, .length = 0.2};
    for (const double y : {-0.1, 0.0, 0.4}) {
        CHECK(sent(bend, {0, y}) == Vec2(0, y));
        CHECK(sent(bend, {0.1, y}).y() == Approx(y - 0.03));
        CHECK(sent(bend, {-0.1, y}).y() == Approx(y - 0.03));
        CHECK(sent(bend, {0.05, y}).y() == Approx(y - 0.0075));
        const double slope = 4 * 0.03 / 0.2;
        CHECK(sent(bend, {0.3, y}).y() == Approx(y - 0.03 - 0.2 * slope));
    }
}

TEST_CASE("a warp's factor undoes the most it stretches, and hardly more") {
    const auto check = [](const auto& warp, double half, double slack) {
        const double most = greatest_stretch(warp, half), allowed = 1 / warp.factor();
        INFO(most << " of " << allowed);
        CHECK(most <= allowed * (1 + 1e-6));
        CHECK(most >= allowed * (1 - slack));
    };
    for (const double angle : {-300.0, 20.0, 90.0, 720.0}) check(Twist<double>{angle, 0.08}, 0.08, 0.01);
    for (const double sag : {-0.2, -0.01, 0.05, 0.2}) check(Bend<double>{.sag = sag, .length = 0.2}, 0.2, 1e-6);
    check(Stretch<double>{{0.5, 3}}, 0.1, 1e-6);
}

TEST_CASE("waves are as high as their amplitude times the factor, and vanish every half wavelength") {
    const auto waves = ready(Displace<double>{.amplitude = 0.004, .wavelength = {0.02, 0.05}});
    CHECK(waves.lift({0.005, 0.0125}) == Approx(0.004 * waves.factor()));
    CHECK(waves.lift({0.015, 0.0125}) == Approx(-0.004 * waves.factor()));
    for (int i = -5; i <= 5; ++i) CHECK(std::fabs(waves.lift({0.01 * i, 0.013})) < 1e-17);
}

}  // namespace pinfield::sdf

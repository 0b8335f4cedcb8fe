#include "engine/core/trig.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/core/hash.h"
#include "engine/core/rng.h"

using namespace pinfield;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr long double pi_long = 3.14159265358979323846264338327950288L;

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// Distance from the true value in units of the last place of the double next to it.
double ulps(double value, long double truth) {
    const double nearest = std::fabs(static_cast<double>(truth));
    const double unit = std::nextafter(nearest, inf) - nearest;
    return static_cast<double>(std::fabs(static_cast<long double>(value) - truth) / static_cast<long double>(unit));
}

struct Worst {
    double error = 0, at = 0;
    void see(double x, double value, long double truth) {
        const double e = ulps(value, truth);
        if (!(e <= error)) *this = {e, x};
    }
};

/// Angles of every size up to 1e6, and the neighbourhoods of multiples of pi/4, where reductions go wrong.
template <class Check>
void for_angles(Check check) {
    CounterRng rng(1);
    for (int i = 0; i < 200000; ++i) check(rng.in(-1, 1) * std::pow(10, rng.in(-8, 6)));
    for (int i = 0; i < 20000; ++i) {
        const double multiple = std::floor(rng.in(0, 1.2e6)) * (pi / 4);
        check(multiple);
        check(std::nextafter(multiple, inf));
        check(std::nextafter(multiple, -inf));
        check(multiple + rng.in(-1e-7, 1e-7));
    }
}

}  // namespace

TEST_CASE("sine and cosine are within one unit in the last place up to a million radians") {
    Worst s, c;
    for_angles([&](double x) {
        s.see(x, sine(x), std::sin(static_cast<long double>(x)));
        c.see(x, cosine(x), std::cos(static_cast<long double>(x)));
    });
    CAPTURE(s.at, c.at);
    CHECK(s.error < 1);
    CHECK(c.error < 1);
}

TEST_CASE("tangent is within two and a half units in the last place") {
    Worst t;
    for_angles([&](double x) { t.see(x, tangent(x), std::tan(static_cast<long double>(x))); });
    CAPTURE(t.at);
    CHECK(t.error < 2.5);
}

TEST_CASE("far beyond a million radians sine and cosine still lie on the circle") {
    CounterRng rng(2);
    for (int i = 0; i < 10000; ++i) {
        const SineCosine pair = sine_cosine(std::pow(10, rng.in(6, 308)));
        REQUIRE(std::fabs(pair.sine * pair.sine + pair.cosine * pair.cosine - 1) < 1e-15);
    }
    CHECK(std::isnan(sine(inf)));
    CHECK(std::isnan(cosine(-inf)));
    CHECK(std::isnan(sine(std::nan(""))));
}

TEST_CASE("sine is odd and cosine even to the last bit") {
    for_angles([&](double x) {
        const SineCosine there = sine_cosine(x), mirrored = sine_cosine(-x);
        if (!same_bits(there.sine, -mirrored.sine) || !same_bits(there.cosine, mirrored.cosine)) FAIL(x);
    });
    CHECK(same_bits(sine(-0.0), -0.0));
    for (double x = -1000; x < 1000; x += 0.37)
        if (!same_bits(sine_degrees(x), -sine_degrees(-x)) || !same_bits(cosine_degrees(x), cosine_degrees(-x)))
            FAIL(x);
    CHECK(same_bits(sine_degrees(-0.0), -0.0));
}

TEST_CASE("quarter turns in degrees are exact and their zeros are positive") {
    for (int turns = 0; turns < 100; ++turns) {
        const double start = 360.0 * turns;
        REQUIRE(same_bits(sine_degrees(start), 0));
        REQUIRE(same_bits(sine_degrees(start + 90), 1));
        REQUIRE(same_bits(sine_degrees(start + 180), 0));
        REQUIRE(same_bits(sine_degrees(start + 270), -1));
        REQUIRE(same_bits(cosine_degrees(start), 1));
        REQUIRE(same_bits(cosine_degrees(start + 90), 0));
        REQUIRE(same_bits(cosine_degrees(start + 180), -1));
        REQUIRE(same_bits(cosine_degrees(start + 270), 0));
        REQUIRE(same_bits(sine_degrees(start + 30), 0.5));
        REQUIRE(same_bits(sine_degrees(start + 210), -0.5));
        REQUIRE(same_bits(cosine_degrees(start + 60), 0.5));
        REQUIRE(same_bits(cosine_degrees(start + 120), -0.5));
        REQUIRE(same_bits(sine_degrees(start + 45), cosine_degrees(start + 45)));
        REQUIRE(same_bits(sine_degrees(start + 225), cosine_degrees(start + 135)));
    }
}

TEST_CASE("the cosine of an angle in degrees is the sine of its complement to the last bit") {
    for (int i = -8 * 720; i <= 8 * 720; ++i) {
        const double x = i / 8.0;
        if (sine_degrees(x) == 0) continue;  // zeros may differ in sign
        if (!same_bits(sine_degrees(x), cosine_degrees(90 - x)) || !same_bits(sine_degrees(x), sine_degrees(180 - x)))
            FAIL(x);
    }
}

TEST_CASE("sine and cosine of degrees are within one unit in the last place") {
    // The reference reduces by half turns, without rounding, and takes steep angles from the complement.
    const auto true_sine = [](double x) {
        const double rest = std::remainder(x, 180);
        const auto upwards = [](double degrees) { return static_cast<long double>(degrees) * (pi_long / 180); };
        const long double size =
            std::fabs(rest) <= 45 ? std::sin(upwards(std::fabs(rest))) : std::cos(upwards(90 - std::fabs(rest)));
        const bool odd = std::fmod((x - rest) / 180, 2) != 0;
        return (rest < 0) != odd ? -size : size;
    };
    Worst s, c;
    CounterRng rng(3);
    for (int i = 0; i < 200000; ++i) {
        // Multiples of 2^-30, so that 90 - x is exact.
        const double x = std::floor(rng.in(-1000, 1000) * 0x1p30) * 0x1p-30;
        s.see(x, sine_degrees(x), true_sine(x));
        c.see(x, cosine_degrees(x), true_sine(90 - x));
    }
    CAPTURE(s.at, c.at);
    CHECK(s.error < 1);
    CHECK(c.error < 1);
}

TEST_CASE("radians and degrees undo each other at the angles people write") {
    CHECK(same_bits(radians(180), pi));
    CHECK(same_bits(radians(90), half_pi));
    CHECK(same_bits(radians(360), two_pi));
    for (int i = -360; i <= 360; ++i) REQUIRE(std::fabs(degrees(radians(i)) - i) <= 1e-15 * std::abs(i));
}

TEST_CASE("arc_tangent is within two units in the last place all round") {
    Worst worst;
    CounterRng rng(4);
    for (int i = 0; i < 300000; ++i) {
        const double x = rng.in(-1, 1) * (i % 3 ? 1 : std::pow(10, rng.in(-6, 0)));
        const double y = rng.in(-1, 1) * (i % 5 ? 1 : std::pow(10, rng.in(-6, 0)));
        worst.see(y / x, arc_tangent(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
    }
    CAPTURE(worst.at);
    CHECK(worst.error < 2);
}

TEST_CASE("reflecting a vector reflects its arc_tangent to the last bit") {
    CounterRng rng(5);
    for (int i = 0; i < 50000; ++i) {
        const double x = rng.in(0, 1), y = rng.in(0, 1);
        const double a = arc_tangent(y, x);
        if (!same_bits(arc_tangent(-y, x), -a)) FAIL(x << ' ' << y);
        if (!same_bits(arc_tangent(-y, -x), -arc_tangent(y, -x))) FAIL(x << ' ' << y);
        // Half turns and swaps are exact up to the one rounding of the subtraction.
        if (ulps(arc_tangent(y, -x), pi_long - static_cast<long double>(a)) > 1) FAIL(x << ' ' << y);
        if (x < y && ulps(a, pi_long / 2 - static_cast<long double>(arc_tangent(x, y))) > 1) FAIL(x << ' ' << y);
    }
}

TEST_CASE("arc_tangent on the axes, the diagonals and at the limits") {
    CHECK(same_bits(arc_tangent(0, 1), 0));
    CHECK(same_bits(arc_tangent(-0.0, 1), -0.0));
    CHECK(same_bits(arc_tangent(0, -1), pi));
    CHECK(same_bits(arc_tangent(-0.0, -1), -pi));
    CHECK(same_bits(arc_tangent(1, 0), half_pi));
    CHECK(same_bits(arc_tangent(-1, 0), -half_pi));
    CHECK(same_bits(arc_tangent(0, 0), 0));
    for (double size : {1e-300, 1e-9, 1.0, 3.7, 1e300, inf}) {
        REQUIRE(same_bits(arc_tangent(size, size), pi / 4));
        REQUIRE(same_bits(arc_tangent(size, -size), 3 * pi / 4));
        REQUIRE(same_bits(arc_tangent(-size, size), -pi / 4));
        REQUIRE(same_bits(arc_tangent(size, 0), half_pi));
    }
    CHECK(same_bits(arc_tangent(inf, 1), half_pi));
    CHECK(same_bits(arc_tangent(1, inf), 0));
    CHECK(same_bits(arc_tangent(1, -inf), pi));
    CHECK(std::isnan(arc_tangent(std::nan(""), 1)));
}

TEST_CASE("arc_sine and arc_cosine are within two and a half units in the last place") {
    Worst s, c;
    CounterRng rng(6);
    for (int i = 0; i < 100000; ++i) {
        const double x = i % 2 ? rng.in(-1, 1) : 1 - std::pow(10, rng.in(-16, 0));
        s.see(x, arc_sine(x), std::asin(static_cast<long double>(x)));
        c.see(x, arc_cosine(x), std::acos(static_cast<long double>(x)));
    }
    CAPTURE(s.at, c.at);
    CHECK(s.error < 2.5);
    CHECK(c.error < 2.5);
    CHECK(same_bits(arc_cosine(1), 0));
    CHECK(same_bits(arc_cosine(-1), pi));
    CHECK(same_bits(arc_sine(1), half_pi));
    CHECK(std::isnan(arc_cosine(1.0000001)));
    CHECK(std::isnan(arc_sine(-1.0000001)));
}

TEST_CASE("exponential and logarithm are within one unit in the last place and meet their limits") {
    Worst e, l;
    CounterRng rng(7);
    for (int i = 0; i < 100000; ++i) {
        const double x = i % 2 ? rng.in(-700, 700) : rng.in(-1, 1);
        e.see(x, exponential(x), std::exp(static_cast<long double>(x)));
        const double y = i % 2 ? std::pow(10, rng.in(-300, 300)) : 1 + rng.in(-0.5, 0.5) * std::pow(10, rng.in(-12, 0));
        l.see(y, logarithm(y), std::log(static_cast<long double>(y)));
    }
    CAPTURE(e.at, l.at);
    CHECK(e.error < 1);
    CHECK(l.error < 1);
    CHECK(same_bits(exponential(0), 1));
    CHECK(same_bits(logarithm(1), 0));
    CHECK(exponential(710) == inf);
    CHECK(exponential(-746) == 0);
    CHECK(exponential(709.7) == Approx(std::exp(709.7)).epsilon(1e-14));
    CHECK(exponential(-740) == Approx(std::exp(-740.0)).epsilon(1e-2));  // subnormal
    CHECK(logarithm(0) == -inf);
    CHECK(logarithm(5e-324) == Approx(-744.4400719213812).epsilon(1e-15));
    CHECK(std::isnan(logarithm(-1)));
}

TEST_CASE("the bits are those written down once, whatever the compiler and its optimisation") {
    Hash64 hash;
    CounterRng rng(8);
    for (int i = 0; i < 100000; ++i) {
        const double x = rng.in(-1000, 1000), y = rng.in(-1000, 1000), unit = rng.in(-1, 1);
        hash.feed(sine(x)).feed(cosine(x)).feed(tangent(x)).feed(sine_degrees(x)).feed(cosine_degrees(y));
        hash.feed(arc_tangent(y, x)).feed(arc_sine(unit)).feed(arc_cosine(unit));
        hash.feed(exponential(x / 2)).feed(logarithm(x * x));
    }
    CHECK(hash.hex() == "058deda5034f50ff");
}

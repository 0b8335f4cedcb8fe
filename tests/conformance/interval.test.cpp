#include "engine/sdf/interval.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include <vector>

#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "engine/sdf/dual.h"
#include "engine/sdf/interval_dual.h"

namespace pinfield::sdf {
namespace {

constexpr double infinite = Interval::infinite;

/// A random formula over x and y, the same for every scalar: `seed` chooses its operations.
template <class R>
R random_formula(const R& x, const R& y, std::uint64_t seed) {
    CounterRng rng(seed);
    std::vector<R> terms{x, y, R(0.5), R(-2)};
    for (int step = 0; step < 8; ++step) {
        const auto any = [&] { return at(terms, rng.in(0, static_cast<double>(terms.size()))); };
        const R a = any(), b = any(), c = any();
        switch (static_cast<int>(rng.in(0, 14))) {
            case 0: terms.push_back(a + b); break;
            case 1: terms.push_back(a - b); break;
            case 2: terms.push_back(a * b); break;
            case 3: terms.push_back(a * a); break;
            case 4: terms.push_back(a / (R(0.25) + b * b)); break;
            case 5: terms.push_back(sqrt(abs(a))); break;
            case 6: terms.push_back(min(a, b) - max(b, c)); break;
            case 7: terms.push_back(floor(a)); break;
            case 8: terms.push_back(norm(Point<R>{a, b})); break;
            case 9: terms.push_back(select(a < b, b, c)); break;
            case 10: terms.push_back(select(either(a <= b, invert(b > c)), a, c)); break;
            case 11: terms.push_back(select(both(a >= b, exactly_one(a < c, b < c)), -b, c)); break;
            case 12: terms.push_back(sign(a) * clamp(b, R(-1), R(1))); break;
            default: terms.push_back(dot(Point<R>{a, b}, Point<R>{b, c})); break;
        }
    }
    return terms.back();
}

double between(const Interval& range, double share) { return min(max(range.lo + share * (range.hi - range.lo), range.lo), range.hi); }

}  // namespace

TEST_CASE("the enclosure of a random formula holds its values, for boxes from points to the whole neighbourhood") {
    CHECK(rc::check([](std::uint64_t seed) {
        CounterRng rng(seed);
        const double size = rng.uniform() < 0.1 ? 0 : std::exp(rng.in(-14, 1)), x0 = rng.in(-2, 2), y0 = rng.in(-2, 2);
        const Interval x(x0, x0 + size), y(y0, y0 + size);
        const Interval found = random_formula(x, y, seed);
        for (int i = 0; i < 30; ++i) {
            const double share_x = i < 4 ? i % 2 : rng.uniform(), share_y = i < 4 ? i / 2 : rng.uniform();
            RC_ASSERT(found.contains(random_formula(between(x, share_x), between(y, share_y), seed)));
        }
    }));
}

TEST_CASE("the enclosure of a random formula's gradient holds its gradients") {
    CHECK(rc::check([](std::uint64_t seed) {
        CounterRng rng(seed);
        const double size = std::exp(rng.in(-10, 0)), x0 = rng.in(-2, 2), y0 = rng.in(-2, 2);
        const Interval x(x0, x0 + size), y(y0, y0 + size), one(1), none(0);
        const IntervalDual found = random_formula(IntervalDual(x, one, none), IntervalDual(y, none, one), seed);
        for (int i = 0; i < 20; ++i) {
            const Dual d = random_formula(Dual(between(x, rng.uniform()), 1, 0), Dual(between(y, rng.uniform()), 0, 1), seed);
            RC_ASSERT(found.v.contains(d.v));
            const double slack = 1e-12 * (1 + abs(d.dx) + abs(d.dy));  // the last digits of another order of products
            RC_ASSERT(found.dx.lo - slack <= d.dx && d.dx <= found.dx.hi + slack);
            RC_ASSERT(found.dy.lo - slack <= d.dy && d.dy <= found.dy.hi + slack);
        }
    }));
}

TEST_CASE("each end of an inexact operation lies beyond the rounded result, by two ulps at most") {
    CHECK(rc::check([](std::uint64_t seed) {
        CounterRng rng(seed);
        const double a = std::ldexp(rng.in(-1, 1), static_cast<int>(rng.in(-1070, 900)));
        const Interval out = outward(a, a);
        RC_ASSERT(out.lo < a && a < out.hi);
        RC_ASSERT(out.lo >= std::nextafter(std::nextafter(a, -infinite), -infinite));
        RC_ASSERT(out.hi <= std::nextafter(std::nextafter(a, infinite), infinite));
    }));
    CHECK(outward(0, 0).lo < 0);
}

TEST_CASE("a difference or product that is 0 is known to be 0; a product that underflows is not") {
    const auto is_zero = [](const Interval& a) { return a.lo == 0 && a.hi == 0; };
    CHECK(is_zero(Interval(0.1) - Interval(0.1)));
    CHECK(is_zero(Interval(0) + Interval(0)));
    CHECK(is_zero(Interval(0) * Interval(-3, 5)));
    CHECK_FALSE(is_zero(Interval(0) * Interval(-3, infinite)));
    CHECK((Interval(1e-300) * Interval(1e-300)).hi > 0);
    CHECK((Interval(1e-320, 1) - Interval(0, 1e-320)).lo == 0);
}

TEST_CASE("division by what may be nothing, and what is no number, leave everything") {
    const auto is_everything = [](const Interval& a) { return a.lo == -infinite && a.hi == infinite; };
    CHECK(is_everything(Interval(1) / Interval(-1, 1)));
    CHECK(is_everything(Interval(1) / Interval(0, 1)));
    CHECK(is_everything(Interval(std::nan(""))));
    CHECK(is_everything(Interval::everything() * Interval(0)));
    CHECK(is_everything(Interval::everything() - Interval::everything()));
    CHECK(is_everything(Interval(infinite) - Interval(infinite)));
    CHECK(sqrt(Interval(-4, 9)).lo == 0);
    CHECK(sqrt(Interval(-4, 9)).hi == Approx(3));
}

TEST_CASE("a comparison of intervals is sure, surely not, or may be; a choice that may be either is the hull of both") {
    const Interval low(0, 1), high(2, 3), over(0.5, 2.5), yes(10), no(20);
    const auto chosen = [&](const IntervalMask& mask) { return select(mask, yes, no); };
    CHECK(chosen(low < high).hi == 10);
    CHECK(chosen(high < low).lo == 20);
    CHECK(chosen(low < over).lo == 10);
    CHECK(chosen(low < over).hi == 20);
    CHECK(chosen(Interval(0) < Interval(0)).lo == 20);
    CHECK(chosen(Interval(0) <= Interval(0)).hi == 10);
    CHECK(chosen(both(low < high, low < over)).hi == 20);
    CHECK(chosen(both(high < low, low < over)).lo == 20);
    CHECK(chosen(either(low < high, low < over)).hi == 10);
    CHECK(chosen(exactly_one(low < high, high < low)).hi == 10);
    CHECK(chosen(exactly_one(low < high, low < over)).hi == 20);
    CHECK(chosen(invert(high < low)).hi == 10);
}

TEST_CASE("a number times itself is a square, wherever a formula says so") {
    const Interval a(-1, 2);
    CHECK((a * a).lo == 0);
    CHECK((a * Interval(-1, 2)).lo < -1.9);
    CHECK(norm(Point<Interval>{Interval(3, 4), Interval(-1, 1)}).lo == Approx(3));
}

}  // namespace pinfield::sdf

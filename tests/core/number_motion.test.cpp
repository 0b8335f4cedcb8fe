#include "engine/core/number_motion.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/core/rng.h"
#include "engine/core/trig.h"

using namespace pinfield;

namespace {

NumberMotion some_motion(CounterRng& rng, int kind) {
    if (kind == 0) return {SpinMotion{rng.in(-9, 9), rng.in(-3, 3)}};
    if (kind == 1) return {WaveMotion{rng.in(-2, 2), rng.in(-2, 2), rng.in(0.1, 5), rng.in(-7, 7)}};
    KeyedMotion k;
    double t = rng.in(-3, 3);
    const int count = 2 + static_cast<int>(rng.in(0, 5));
    for (int i = 0; i < count; ++i, t += rng.in(0.1, 2)) k.keys.push_back({t, rng.in(-2, 2)});
    k.loop = kind == 3;
    if (k.loop) k.keys.back().value = k.keys.front().value;
    return {k};
}

template <class Check>
void for_motions(Check check) {
    CounterRng rng(7);
    for (int i = 0; i < 400; ++i) {
        const NumberMotion m = some_motion(rng, i % 4);
        REQUIRE(!m.fault());
        check(m, rng);
    }
}

}  // namespace

TEST_CASE("no motion changes faster than its bound, and each comes within a hundredth of it") {
    for_motions([](const NumberMotion& m, CounterRng&) {
        double fastest = 0;
        const double h = 1e-3;
        for (double t = -15; t < 20; t += h) fastest = std::max(fastest, std::fabs(m.value_at(t + h) - m.value_at(t)) / h);
        CHECK(fastest <= m.rate_bound() * (1 + 1e-9) + 1e-9);
        CHECK(fastest >= m.rate_bound() * 0.99);
    });
}

TEST_CASE("a motion's range holds all its values, and nothing that it does not come near") {
    for_motions([](const NumberMotion& m, CounterRng&) {
        const auto [low, high] = m.range();
        double least = 1e9, most = -1e9;
        for (double t = -15; t < 20; t += 1e-3) {
            least = std::min(least, m.value_at(t));
            most = std::max(most, m.value_at(t));
        }
        CHECK(low <= least);
        CHECK(most <= high);
        if (std::holds_alternative<SpinMotion>(m.kind)) return;
        CHECK(least - low <= 1e-3 * m.rate_bound());
        CHECK(high - most <= 1e-3 * m.rate_bound());
    });
}

TEST_CASE("a wave and a loop of keys repeat after their period, in the past as well") {
    for_motions([](const NumberMotion& m, CounterRng& rng) {
        const auto* wave = std::get_if<WaveMotion>(&m.kind);
        const auto* keys = std::get_if<KeyedMotion>(&m.kind);
        if (!wave && !(keys && keys->loop)) return;
        const double period = wave ? wave->period : keys->keys.back().time - keys->keys.front().time;
        for (int i = 0; i < 50; ++i) {
            const double t = rng.in(-20, 20);
            CHECK(m.value_at(t + 3 * period) == Approx(m.value_at(t)).margin(1e-12 * (1 + 100 * m.rate_bound())));
        }
    });
}

TEST_CASE("a motion negated is the same one with the opposite sign, bit for bit") {
    for_motions([](const NumberMotion& m, CounterRng& rng) {
        const double t = rng.in(-20, 20);
        CHECK(m.negated().value_at(t) == -m.value_at(t));
        CHECK(m.negated().negated() == m);
    });
}

TEST_CASE("a spin goes on from where it starts, a wave begins in the middle and has its ends exactly at the quarters") {
    CHECK(NumberMotion{SpinMotion{60, 10}}.value_at(0.5) == 40);
    const NumberMotion wave{WaveMotion{0.25, 0.75, 2, 0}};
    CHECK(wave.value_at(0) == 0.5);
    CHECK(wave.value_at(0.5) == 0.75);
    CHECK(wave.value_at(1) == 0.5);
    CHECK(wave.value_at(1.5) == 0.25);
    CHECK(NumberMotion{WaveMotion{0.25, 0.75, 2, half_pi}}.value_at(0) == 0.75);
}

TEST_CASE("keys have their values exactly, straight lines between, and stay outside") {
    const NumberMotion m{KeyedMotion{{{0.1, 1.1}, {0.3, 2.7}, {0.7, 0.9}}, false}};
    CHECK(m.value_at(0.1) == 1.1);
    CHECK(m.value_at(0.3) == 2.7);
    CHECK(m.value_at(0.7) == 0.9);
    CHECK(m.value_at(0.5) == Approx(1.8));
    CHECK(m.value_at(-5) == 1.1);
    CHECK(m.value_at(5) == 0.9);
}

TEST_CASE("what is no motion says why") {
    CHECK(NumberMotion{SpinMotion{INFINITY, 0}}.fault());
    CHECK(NumberMotion{WaveMotion{0, 1, 0, 0}}.fault());
    CHECK(NumberMotion{WaveMotion{0, NAN, 1, 0}}.fault());
    CHECK(NumberMotion{KeyedMotion{{{0, 1}}, false}}.fault());
    CHECK(NumberMotion{KeyedMotion{{{0, 1}, {0, 2}}, false}}.fault());
    CHECK(NumberMotion{KeyedMotion{{{0, 1}, {1, 2}}, true}}.fault());
    CHECK(!NumberMotion{KeyedMotion{{{0, 1}, {1, 2}}, false}}.fault());
}

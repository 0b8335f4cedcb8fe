// How fast formulas change, proved, and what is not believed.
#include "engine/sdf/steepness.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/core/rng.h"
#include "tests/sdf/formulas.h"
#include "tests/sdf/packed_formula.h"

using namespace pinfield;
using namespace pinfield::sdf;
using pinfield::test::PackedFormula;

namespace {

constexpr double half = 0.04;
const Vec2 window(2 * half, 2 * half);

Vec2 random_point(CounterRng& rng) {
    const double x = rng.in(-half, half);
    return {x, rng.in(-half, half)};
}

}  // namespace

TEST_CASE("cut off at its level a formula changes no faster than is proved") {
    for (const std::string_view text : test::good_formulas) {
        INFO(text);
        const PackedFormula formula(text);
        const auto found = steepness_of(formula.steps, window, text);
        if (!found) FAIL_CHECK(found.error().message);
        if (!found) continue;
        const auto cut = [&](const Vec2& p) { return std::clamp(formula.value(p), -found->level, found->level); };
        CounterRng rng(6);
        double steepest = 0;
        for (int i = 0; i < 4000; ++i) {
            const Vec2 a = random_point(rng);
            // Also a little apart, and across the axes.
            const Vec2 b = i % 4 == 0 ? random_point(rng) : i % 4 == 1 ? Vec2(-a.x() * 1e-6, a.y()) : Vec2(a + 1e-6 * random_point(rng));
            const Vec2 from = i % 4 == 1 ? Vec2(a.x() * 1e-6, a.y()) : a;
            const double change = std::fabs(cut(from) - cut(b)), way = length(from - b);
            if (way > 1e-9) steepest = std::max(steepest, change / way);
            REQUIRE(change <= found->lipschitz * way + 1e-16);
        }
        CHECK(steepest > 0.3 * found->lipschitz);  // it is not proved by much too coarse a box
        INFO(found->lipschitz << " below " << found->level);
        CHECK(found->level / found->lipschitz > 1e-4);
    }
}

TEST_CASE("what jumps, has no value or is without end steep at its zero line is refused, and told where") {
    for (const test::BadFormula& bad : test::bad_formulas) {
        INFO(bad.text);
        const PackedFormula formula(bad.text);
        const auto found = steepness_of(formula.steps, window, bad.text);
        REQUIRE_FALSE(found);
        const TextFault& fault = found.error();
        INFO(fault.message);
        CHECK(bad.text.substr(fault.span.begin, fault.span.end - fault.span.begin) == bad.part);
        CHECK(fault.message.find(bad.why) != std::string::npos);
        CHECK(fault.code == Code::no_distance);
    }
}

TEST_CASE("what a formula does in a window that does not hold the trouble is no trouble") {
    const std::string_view text = "sqrt(x * 1cm + 8mm ^ 2) - 1cm";
    const PackedFormula formula(text);
    CHECK(steepness_of(formula.steps, {0.01, 0.08}, text));
    CHECK_FALSE(steepness_of(formula.steps, {0.08, 0.08}, text));
}

TEST_CASE("the box of what is solid holds all of it, and hardly more") {
    for (const std::string_view text : test::good_formulas) {
        INFO(text);
        const PackedFormula formula(text);
        const Box2 box = box_below(formula.steps, window, 0);
        Box2 seen;
        CounterRng rng(8);
        for (int i = 0; i < 60000; ++i) {
            const Vec2 p = random_point(rng);
            if (formula.value(p) > 0) continue;
            seen = seen.including(p);
            REQUIRE(box.contains(p));
        }
        CHECK(seen.is_empty() == box.is_empty());
        if (seen.is_empty()) continue;
        CHECK((box.lo - seen.lo).cwiseAbs().maxCoeff() < 1.5e-3);
        CHECK((box.hi - seen.hi).cwiseAbs().maxCoeff() < 1.5e-3);
    }
    const std::string_view circle = "length(x - 1cm, y) - 2cm", nothing = "length(x, y) + 1mm";
    const PackedFormula disc(circle), none(nothing);
    const Box2 box = box_below(disc.steps, window, 0);
    CHECK((box.lo - Vec2(-0.01, -0.02)).cwiseAbs().maxCoeff() < 2e-5);
    CHECK((box.hi - Vec2(0.03, 0.02)).cwiseAbs().maxCoeff() < 2e-5);
    CHECK(box_below(none.steps, window, 0).is_empty());
    CHECK((box_below(none.steps, window, 0.011).hi - Vec2(0.01, 0.01)).cwiseAbs().maxCoeff() < 2e-5);
}

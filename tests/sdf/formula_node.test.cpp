// The node over formulas: what it promises of them.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/core/rng.h"
#include "engine/reflect/text_fault.h"
#include "engine/sdf/register.h"
#include "tests/sdf/formulas.h"
#include "tests/sdf/packed_formula.h"

using namespace pinfield;
using namespace pinfield::sdf;

namespace {

constexpr double half = 0.04;

/// A formula node in a window of 80 mm.
struct Node {
    explicit Node(std::string_view text, const Vec2& window = {2 * half, 2 * half})
        : kernels(*built_in_type("formula").kernels),
          block(pack(built_in_type("formula"), std::vector<Value>{std::string(text), window}, kernels.derived_count)) {
        kernels.derive(block.data());
    }
    double value(const Vec2& p) const { return kernels.distance(block.data(), p.x(), p.y()); }
    Sample sample(const Vec2& p) const { return kernels.sample(block.data(), p.x(), p.y()); }
    bool is_refused() const { return kernels.refusal(block.data(), {}).has_value(); }

    const Kernels& kernels;
    std::vector<double> block;
};

/// In and around the window.
Vec2 random_point(CounterRng& rng) {
    const double reach = rng.uniform() < 0.7 ? half : 2 * half, x = rng.in(-reach, reach);
    return {x, rng.in(-reach, reach)};
}
bool in_window(const Vec2& p) { return p.cwiseAbs().maxCoeff() <= half; }

}  // namespace

TEST_CASE("a formula node has the sign of its formula within its bounds, and is nowhere solid beyond") {
    for (const std::string_view text : test::good_formulas) {
        INFO(text);
        const Node node(text);
        const test::PackedFormula formula(text);
        REQUIRE_FALSE(node.is_refused());
        CounterRng rng(11);
        for (int i = 0; i < 2000; ++i) {
            const Vec2 p = random_point(rng);
            if (in_window(p)) REQUIRE((node.value(p) < 0) == (formula.value(p) < 0));
            else REQUIRE(node.value(p) > 0);
        }
    }
}

TEST_CASE("a formula node changes no faster than the way between two points") {
    for (const std::string_view text : test::good_formulas) {
        INFO(text);
        const Node node(text);
        CounterRng rng(12);
        for (int i = 0; i < 4000; ++i) {
            const Vec2 a = random_point(rng), b = i % 2 == 0 ? random_point(rng) : Vec2(a + std::exp(rng.in(-12, -2)) * random_point(rng));
            REQUIRE(std::fabs(node.value(a) - node.value(b)) <= length(a - b) * (1 + 1e-12) + 1e-16);
            REQUIRE(length(node.sample(a).gradient) <= 1 + 1e-9);
            REQUIRE(node.sample(a).value == node.value(a));
        }
    }
}

/// On the way to any point of the other side the outline is crossed.
TEST_CASE("a formula node never says more than the way to the nearest of 160 000 points of the other side") {
    constexpr int across = 400;
    for (const std::string_view text : test::good_formulas) {
        INFO(text);
        const Node node(text);
        std::vector<Vec2> solid, free;
        for (int j = 0; j <= across; ++j)
            for (int i = 0; i <= across; ++i) {
                const Vec2 q = 2.2 * half * (Vec2(i, j) / across - Vec2(0.5, 0.5));
                (node.value(q) < 0 ? solid : free).push_back(q);
            }
        CounterRng rng(13);
        for (int i = 0; i < 60; ++i) {
            const Vec2 p = random_point(rng);
            const double value = node.value(p);
            double nearest = infinity;
            for (const Vec2& q : value < 0 ? free : solid) nearest = std::min(nearest, (p - q).squaredNorm());
            REQUIRE(std::fabs(value) <= std::sqrt(nearest) + 1e-15);
        }
    }
}

TEST_CASE("what no distance can be made of is refused, and as a node nowhere solid, finite everywhere") {
    for (const test::BadFormula& bad : test::bad_formulas) {
        INFO(bad.text);
        const Node node(bad.text);
        CHECK(node.is_refused());
        CounterRng rng(14);
        for (int i = 0; i < 200; ++i) REQUIRE(node.value(random_point(rng)) >= 0);
    }
}

TEST_CASE("a formula node's packets give its values as well as floats can, also where the formula has none beyond its bounds") {
    const Node node("2cm - sqrt((4cm - x) * 1cm) + abs(y)", {0.0799, 0.08});
    REQUIRE_FALSE(node.is_refused());
    std::vector<float> x, y;
    CounterRng rng(15);
    for (int i = 0; i < 999; ++i) {
        const Vec2 p = i % 3 == 0 ? Vec2(0.03995, rng.in(-half, half)) : random_point(rng);
        x.push_back(static_cast<float>(p.x()));
        y.push_back(static_cast<float>(p.y()));
    }
    for (const PacketKernels& packets : node.kernels.packets) {
        if (&packets != &node.kernels.packets[0] && best_isa() == Isa::sse2) continue;
        std::vector<float> found(x.size());
        packets.distance(node.block.data(), {}, x.data(), y.data(), found.data(), static_cast<int>(x.size()));
        for (std::size_t i = 0; i < x.size(); ++i) REQUIRE(std::fabs(found[i] - node.value(Vec2(x[i], y[i]))) < 1e-6);
    }
}

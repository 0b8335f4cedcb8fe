// One expression over every scalar.
#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

#include "engine/core/rng.h"
#include "engine/sdf/dual_functions.h"
#include "engine/sdf/interval_functions.h"
#include "engine/sdf/packet_functions.h"
#include "tests/sdf/formulas.h"
#include "tests/sdf/packed_formula.h"

using namespace pinfield;
using namespace pinfield::sdf;
using pinfield::test::PackedFormula;

namespace {

constexpr double half = 0.04;

double by_expression(std::string_view text, double x, double y) {
    const auto expression = parse_expression(text);
    std::vector<double> names;
    for (const ExpressionName& name : expression->names) names.push_back(name.text == "x" ? x : y);
    return evaluate(*expression, names).value_or(std::nan(""));
}

template <class P>
std::vector<float> by_packets(const Steps& steps, const std::vector<float>& x, const std::vector<float>& y) {
    std::vector<float> out(x.size());
    for (std::size_t i = 0; i + static_cast<std::size_t>(P::width) <= x.size(); i += static_cast<std::size_t>(P::width))
        value_at(steps, Point<P>{P::load(&x[i]), P::load(&y[i])}).store(&out[i]);
    return out;
}

}  // namespace

TEST_CASE("a formula's value is its expression's, and the same alone and with its gradient, which is the central difference") {
    for (const std::string_view text : test::good_formulas) {
        INFO(text);
        const PackedFormula formula(text);
        CounterRng rng(3);
        for (int i = 0; i < 200; ++i) {
            const double x = rng.in(-half, half), y = rng.in(-half, half), h = 1e-7;
            const auto value = [&](double dx, double dy) { return value_at(formula.steps, Point<double>{x + dx, y + dy}); };
            const Dual with_gradient = value_at(formula.steps, Point<Dual>{Dual(x, 1, 0), Dual(y, 0, 1)});
            REQUIRE(value(0, 0) == by_expression(text, x, y));
            REQUIRE(value(0, 0) == with_gradient.v);
            const double rise_x = value(h, 0) - value(-h, 0), rise_y = value(0, h) - value(0, -h);
            const double bend = std::fabs(value(h, 0) + value(-h, 0) - 2 * value(0, 0)) + std::fabs(value(0, h) + value(0, -h) - 2 * value(0, 0));
            if (bend > 1e-4 * h) continue;
            const double slack = 1e-5 * (1 + std::fabs(with_gradient.dx) + std::fabs(with_gradient.dy));
            REQUIRE(std::fabs(rise_x / (2 * h) - with_gradient.dx) < slack);
            REQUIRE(std::fabs(rise_y / (2 * h) - with_gradient.dy) < slack);
        }
    }
}

TEST_CASE("over a box of points a formula's intervals hold its values and gradients") {
    for (const std::string_view text : test::good_formulas) {
        INFO(text);
        const PackedFormula formula(text);
        CounterRng rng(4);
        for (int i = 0; i < 200; ++i) {
            const double size = i % 10 == 0 ? 0 : 0.08 * std::exp(rng.in(-12, 0)), left = rng.in(-half, half), low = rng.in(-half, half);
            const Interval x(left, left + size), y(low, low + size), one(1), none(0);
            const Interval alone = value_at(formula.steps, Point<Interval>{x, y});
            const IntervalDual found = value_at(formula.steps, Point<IntervalDual>{{x, one, none}, {y, none, one}});
            for (int k = 0; k < 12; ++k) {
                const double px = min(left + size * rng.uniform(), x.hi), py = min(low + size * rng.uniform(), y.hi);
                const Dual d = value_at(formula.steps, Point<Dual>{Dual(px, 1, 0), Dual(py, 0, 1)});
                INFO(px << " " << py << " in a box of " << size);
                REQUIRE(alone.contains(d.v));
                REQUIRE(found.v.contains(d.v));
                const double slack = 1e-12 * (1 + std::fabs(d.dx) + std::fabs(d.dy));  // the last digits of another order of products
                REQUIRE((found.dx.lo - slack <= d.dx && d.dx <= found.dx.hi + slack));
                REQUIRE((found.dy.lo - slack <= d.dy && d.dy <= found.dy.hi + slack));
            }
        }
    }
}

TEST_CASE("lanes of floats give a formula's value as well as floats can") {
    for (const std::string_view text : test::good_formulas) {
        INFO(text);
        const PackedFormula formula(text);
        CounterRng rng(5);
        std::vector<float> x, y;
        for (int i = 0; i < 400; ++i) {
            x.push_back(static_cast<float>(rng.in(-half, half)));
            y.push_back(static_cast<float>(rng.in(-half, half)));
        }
        const std::vector<float> found = by_packets<Packet<xsimd::sse2>>(formula.steps, x, y);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Dual d = value_at(formula.steps, Point<Dual>{Dual(x[i], 1, 0), Dual(y[i], 0, 1)});
            const double limit = 4e-6 * (std::fabs(d.v) + half * (1 + std::fabs(d.dx) + std::fabs(d.dy)));
            INFO(x[i] << " " << y[i]);
            REQUIRE(std::fabs(found[i] - d.v) < limit);
        }
    }
}

TEST_CASE("a text that is no length of x and y is refused where it is wrong") {
    const auto fault = [](std::string_view text) {
        std::vector<double> reals;
        auto out = Steps::pack(text, reals);
        CHECK(reals.empty() == out.has_value());
        return out.value_or(TextFault{});
    };
    CHECK(fault("x + ").code == Code::bad_expression);
    CHECK(fault("x * y").code == Code::wrong_dimension);
    CHECK(fault("x + 3deg").code == Code::wrong_dimension);
    CHECK(fault("x < y").code == Code::wrong_type);
    const TextFault unknown = fault("x + 2 * r");
    CHECK(unknown.code == Code::unknown_name);
    CHECK(unknown.span == Span{8, 9});
    CHECK(fault("x + 3 cm").code == Code::malformed_number);
}

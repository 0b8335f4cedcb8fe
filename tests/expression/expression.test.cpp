#include "engine/expression/expression.h"

#include <rapidcheck.h>

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/core/trig.h"
#include "engine/expression/evaluate.h"
#include "tests/expression/random_expression.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

constexpr Dimension a_length{1, 0, 0, 0}, an_angle{0, 1, 0, 0}, a_time{0, 0, 1, 0};

Expression parsed(std::string_view text) {
    INFO(text);
    auto expression = parse_expression(text);
    if (!expression) FAIL(expression.error().message);
    return *expression;
}

double value(std::string_view text, std::vector<double> names = {}) {
    INFO(text);
    const auto number = evaluate(parsed(text), names);
    if (!number) FAIL(number.error().message);
    return *number;
}

Dimension dimension(std::string_view text) {
    INFO(text);
    const auto measure = measure_of(parsed(text), {});
    if (!measure) FAIL(measure.error().message);
    return measure->dimension;
}

/// "E0225 3..4: message (hint)" of the first thing that is wrong, whoever finds it; names are bare and 0.
std::string told(std::string_view text) {
    const auto expression = parse_expression(text);
    const auto shown = [](const ExpressionError& e) {
        return std::string(entry(e.code).code) + " " + std::to_string(e.span.begin) + ".." + std::to_string(e.span.end) + ": " + e.message +
               (e.hint.empty() ? "" : " (" + e.hint + ")");
    };
    if (!expression) return shown(expression.error());
    const auto measure = measure_of(*expression, std::vector<Measure>(expression->names.size(), Measure{{}, true, false}));
    if (!measure) return shown(measure.error());
    const auto number = evaluate(*expression, std::vector<double>(expression->names.size()));
    return number ? "" : shown(number.error());
}

std::string repeated(std::string_view text, int count) {
    std::string out;
    for (int i = 0; i < count; ++i) out += text;
    return out;
}

std::array<double, 3> random_names(CounterRng& rng) {
    const double a = rng.in(-3, 3), b = rng.in(-3, 3), c = rng.in(0, 2);
    return {a, b, std::floor(c)};
}

/// The values of an expression's own names, which may be fewer.
std::vector<double> bound(const Expression& expression, const std::array<double, 3>& names) {
    std::vector<double> out;
    for (const ExpressionName& name : expression.names)
        for (std::size_t i = 0; i < names.size(); ++i)
            if (name.text == name_texts[i]) out.push_back(names[i]);
    return out;
}

/// A scalar of somebody else's: a value and its derivative.
struct Slope {
    double v = 0, d = 0;
    explicit Slope(double value) : v(value) {}
    Slope(double value, double slope) : v(value), d(slope) {}
};
Slope operator+(Slope a, Slope b) { return {a.v + b.v, a.d + b.d}; }
Slope operator-(Slope a, Slope b) { return {a.v - b.v, a.d - b.d}; }
Slope operator-(Slope a) { return {-a.v, -a.d}; }
Slope operator*(Slope a, Slope b) { return {a.v * b.v, a.v * b.d + a.d * b.v}; }
Slope operator/(Slope a, Slope b) { return {a.v / b.v, (a.d - a.v / b.v * b.d) / b.v}; }
bool operator<(Slope a, Slope b) { return a.v < b.v; }
bool operator>(Slope a, Slope b) { return a.v > b.v; }
bool operator<=(Slope a, Slope b) { return a.v <= b.v; }
bool operator>=(Slope a, Slope b) { return a.v >= b.v; }
Slope sqrt(Slope a) { return {std::sqrt(a.v), a.d / (2 * std::sqrt(a.v))}; }
Slope floor(Slope a) { return Slope(std::floor(a.v)); }
Slope abs(Slope a) { return a.v < 0 ? -a : a; }
Slope min(Slope a, Slope b) { return b.v < a.v ? b : a; }
Slope max(Slope a, Slope b) { return a.v < b.v ? b : a; }
Slope select(bool c, Slope a, Slope b) { return c ? a : b; }
Slope sine_degrees(Slope a) { return {pinfield::sine_degrees(a.v), radians(pinfield::cosine_degrees(a.v)) * a.d}; }
Slope cosine_degrees(Slope a) { return {pinfield::cosine_degrees(a.v), -radians(pinfield::sine_degrees(a.v)) * a.d}; }
Slope arc_tangent(Slope y, Slope x) {
    return {pinfield::arc_tangent(y.v, x.v), (y.d * x.v - y.v * x.d) / (x.v * x.v + y.v * y.v)};
}
Slope exponential(Slope a) { return {pinfield::exponential(a.v), pinfield::exponential(a.v) * a.d}; }
Slope logarithm(Slope a) { return {pinfield::logarithm(a.v), a.d / a.v}; }

}  // namespace

TEST_CASE("an expression printed as text, with its brackets or with more, is read back as the same tree") {
    CHECK(rc::check([](std::uint64_t seed) {
        CounterRng rng(seed);
        const Tree tree = random_number(rng, 5);
        const std::string text = printed(tree, rng, rng.next_u64() % 2 == 0 ? 0.0 : 0.3);
        const auto expression = parse_expression(text);
        if (!expression && (expression.error().code == Code::expression_too_long)) return;
        RC_LOG() << text << "\n" << (expression ? "" : expression.error().message);
        RC_ASSERT(expression.has_value());
        RC_ASSERT(says(*expression, expression->root(), tree));
    }));
}

TEST_CASE("an expression has the value that its formula has by the textbook, or an error where that is no number") {
    CHECK(rc::check([](std::uint64_t seed) {
        CounterRng rng(seed);
        const Tree tree = random_number(rng, 3);
        const auto expression = parse_expression(printed(tree, rng, 0.1));
        RC_ASSERT(expression.has_value());
        const std::array<double, 3> names = random_names(rng);
        const double direct = direct_value(tree, names);
        const auto number = evaluate(*expression, bound(*expression, names));
        RC_LOG() << expression->text << " " << names[0] << " " << names[1] << " " << names[2] << " " << direct << "\n";
        // Steps and quotients by what is nearly 0 make much of a last place.
        const auto jumps = [](Operation o) {
            return o == Operation::floor || o == Operation::ceiling || o == Operation::modulo || o == Operation::choose || o == Operation::sign ||
                   o == Operation::tangent || o == Operation::smoothstep || o == Operation::power || o == Operation::root ||
                   o == Operation::logarithm || o == Operation::arc_tangent || o == Operation::divide || o == Operation::exponential;
        };
        bool smooth = true;
        for (const ExpressionNode& node : expression->nodes) smooth = smooth && !jumps(node.operation);
        if (number) RC_ASSERT(std::isfinite(*number));
        if (smooth || expression->nodes.size() < 4) RC_ASSERT(number.has_value() == std::isfinite(direct));
        if (number && std::isfinite(direct) && smooth) RC_ASSERT(std::fabs(*number - direct) <= 1e-9 * (1 + std::fabs(direct)));
        if (number && expression->nodes.size() < 4 && std::fabs(direct) < 1e6) RC_ASSERT(std::fabs(*number - direct) <= 1e-9 * (1 + std::fabs(direct)));
    }));
}

TEST_CASE("what is folded has the same value bit for bit, and no more nodes") {
    CHECK(rc::check([](std::uint64_t seed) {
        CounterRng rng(seed);
        const auto expression = parse_expression(printed(random_number(rng, 4), rng, 0));
        if (!expression) return;
        const std::vector<Measure> bare(expression->names.size(), Measure{{}, true, false});
        const Expression less = folded(*expression, bare);
        RC_ASSERT(less.nodes.size() <= expression->nodes.size());
        const std::vector<double> names = bound(*expression, random_names(rng));
        const auto before = evaluate(*expression, names), after = evaluate(less, names);
        RC_ASSERT(before.has_value() == after.has_value());
        if (before) RC_ASSERT(std::bit_cast<std::uint64_t>(*before) == std::bit_cast<std::uint64_t>(*after));
        else RC_ASSERT(before.error().span == after.error().span);
    }));
    CHECK(folded(parsed("2 * 3 + 1"), {}).nodes.size() == 1);
    CHECK(folded(parsed("2 * 3mm + x"), std::vector<Measure>{{a_length, false, false}}).nodes.size() == 3);
    CHECK(folded(parsed("1 / 0 + 2"), {}).nodes.size() == 5);
}

TEST_CASE("any bytes are read or refused, and what is wrong with them lies within them") {
    const std::string letters = "0123456789.ab_xi mnsdegr/^*+-%()<>=!,\"$\xC2\xB0\xE2\x88\x92\n\t\x01\xFF";
    const std::vector<std::string> words{"if ", " else ", " and ", "not ", "min(", "sin(", "mm", "deg", "1e", "pi", "(", ")", "^", "-"};
    CHECK(rc::check([&](std::uint64_t seed) {
        CounterRng rng(seed);
        std::string text;
        const auto count = rng.next_u64() % 24;
        for (std::uint64_t i = 0; i < count; ++i)
            if (rng.uniform() < 0.5) text += words[rng.next_u64() % words.size()];
            else text += letters[rng.next_u64() % letters.size()];
        const auto expression = parse_expression(text);
        const auto lies_within = [&](const ExpressionError& e) { return e.span.begin <= e.span.end && e.span.end <= text.size() && !e.message.empty(); };
        if (!expression) RC_ASSERT(lies_within(expression.error()));
        if (!expression) return;
        const auto measure = measure_of(*expression, std::vector<Measure>(expression->names.size()));
        if (!measure) RC_ASSERT(lies_within(measure.error()));
        if (!measure || measure->condition) return;
        const auto number = evaluate(*expression, std::vector<double>(expression->names.size(), 1.5));
        if (!number) RC_ASSERT(lies_within(number.error()));
        else RC_ASSERT(std::isfinite(*number));
    }));
}

TEST_CASE("a product divided by one of its factors measures what the other does") {
    CHECK(rc::check([](signed char l, signed char a, signed char t) {
        const auto small = [](signed char x) { return static_cast<signed char>(x % 5); };
        const Measure one{{small(l), small(a), small(t), 0}, false, false}, other{{small(t), small(l), 1, small(a)}, false, false};
        const std::vector<Measure> names{one, other};
        for (const char* text : {"a * b / b", "a / b * b", "sqrt(a ^ 2)", "a + a", "min(a, a)", "mix(a, a, 0.5)", "a if b > 0 * b else a", "-a",
                                 "a * 2", "a % a", "abs(a)", "length(a, a)", "a * (b / b)"}) {
            const Expression expression = parsed(text);
            const auto measure = measure_of(expression, std::span(names).first(expression.names.size()));
            RC_ASSERT(measure.has_value());
            RC_ASSERT(measure->dimension == one.dimension);
        }
        const auto sum = measure_of(parsed("a + b"), names);
        RC_ASSERT(sum.has_value() == (one.dimension == other.dimension));
    }));
}

TEST_CASE("signs, powers and words bind as in mathematics") {
    CHECK(value("-2^2") == -4);
    CHECK(value("2^3^2") == 512);
    CHECK(value("2^-1") == 0.5);
    CHECK(value("2 - 3 - 4") == -5);
    CHECK(value("12 / 3 / 2") == 2);
    CHECK(value("-2 * 3 + 1") == -5);
    CHECK(value("1 if not 1 < 2 and 2 < 1 or 3 == 3 else 0") == 1);
    CHECK(value("1 if 0 > 1 else 2 if 0 > 1 else 3") == 3);
    CHECK(value("+4 - +1") == 3);
    CHECK(value("min(5, 3, 4)") == 3);
    CHECK(value("max(1, 7, 2)") == 7);
}

TEST_CASE("functions have their closed forms, angles are degrees, and remainders have the sign of what divides") {
    CHECK(value("sin(30)") == 0.5);
    CHECK(value("cos(60deg)") == 0.5);
    CHECK(value("tan(45)") == 1);
    CHECK(value("atan2(1, 1)") == 45);
    CHECK(value("atan2(0, -1)") == 180);
    CHECK(value("atan2(3mm, 0 * 1mm)") == 90);
    CHECK(value("-1 % 3") == -1 + 3);
    CHECK(value("mod(1, -3)") == -2);
    CHECK(value("7mm % 2mm") == Approx(0.001));
    CHECK(value("mod(-1e-300, 1)") == 0);
    CHECK(value("ceil(1.2) + floor(-1.2)") == 0);
    CHECK(std::signbit(value("ceil(-0.5)")) == false);
    CHECK(value("sign(-3) + sign(0) + sign(2)") == 0);
    CHECK(value("length(3cm, 4cm)") == Approx(0.05));
    CHECK(value("mix(2, 4, 0.25)") == 2.5);
    CHECK(value("smoothstep(0, 2, 1)") == 0.5);
    CHECK(value("clamp(7, 1, 3)") == 3);
    CHECK(value("exp(0) + log(1)") == 1);
    CHECK(value("pow(4, 0.5)") == Approx(2));
    CHECK(value("3^4") == 81);
    CHECK(value("10^-2") == 0.01);
    CHECK(value("0^0") == 1);
    CHECK(value("(-2)^3") == -8);
    CHECK(value("pi") == pi);
}

TEST_CASE("a unit belongs to the number before it, and dimensions combine") {
    CHECK(value("18mm * 1.6") == 0.018 * 1.6);
    CHECK(value("1in + 1cm") == 0.0254 + 0.01);
    CHECK(value("6m / 2s") == 3);
    CHECK(value("a / 2", {5}) == 2.5);
    CHECK(dimension("3mm/s") == Dimension{1, 0, -1, 0});
    CHECK(dimension("3mm / 1s") == Dimension{1, 0, -1, 0});
    CHECK(dimension("9.81m/s^2 * 2s") == Dimension{1, 0, -1, 0});
    CHECK(dimension("sqrt(2 * 3m / 9.81m/s^2)") == a_time);
    CHECK(dimension("2cm ^ 2") == Dimension{2, 0, 0, 0});
    CHECK(dimension("atan2(1mm, 2mm)") == an_angle);
    CHECK(dimension("sin(3deg) * 2mm") == a_length);
    CHECK(measure_of(parsed("2 * 3"), {})->adapts());
    CHECK(measure_of(parsed("0.02 * 3mm / 2mm"), {})->adapts());
    CHECK(measure_of(parsed("0.02 * (3mm / 2mm)"), {})->adapts());
    CHECK_FALSE(measure_of(parsed("3mm / 2mm"), {})->adapts());
    CHECK_FALSE(measure_of(parsed("2 * 3mm"), {})->adapts());
    CHECK(measure_of(parsed("1mm < 2cm"), {})->condition);
}

TEST_CASE("only the branch that is chosen, and only what decides, needs a value") {
    CHECK(value("1 / n if n != 0 else 7", {0}) == 7);
    CHECK(value("1 if n != 0 and 1 / n > 2 else 7", {0}) == 7);
    CHECK(value("1 if n == 0 or 1 / n > 2 else 7", {0}) == 1);
}

TEST_CASE("what is wrong is told with its place and how to mend it") {
    CHECK(told("3 mm") == "E0210 0..4: 3 mm has a blank before its unit (write 3mm)");
    CHECK(told("2 * 007") == "E0210 4..7: 007 has a leading zero (some programs would read it as octal: leave the zero away)");
    CHECK(told("2 + 30\u00b0") == "E0212 6..8: \u00b0 is no unit here (write 30deg)");
    CHECK(told("2 + 3mmm") == "E0212 5..8: mmm is no unit (did you mean mm?)");
    CHECK(told("2x") == "E0212 1..2: x is no unit (a product is written with *: 2 * x)");
    CHECK(told("") == "E0225 0..0: an expression is due here");
    CHECK(told("2 *") == "E0225 3..3: the expression ends too early");
    CHECK(told("(1 + 2") == "E0225 6..6: ) of the bracket is missing at the end");
    CHECK(told("1)") == "E0225 1..2: ) cannot stand here (no bracket is open)");
    CHECK(told("a b") == "E0225 2..3: b cannot stand here (a product is written with *)");
    CHECK(told("2 ** 3") == "E0225 2..4: ** means nothing here (a power is written ^)");
    CHECK(told("a = b") == "E0225 2..3: = means nothing here (a comparison is written ==)");
    CHECK(told("$a") == "E0225 0..1: $ means nothing here (in an expression a name stands without $)");
    CHECK(told("1 < 2 < 3") == "E0225 6..7: two comparisons in a row (write a < b and b < c)");
    CHECK(told("sine(3)") == "E0225 0..4: no function is called sine (did you mean sin?)");
    CHECK(told("clamp(1, 2)") == "E0225 0..11: clamp takes 3 numbers, not 2 (write clamp(x, lowest, highest))");
    CHECK(told("min(1)") == "E0225 0..6: min takes 2 or more numbers, not 1 (write min(a, b))");
    CHECK(told("Petal * 2") == "E0222 0..5: Petal is not a valid name (small letters, digits and _)");
    CHECK(told("1 + (2mm + 3deg)") ==
          "E0213 11..15: 3deg is an angle, but 2mm is a length (both sides of + measure the same; units here: um, mm, cm, m, in, ft)");
    CHECK(told("sin(3mm)") == "E0213 4..7: 3mm is a length where an angle is due (angles are in degrees: sin(30), or sin(0.5rad))");
    CHECK(told("clamp(0, 1mm, 2deg)").starts_with("E0213 14..18: 2deg is an angle, but 1mm is a length"));
    CHECK(told("2mm ^ n").starts_with("E0213 6..7: 2mm is a length: its exponent must be a number, not n"));
    CHECK(told("sqrt(2mm)") == "E0213 0..9: the root of a length has no unit (the root of an area is a length)");
    CHECK(told("floor(2mm)").ends_with("(divide it by a unit: floor(x / 1m) * 1m)"));
    CHECK(told("1 + (2 < 3)") == "E0206 5..10: 2 < 3 is a condition where a number is due (write 1 if ... else 0)");
    CHECK(told("1 if 2 else 3") == "E0213 5..6: 2 is a number where a condition is due (compare it with something: ... > 0)");
    CHECK(told("2 + 1 / (n - 0)") == "E0226 4..15: 1 / (n - 0) divides by n - 0, which is 0 here, or nearly");
    CHECK(told("sqrt(-1)").starts_with("E0226 0..8: sqrt(-1) is the root of a number below 0"));
    CHECK(told("log(0)").starts_with("E0226"));
    CHECK(told("tan(90)").starts_with("E0226"));
    CHECK(told("5 % n").starts_with("E0226"));
    CHECK(told("(-2)^0.5").starts_with("E0226"));
    CHECK(told("1e300 * 1e300") == "E0226 0..13: 1e300 * 1e300 is too large for a number");
}

TEST_CASE("a value that does not fit where it stands is told what would") {
    const auto unfit = [](std::string_view text, const Dimension& due) {
        const Expression expression = parsed(text);
        const auto why = why_unfit(expression, *measure_of(expression, {}), due);
        return why ? why->message + " (" + why->hint + ")" : "";
    };
    CHECK(unfit("2 * 3", a_length).empty());
    CHECK(unfit("2mm * 3", a_length).empty());
    CHECK(unfit("2mm * 3mm", a_length) == "2mm * 3mm is an area where a length is due (units here: um, mm, cm, m, in, ft)");
    CHECK(unfit("2mm / 3mm", a_length) == "2mm / 3mm is a plain number where a length is due (multiply it by 1m)");
    CHECK(unfit("2mm * 3", {}) == "2mm * 3 is a length where a plain number is due (divide it by 1m)");
    CHECK(unfit("1 < 2", {}) == "1 < 2 is a condition where a number is due (write 1 if ... else 0)");
}

TEST_CASE("an expression may be as deep and as long as the limits say, and no more") {
    const int depth = most_expression_depth;
    for (const auto& [open, close] : {std::pair{"(", ")"}, {"-", ""}, {"1 ^ ", ""}, {"abs(", ")"}, {"1 if 1 < 2 else ", ""}}) {
        CHECK(told(repeated(open, depth) + "1" + repeated(close, depth)) == "");
        CHECK(told(repeated(open, depth + 1) + "1" + repeated(close, depth + 1)).starts_with("E0123"));
        CHECK(told(repeated(open, 30000)).starts_with("E0123"));
    }
    const int terms = most_expression_nodes / 2;  // n terms are 2 n - 1 nodes
    CHECK(told("-1" + repeated(" + 1", terms - 1)) == "");
    CHECK(told("--1" + repeated(" + 1", terms - 1)).starts_with("E0124"));
    CHECK(told("-min(1" + repeated(", 1", terms - 1) + ")") == "");
}

TEST_CASE("what an expression depends on is listed once each, in the order of its text") {
    const Expression expression = parsed("gap + petal * 2 - gap + flip.angle + sin(petal) + pi");
    std::string names;
    for (const ExpressionName& name : expression.names) names += name.text + "@" + std::to_string(name.span.begin) + " ";
    CHECK(names == "gap@0 petal@6 flip.angle@24 ");
    CHECK(is_reserved_name("else"));
    CHECK(is_reserved_name("pi"));
    CHECK_FALSE(is_reserved_name("length"));  // a bracket behind it makes the difference
    CHECK(value("length(length, 4)", {3}) == 5);
}

TEST_CASE("the same tree gives derivatives for a scalar that brings its own operations") {
    for (const char* text : {"x ^ 3 - 2 * x", "sin(40 * x) / x", "exp(-x) + log(x)", "x ^ 1.5", "atan2(x, 2) % 7", "max(x, 1) * abs(x - 9)",
                             "mix(x, x ^ 2, 0.3)", "smoothstep(0, 4, x)", "length(x, 3)", "x if x < 2 else sqrt(x)", "x ^ -2", "clamp(x, 0, 1) + tan(x)"}) {
        const Expression expression = parsed(text);
        for (const double x : {0.7, 1.9, 2.5}) {
            const std::vector<Slope> names{Slope(x, 1)};
            const double h = 1e-5, low = value(text, {x - h}), high = value(text, {x + h});
            const Slope slope = expressions::value_of<Slope>(expression, names);
            INFO(text << " at " << x);
            CHECK(slope.v == Approx(value(text, {x})).epsilon(1e-12));
            CHECK(slope.d == Approx((high - low) / (2 * h)).epsilon(1e-6).margin(1e-8));
        }
    }
}

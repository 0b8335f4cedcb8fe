#include "tests/expression/random_expression.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engine/core/at.h"

namespace pinfield::test {
namespace {

using O = Operation;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double degree = 0.017453292519943295;

struct Spelled {
    Operation operation;
    std::string_view text;
    int level;  ///< 0: a function
    std::size_t count;
};
constexpr std::array spelled{
    Spelled{O::either, "or", 1, 2},        Spelled{O::both, "and", 2, 2},      Spelled{O::less, "<", 4, 2},
    Spelled{O::less_or_equal, "<=", 4, 2}, Spelled{O::greater, ">", 4, 2},     Spelled{O::greater_or_equal, ">=", 4, 2},
    Spelled{O::equal, "==", 4, 2},         Spelled{O::not_equal, "!=", 4, 2},  Spelled{O::add, "+", 5, 2},
    Spelled{O::subtract, "-", 5, 2},       Spelled{O::multiply, "*", 6, 2},    Spelled{O::divide, "/", 6, 2},
    Spelled{O::modulo, "%", 6, 2},         Spelled{O::power, "^", 8, 2},       Spelled{O::minimum, "min", 0, 2},
    Spelled{O::maximum, "max", 0, 2},      Spelled{O::clamp, "clamp", 0, 3},   Spelled{O::absolute, "abs", 0, 1},
    Spelled{O::floor, "floor", 0, 1},      Spelled{O::ceiling, "ceil", 0, 1},  Spelled{O::root, "sqrt", 0, 1},
    Spelled{O::sine, "sin", 0, 1},         Spelled{O::cosine, "cos", 0, 1},    Spelled{O::tangent, "tan", 0, 1},
    Spelled{O::arc_tangent, "atan2", 0, 2}, Spelled{O::sign, "sign", 0, 1},    Spelled{O::exponential, "exp", 0, 1},
    Spelled{O::logarithm, "log", 0, 1},    Spelled{O::length, "length", 0, 2}, Spelled{O::mix, "mix", 0, 3},
    Spelled{O::smoothstep, "smoothstep", 0, 3},
};

const Spelled& spelling(Operation operation) {
    for (const Spelled& s : spelled)
        if (s.operation == operation) return s;
    return spelled[0];
}
bool chance(CounterRng& rng, double share) { return rng.uniform() < share; }

bool is_comparison(Operation operation) { return operation >= O::less && operation <= O::not_equal; }
bool is_condition(Operation operation) { return operation >= O::less && operation <= O::either; }

Tree with(CounterRng& rng, const Spelled& what, int depth, Tree (*operand)(CounterRng&, int)) {
    Tree out{what.operation, {}, 0, 0};
    for (std::size_t i = 0; i < what.count; ++i) out.operands.push_back(operand(rng, depth - 1));
    return out;
}

Tree random_condition(CounterRng& rng, int depth) {
    const auto kind = depth < 1 ? 3 : rng.next_u64() % 6;
    if (kind == 0) return with(rng, {O::invert, "not", 3, 1}, depth, random_condition);
    if (kind < 3) return with(rng, spelled[kind - 1], depth, random_condition);
    return with(rng, spelled[2 + rng.next_u64() % 6], depth, random_number);
}

/// How tightly a tree holds together, as it is written.
int level_of(const Tree& tree) {
    if (tree.operation == O::choose) return 0;
    if (tree.operation == O::invert) return 3;
    if (tree.operation == O::negate) return 7;
    const bool is_leaf = tree.operation == O::literal || tree.operation == O::name;
    return is_leaf || spelling(tree.operation).level == 0 ? 9 : spelling(tree.operation).level;
}

/// An operand, in brackets where it holds together less tightly than `least`.
std::string within(const Tree& tree, int least, CounterRng& rng, double more) {
    const std::string text = printed(tree, rng, more);
    return level_of(tree) < least || chance(rng, more) ? "(" + text + ")" : text;
}

bool holds(const Tree& tree, const std::array<double, 3>& names) {
    if (tree.operation == O::invert) return !holds(tree.operands[0], names);
    if (tree.operation == O::both) return holds(tree.operands[0], names) && holds(tree.operands[1], names);
    if (tree.operation == O::either) return holds(tree.operands[0], names) || holds(tree.operands[1], names);
    const double a = direct_value(tree.operands[0], names), b = direct_value(tree.operands[1], names);
    switch (tree.operation) {
        case O::less: return a < b;
        case O::less_or_equal: return a <= b;
        case O::greater: return a > b;
        case O::greater_or_equal: return a >= b;
        case O::equal: return a == b;
        default: return a != b;
    }
}

double of_numbers(Operation operation, double a, double b, double c) {
    switch (operation) {
        case O::negate: return -a;
        case O::add: return a + b;
        case O::subtract: return a - b;
        case O::multiply: return a * b;
        case O::divide: return a / b;
        case O::modulo: return b == 0 ? nan : a - b * std::floor(a / b);
        case O::power: return std::pow(a, b);
        case O::minimum: return std::fmin(a, b);
        case O::maximum: return std::fmax(a, b);
        case O::clamp: return std::fmin(std::fmax(a, b), c);
        case O::absolute: return std::fabs(a);
        case O::floor: return std::floor(a);
        case O::ceiling: return std::ceil(a);
        case O::root: return std::sqrt(a);
        case O::sine: return std::sin(a * degree);
        case O::cosine: return std::cos(a * degree);
        case O::tangent: return std::tan(a * degree);
        case O::arc_tangent: return std::atan2(a, b) / degree;
        case O::sign: return a > 0 ? 1 : a < 0 ? -1 : 0;
        case O::exponential: return std::exp(a);
        case O::logarithm: return std::log(a);
        case O::length: return std::sqrt(a * a + b * b);
        case O::mix: return a + (b - a) * c;
        default: {
            const double t = std::fmin(std::fmax((c - a) / (b - a), 0), 1);
            return a == b ? nan : t * t * (3 - 2 * t);
        }
    }
}

}  // namespace

Tree random_number(CounterRng& rng, int depth) {
    if (depth < 1 || chance(rng, 0.1)) {
        const bool literal = chance(rng, 0.5);
        const auto which = static_cast<int>(rng.next_u64() % 3);
        return {literal ? O::literal : O::name, {}, static_cast<int>(rng.next_u64() % 10), which};
    }
    if (chance(rng, 0.1)) return with(rng, {O::negate, "-", 7, 1}, depth, random_number);
    if (chance(rng, 0.1)) {
        Tree out{O::choose, {random_condition(rng, depth - 1)}, 0, 0};
        for (int i = 0; i < 2; ++i) out.operands.push_back(random_number(rng, depth - 1));
        return out;
    }
    const std::size_t first = 8, count = chance(rng, 0.6) ? 6 : spelled.size() - first;
    return with(rng, spelled[first + rng.next_u64() % count], depth, random_number);
}

std::string printed(const Tree& tree, CounterRng& rng, double more) {
    const auto operand = [&](std::size_t i, int least) { return within(tree.operands[i], least, rng, more); };
    const std::string blank = chance(rng, more) ? "" : " ";
    switch (tree.operation) {
        case O::literal: return fmt::format("{}", tree.number);
        case O::name: return at(name_texts, tree.name);
        case O::negate: return "-" + operand(0, 7);
        case O::invert: return "not " + operand(0, 3);
        case O::choose: return fmt::format("{} if {} else {}", operand(1, 1), operand(0, 1), operand(2, 0));
        default: break;
    }
    const Spelled& how = spelling(tree.operation);
    if (how.level == 0) {
        std::string list;
        for (const Tree& each : tree.operands) list += (list.empty() ? "" : "," + blank) + within(each, 0, rng, more);
        return fmt::format("{}{}({})", how.text, chance(rng, more) ? " " : "", list);
    }
    // Sums group to the left, powers to the right and with a sign; comparisons not at all.
    const bool is_power = tree.operation == O::power, is_word = how.level < 4;
    const std::string left = operand(0, is_power || is_comparison(tree.operation) ? how.level + 1 : how.level);
    const std::string right = operand(1, is_power ? 7 : how.level + 1);
    return left + (is_word ? " " : blank) + std::string(how.text) + (is_word ? " " : blank) + right;
}

double direct_value(const Tree& tree, const std::array<double, 3>& names) {
    if (tree.operation == O::literal) return tree.number;
    if (tree.operation == O::name) return at(names, tree.name);
    if (tree.operation == O::choose) return direct_value(tree.operands[holds(tree.operands[0], names) ? 1 : 2], names);
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < tree.operands.size(); ++i) {
        values[i] = is_condition(tree.operands[i].operation) ? nan : direct_value(tree.operands[i], names);
        if (!std::isfinite(values[i])) return nan;
    }
    const double value = of_numbers(tree.operation, values[0], values[1], values[2]);
    return std::isfinite(value) ? value : nan;
}

bool says(const Expression& expression, int index, const Tree& tree) {
    const ExpressionNode& node = at(expression.nodes, index);
    if (node.operation != tree.operation) return false;
    if (tree.operation == O::literal) return node.value == tree.number;
    if (tree.operation == O::name) return at(expression.names, node.operands[0]).text == at(name_texts, tree.name);
    for (std::size_t i = 0; i < 3; ++i) {
        if ((node.operands[i] < 0) != (i >= tree.operands.size())) return false;
        if (i < tree.operands.size() && !says(expression, node.operands[i], tree.operands[i])) return false;
    }
    return true;
}

}  // namespace pinfield::test

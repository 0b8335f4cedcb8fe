#include "engine/expression/measure.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <utility>

#include "engine/core/at.h"
#include "engine/expression/evaluate.h"

namespace pinfield {
namespace {

constexpr Dimension an_angle{0, 1, 0, 0};
constexpr int highest_exponent = 60;  // of a dimension; products beyond it are a mistake

/// a * b^times, or nothing where exponents grow out of reason.
std::optional<Dimension> product(const Dimension& a, const Dimension& b, int times) {
    const auto sum = [&](signed char x, signed char y) { return x + times * y; };
    const int length = sum(a.length, b.length), angle = sum(a.angle, b.angle), time = sum(a.time, b.time), mass = sum(a.mass, b.mass);
    for (const int exponent : {length, angle, time, mass})
        if (std::abs(exponent) > highest_exponent) return {};
    return Dimension{static_cast<signed char>(length), static_cast<signed char>(angle), static_cast<signed char>(time),
                     static_cast<signed char>(mass)};
}

/// The dimension to the power of `exponent`, or nothing where that is not whole.
std::optional<Dimension> raised(const Dimension& a, double exponent) {
    const auto whole = [&](signed char x) { return std::floor(x * exponent) == x * exponent && std::fabs(x * exponent) <= highest_exponent; };
    const auto times = [&](signed char x) { return static_cast<signed char>(x * exponent); };
    if (!whole(a.length) || !whole(a.angle) || !whole(a.time) || !whole(a.mass)) return {};
    return Dimension{times(a.length), times(a.angle), times(a.time), times(a.mass)};
}

std::string_view sign_of(Operation operation) {
    switch (operation) {
        case Operation::add: return "+";
        case Operation::subtract: return "-";
        case Operation::modulo: return "%";
        case Operation::less: return "<";
        case Operation::less_or_equal: return "<=";
        case Operation::greater: return ">";
        case Operation::greater_or_equal: return ">=";
        case Operation::equal: return "==";
        case Operation::not_equal: return "!=";
        case Operation::choose: return "if ... else";
        default: return "the commas";
    }
}

class Measuring {
public:
    Measuring(const Expression& expression, std::span<const Measure> names) : expression_(expression), names_(names) {}

    tl::expected<std::vector<Measure>, ExpressionError> run() && {
        for (const ExpressionNode& node : expression_.nodes) {  // operands come before what they belong to
            Measure measure = of(node);
            if (error_) return tl::unexpected(std::move(*error_));
            measures_.push_back(measure);
        }
        return std::move(measures_);
    }

private:
    std::string_view text(int index) const { return expression_.slice(at(expression_.nodes, index).span); }
    const Measure& given(int index) const { return at(measures_, index); }

    void report(Span span, std::string message, std::string hint = {}, Code code = Code::wrong_dimension) {
        if (!error_) error_ = ExpressionError{code, span, std::move(message), std::move(hint)};
    }

    /// The operand must be a number, or must be a condition.
    bool is_of_sort(int index, bool condition) {
        if (given(index).condition == condition) return true;
        const Span span = at(expression_.nodes, index).span;
        if (condition) report(span, fmt::format("{} is a number where a condition is due", text(index)), "compare it with something: ... > 0");
        else report(span, fmt::format("{} is a condition where a number is due", text(index)), "write 1 if ... else 0", Code::wrong_type);
        return false;
    }

    Measure is_due(int index, const Dimension& due, std::string hint) {
        const Measure& m = given(index);
        if (!is_of_sort(index, false) || m.dimension == due || m.adapts()) return m;
        report(at(expression_.nodes, index).span,
               fmt::format("{} is {} where {} is due", text(index), measured(m.dimension), measured(due)), std::move(hint));
        return {};
    }

    /// What two that must measure the same have in common.
    Measure common(Operation operation, int a, int b) {
        if (!is_of_sort(a, false) || !is_of_sort(b, false)) return {};
        const Measure &x = given(a), &y = given(b);
        if (x.dimension == y.dimension) return {x.dimension, x.bare && y.bare, false};
        if (x.adapts()) return {y.dimension, false, false};
        if (y.adapts()) return {x.dimension, false, false};
        const std::string units = suffixes_of(x.dimension);
        report(at(expression_.nodes, b).span,
               fmt::format("{} is {}, but {} is {}", text(b), measured(y.dimension), text(a), measured(x.dimension)),
               fmt::format("both sides of {} measure the same{}", sign_of(operation), units.empty() ? "" : "; units here: " + units));
        return {};
    }

    Measure all_common(const ExpressionNode& node, std::size_t first) {
        const int last = node.operands[first + 1];
        Measure out = common(node.operation, node.operands[first], last);
        if (error_ || first > 0 || node.operands[2] < 0) return out;
        const Measure others = common(node.operation, node.operands[1], node.operands[2]);
        if (error_) return {};
        const Measure& one = given(node.operands[0]);
        common(node.operation, node.operands[0], node.operands[2]);
        return {one.adapts() ? others.dimension : one.dimension, out.bare && others.bare, false};
    }

    Measure combined(const ExpressionNode& node, int times) {
        const int a = node.operands[0], b = node.operands[1];
        if (!is_of_sort(a, false) || !is_of_sort(b, false)) return {};
        const auto dimension = product(given(a).dimension, given(b).dimension, times);
        if (!dimension) return report(node.span, fmt::format("{} multiplies too many units", expression_.slice(node.span))), Measure{};
        return {*dimension, given(a).bare || given(b).bare, false};
    }

    bool depends_on_names(int index) const {
        const ExpressionNode& node = at(expression_.nodes, index);
        if (node.operation == Operation::name) return true;
        bool depends = false;
        for (const int operand : node.operands) depends = depends || (operand >= 0 && depends_on_names(operand));
        return depends;
    }

    Measure powered(const ExpressionNode& node) {
        const int base = node.operands[0], exponent = node.operands[1];
        is_due(exponent, {}, "an exponent has no unit");
        if (error_ || !is_of_sort(base, false)) return {};
        const Measure& m = given(base);
        if (m.dimension.is_plain()) return m;
        if (depends_on_names(exponent))
            return report(at(expression_.nodes, exponent).span,
                          fmt::format("{} is {}: its exponent must be a number, not {}", text(base), measured(m.dimension), text(exponent)),
                          fmt::format("divide it by 1{} first", symbol(m.dimension))),
                   Measure{};
        const double value = expressions::Evaluation<double>(expression_, {}).number(exponent);
        const auto dimension = raised(m.dimension, value);
        if (!dimension) return report(node.span, fmt::format("{} has no unit that there is", expression_.slice(node.span))), Measure{};
        return {*dimension, m.bare, false};
    }

    Measure rooted(const ExpressionNode& node) {
        const int square = node.operands[0];
        if (!is_of_sort(square, false)) return {};
        const auto dimension = raised(given(square).dimension, 0.5);
        if (dimension) return {*dimension, given(square).bare, false};
        report(node.span, fmt::format("the root of {} has no unit", measured(given(square).dimension)), "the root of an area is a length");
        return {};
    }

    Measure plain(const ExpressionNode& node) {
        const Measure& m = given(node.operands[0]);
        is_due(node.operands[0], {}, fmt::format("divide it by a unit: floor(x / 1{0}) * 1{0}", symbol(m.dimension)));
        return {{}, m.bare, false};
    }

    Measure angled(const ExpressionNode& node) {
        is_due(node.operands[0], an_angle, "angles are in degrees: sin(30), or sin(0.5rad)");
        return {};
    }

    Measure mixed(const ExpressionNode& node) {
        is_due(node.operands[2], {}, "the third is a share: 0 gives the first, 1 the second");
        return error_ ? Measure{} : common(node.operation, node.operands[0], node.operands[1]);
    }

    Measure conditions(const ExpressionNode& node) {
        for (const int operand : node.operands)
            if (operand >= 0) is_of_sort(operand, true);
        return {{}, false, true};
    }

    Measure of(const ExpressionNode& node) {
        switch (node.operation) {
            case Operation::literal: return node.measure;
            case Operation::name: return names_[static_cast<std::size_t>(node.operands[0])];
            case Operation::negate:
            case Operation::absolute: return is_of_sort(node.operands[0], false) ? given(node.operands[0]) : Measure{};
            case Operation::multiply: return combined(node, 1);
            case Operation::divide: return combined(node, -1);
            case Operation::power: return powered(node);
            case Operation::root: return rooted(node);
            case Operation::floor:
            case Operation::ceiling:
            case Operation::exponential:
            case Operation::logarithm: return plain(node);
            case Operation::sine:
            case Operation::cosine:
            case Operation::tangent: return angled(node);
            case Operation::arc_tangent: common(node.operation, node.operands[0], node.operands[1]); return {an_angle, false, false};
            case Operation::sign: is_of_sort(node.operands[0], false); return {};
            case Operation::mix: return mixed(node);
            case Operation::smoothstep: all_common(node, 0); return {};
            case Operation::choose: return is_of_sort(node.operands[0], true) ? all_common(node, 1) : Measure{};
            case Operation::invert:
            case Operation::both:
            case Operation::either: return conditions(node);
            case Operation::less:
            case Operation::less_or_equal:
            case Operation::greater:
            case Operation::greater_or_equal:
            case Operation::equal:
            case Operation::not_equal: common(node.operation, node.operands[0], node.operands[1]); return {{}, false, true};
            default: return all_common(node, 0);  // + - % min max clamp length
        }
    }

    const Expression& expression_;
    std::span<const Measure> names_;
    std::vector<Measure> measures_;
    std::optional<ExpressionError> error_;
};

}  // namespace

tl::expected<std::vector<Measure>, ExpressionError> measures_of(const Expression& expression, std::span<const Measure> names) {
    return Measuring(expression, names).run();
}

tl::expected<Measure, ExpressionError> measure_of(const Expression& expression, std::span<const Measure> names) {
    auto all = measures_of(expression, names);
    if (!all) return tl::unexpected(std::move(all.error()));
    return all->back();
}

std::optional<ExpressionError> why_unfit(const Expression& expression, const Measure& given, const Dimension& due) {
    const Span span = expression.nodes.back().span;
    const std::string_view text = expression.slice(span);
    if (given.condition)
        return ExpressionError{Code::wrong_type, span, fmt::format("{} is a condition where a number is due", text), "write 1 if ... else 0"};
    if (given.dimension == due || given.adapts()) return {};
    std::string hint = suffixes_of(due).empty() ? fmt::format("divide it by 1{}", symbol(given.dimension)) : "units here: " + suffixes_of(due);
    if (given.dimension.is_plain()) hint = fmt::format("multiply it by 1{}", symbol(due));
    return ExpressionError{Code::wrong_dimension, span, fmt::format("{} is {} where {} is due", text, measured(given.dimension), measured(due)),
                           std::move(hint)};
}

}  // namespace pinfield

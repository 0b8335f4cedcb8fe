#include "engine/expression/evaluate.h"

#include <fmt/format.h>

#include <cassert>

namespace pinfield {
namespace expressions {

double modulo(double a, double b) {
    const double rest = std::fmod(a, b);  // exact, hence the same everywhere
    if (rest == 0 || (rest < 0) == (b < 0)) return rest;
    const double turned = rest + b;
    return turned == b ? 0 : turned;
}

double power(double a, double b) {
    if (is_whole_power(b)) return whole_power(a, static_cast<int>(b));
    if (a == 0 && b > 0) return 0;
    return exponential(b * logarithm(a));  // no number below 0
}

template class Evaluation<double>;

}  // namespace expressions

namespace {

/// Why a node has no value whose operands have some.
ExpressionError fault_at(const Expression& expression, const ExpressionNode& node) {
    const std::string_view text = expression.slice(node.span);
    const auto because = [&](std::string_view why, std::string hint = {}) {
        return ExpressionError{Code::no_value, node.span, fmt::format("{} {}", text, why), std::move(hint)};
    };
    const auto operand = [&](std::size_t i) { return expression.slice(at(expression.nodes, node.operands[i]).span); };
    switch (node.operation) {
        case Operation::divide:
        case Operation::modulo: return because(fmt::format("divides by {}, which is 0 here, or nearly", operand(1)));
        case Operation::root: return because("is the root of a number below 0", "abs(...) or max(0, ...) keeps it above");
        case Operation::logarithm: return because("is the logarithm of a number that is not above 0");
        case Operation::tangent: return because("has no value: the tangent of 90deg is infinite");
        case Operation::smoothstep: return because(fmt::format("has no step: {} and {} are the same here", operand(0), operand(1)));
        case Operation::power: return because("has no value, or one too large for a number");
        default: return because("is too large for a number");
    }
}

}  // namespace

tl::expected<double, ExpressionError> evaluate(const Expression& expression, std::span<const double> names) {
    assert(names.size() == expression.names.size() && "evaluate() takes one value for each name");
    expressions::Evaluation<double> evaluation(expression, names);
    const double value = evaluation.number(expression.root());
    if (evaluation.fault() < 0) return value;
    return tl::unexpected(fault_at(expression, at(expression.nodes, evaluation.fault())));
}

}  // namespace pinfield

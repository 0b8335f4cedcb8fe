#include "engine/sdf/branches.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/core/at.h"
#include "engine/expression/evaluate.h"

namespace pinfield::sdf {
namespace {

using O = Operation;

/// A part of an expression with everything worked out that can be; a condition that is known is the literal 1 or 0.
struct Term {
    O operation = O::literal;
    double value = 0;  ///< of a literal; of a name: which
    std::vector<Term> operands;

    bool operator==(const Term&) const = default;
    bool is_literal() const { return operation == O::literal; }
    bool is(double number) const { return is_literal() && value == number; }
};

Term literal(double value) { return {O::literal, value == 0 ? 0 : value, {}}; }
bool is_comparison(O operation) { return operation >= O::less && operation <= O::not_equal; }

/// Of literals.
std::optional<Term> worked_out(O operation, const std::vector<Term>& in) {
    if (in.empty() || !std::all_of(in.begin(), in.end(), [](const Term& t) { return t.is_literal(); })) return {};
    const bool chooses = operation == O::invert || operation == O::both || operation == O::either || is_comparison(operation);
    if (operation == O::invert) return literal(in[0].value == 0 ? 1 : 0);
    if (operation == O::both || operation == O::either) {
        const bool a = in[0].value != 0, b = in[1].value != 0;
        return literal((operation == O::both ? a && b : a || b) ? 1 : 0);
    }
    Expression sum;
    const auto add = [&](O o, double value) {
        ExpressionNode node;
        node.operation = o;
        node.value = value;
        sum.nodes.push_back(node);
    };
    for (const Term& term : in) add(O::literal, term.value);
    add(operation, 0);
    for (std::size_t i = 0; i < in.size(); ++i) sum.nodes.back().operands[i] = static_cast<int>(i);
    if (chooses) {
        const int comparison = sum.root();
        add(O::literal, 1);
        add(O::literal, 0);
        add(O::choose, 0);
        sum.nodes.back().operands = {comparison, comparison + 1, comparison + 2};
    }
    expressions::Evaluation<double> evaluation(sum, {});
    const double value = evaluation.number(sum.root());
    return evaluation.fault() < 0 ? std::optional(literal(value)) : std::nullopt;
}

Term made(O operation, std::vector<Term> in);
Term size_of(const Term& term) { return made(O::absolute, {term}); }

std::optional<Term> simpler(O operation, const std::vector<Term>& in) {
    switch (operation) {
        case O::choose:
            if (in[0].is_literal()) return in[0].value != 0 ? in[1] : in[2];
            return in[1] == in[2] ? std::optional(in[1]) : std::nullopt;
        case O::add:
            if (in[0].is(0)) return in[1];
            return in[1].is(0) ? std::optional(in[0]) : std::nullopt;
        case O::subtract:
            if (in[0].is(0)) return made(O::negate, {in[1]});
            if (in[0] == in[1]) return literal(0);
            return in[1].is(0) ? std::optional(in[0]) : std::nullopt;
        case O::multiply:
            if (in[0].is(0) || in[1].is(0)) return literal(0);
            if (in[0].is(1)) return in[1];
            return in[1].is(1) ? std::optional(in[0]) : std::nullopt;
        case O::divide:
            if (in[0].is(0)) return literal(0);
            return in[1].is(1) ? std::optional(in[0]) : std::nullopt;
        case O::length:
            if (in[0].is(0)) return size_of(in[1]);
            return in[1].is(0) ? std::optional(size_of(in[0])) : std::nullopt;
        case O::root:
            if (in[0].operation == O::power && in[0].operands[1].is(2)) return size_of(in[0].operands[0]);
            if (in[0].operation == O::multiply && in[0].operands[0] == in[0].operands[1]) return size_of(in[0].operands[0]);
            return {};
        case O::minimum:
        case O::maximum: return in[0] == in[1] ? std::optional(in[0]) : std::nullopt;
        case O::negate: return in[0].operation == O::negate ? std::optional(in[0].operands[0]) : std::nullopt;
        case O::absolute: {
            if (in[0].operation == O::negate) return size_of(in[0].operands[0]);
            const bool is_size = in[0].operation == O::absolute || in[0].operation == O::length || in[0].operation == O::root;
            return is_size ? std::optional(in[0]) : std::nullopt;
        }
        default: return {};
    }
}

Term made(O operation, std::vector<Term> in) {
    if (auto known = worked_out(operation, in)) return std::move(*known);
    if (auto other = simpler(operation, in)) return std::move(*other);
    return {operation, 0, std::move(in)};
}

/// The term of a node, with `by` in place of every part that is `what`.
Term term_of(const Expression& expression, int index, const Term* what = nullptr, const Term* by = nullptr) {
    const ExpressionNode& node = at(expression.nodes, index);
    if (node.operation == O::literal) return literal(node.value);
    if (what && term_of(expression, index) == *what) return *by;
    if (node.operation == O::name) return {O::name, static_cast<double>(node.operands[0]), {}};
    std::vector<Term> in;
    for (const int operand : node.operands)
        if (operand >= 0) in.push_back(term_of(expression, operand, what, by));
    return made(node.operation, std::move(in));
}

}  // namespace

bool branches_meet(const Expression& expression, int choice) {
    constexpr std::size_t most_nodes = 200;  // each is compared as a whole: of more, that takes too long
    if (expression.nodes.size() > most_nodes) return false;
    const ExpressionNode& node = at(expression.nodes, choice);
    const ExpressionNode& condition = at(expression.nodes, node.operands[0]);
    if (!is_comparison(condition.operation) || condition.operation == O::equal || condition.operation == O::not_equal) return false;
    const Term left = term_of(expression, condition.operands[0]), right = term_of(expression, condition.operands[1]);
    const Term &what = left.is_literal() ? right : left, &by = left.is_literal() ? left : right;
    if (what.is_literal()) return false;
    return term_of(expression, node.operands[1], &what, &by) == term_of(expression, node.operands[2], &what, &by);
}

}  // namespace pinfield::sdf

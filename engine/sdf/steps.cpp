#include "engine/sdf/steps.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/at.h"
#include "engine/reflect/text_fault.h"
#include "engine/sdf/branches.h"

namespace pinfield::sdf {
namespace {

constexpr Dimension a_length{1, 0, 0, 0};

TextFault fault_of(ExpressionError error) { return {error.code, error.span, std::move(error.message), std::move(error.hint)}; }

/// Which of x and y a name is, or -1.
int coordinate(const ExpressionName& name) { return name.text == "x" ? 0 : name.text == "y" ? 1 : -1; }

/// Copies a folded expression's tree, rewritten as steps.h says.
class Rewriting {
public:
    explicit Rewriting(const Expression& from) : from_(from) {}

    std::vector<ExpressionNode> run() && {
        copy(from_.root());
        return std::move(out_);
    }

private:
    const ExpressionNode& node(int index) const { return at(from_.nodes, index); }
    bool is(int index, Operation operation) const { return node(index).operation == operation; }
    bool is_literal(int index, double value) const { return is(index, Operation::literal) && node(index).value == value; }

    bool same(int a, int b) const {
        const ExpressionNode &x = node(a), &y = node(b);
        if (x.operation != y.operation) return false;
        if (x.operation == Operation::literal) return x.value == y.value;
        if (x.operation == Operation::name) return x.operands[0] == y.operands[0];
        for (std::size_t i = 0; i < 3; ++i)
            if ((x.operands[i] < 0) != (y.operands[i] < 0) || (x.operands[i] >= 0 && !same(x.operands[i], y.operands[i]))) return false;
        return true;
    }
    /// What the node is the square of, or -1.
    int root_of(int index) const {
        const ExpressionNode& n = node(index);
        if (n.operation == Operation::multiply && same(n.operands[0], n.operands[1])) return n.operands[0];
        return n.operation == Operation::power && is_literal(n.operands[1], 2) ? n.operands[0] : -1;
    }

    int add(Operation operation, std::array<int, 3> operands, Span span, double value = 0) {
        ExpressionNode out;
        out.operation = operation;
        out.operands = operands;
        out.value = value;
        out.span = span;
        out_.push_back(out);
        return static_cast<int>(out_.size()) - 1;
    }
    int literal(double value, Span span) { return add(Operation::literal, {-1, -1, -1}, span, value); }
    /// 0 + 0 is 0, whatever the sign of the first.
    int without_sign_of_zero(int operand) {
        if (is(operand, Operation::literal) && node(operand).value != 0) return copy(operand);
        const int copied = copy(operand);
        return add(Operation::add, {copied, literal(0, node(operand).span), -1}, node(operand).span);
    }

    int copy(int index) {
        const ExpressionNode& n = node(index);
        const auto operand = [&](std::size_t i) { return n.operands[i]; };
        switch (n.operation) {
            case Operation::name: return add(n.operation, {coordinate(at(from_.names, n.operands[0])), -1, -1}, n.span);
            case Operation::multiply:
                if (root_of(index) < 0) break;
                return squared(root_of(index), n.span);
            case Operation::root: {
                const ExpressionNode& sum = node(operand(0));
                if (sum.operation != Operation::add || root_of(sum.operands[0]) < 0 || root_of(sum.operands[1]) < 0) break;
                const int a = copy(root_of(sum.operands[0]));
                return add(Operation::length, {a, copy(root_of(sum.operands[1])), -1}, n.span);
            }
            case Operation::absolute: {
                const ExpressionNode& angle = node(operand(0));
                if (angle.operation != Operation::arc_tangent) break;
                const int size = add(Operation::absolute, {copy(angle.operands[0]), -1, -1}, angle.span);
                return add(Operation::arc_tangent, {size, copy(angle.operands[1]), -1}, n.span);
            }
            case Operation::divide: {
                const int a = copy(operand(0));
                return add(n.operation, {a, without_sign_of_zero(operand(1)), -1}, n.span);
            }
            case Operation::arc_tangent: {
                const int y = without_sign_of_zero(operand(0));
                return add(n.operation, {y, copy(operand(1)), -1}, n.span);
            }
            default: break;
        }
        std::array<int, 3> operands{-1, -1, -1};
        for (std::size_t i = 0; i < 3; ++i)
            if (operand(i) >= 0) operands[i] = copy(operand(i));
        const bool meets = n.operation == Operation::choose && branches_meet(from_, index);
        return add(n.operation, operands, n.span, meets ? 1 : n.value);
    }
    int squared(int root, Span span) {
        const int base = copy(root);
        return add(Operation::power, {base, literal(2, span), -1}, span);
    }

    const Expression& from_;
    std::vector<ExpressionNode> out_;
};

void append(const std::vector<ExpressionNode>& nodes, std::vector<double>& block) {
    for (const ExpressionNode& node : nodes) {
        block.push_back(static_cast<double>(node.operation));
        for (const int operand : node.operands) block.push_back(operand);
        block.push_back(node.value);
        block.push_back(static_cast<double>(node.span.begin));
        block.push_back(static_cast<double>(node.span.end));
    }
}

}  // namespace

std::optional<TextFault> Steps::pack(std::string_view text, std::vector<double>& block) {
    auto expression = parse_expression(text);
    if (!expression) return fault_of(std::move(expression.error()));
    for (const ExpressionName& name : expression->names)
        if (coordinate(name) < 0)
            return TextFault{Code::unknown_name, name.span, fmt::format("nothing is called {} here", name.text), "x and y are the point's"};
    const std::vector<Measure> lengths(expression->names.size(), Measure{a_length, false, false});
    auto measure = measure_of(*expression, lengths);
    if (!measure) return fault_of(std::move(measure.error()));
    if (auto unfit = why_unfit(*expression, *measure, a_length)) return fault_of(std::move(*unfit));
    append(Rewriting(folded(*expression, lengths)).run(), block);
    return {};
}

}  // namespace pinfield::sdf

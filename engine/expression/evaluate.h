// The one evaluation of an expression's tree, for any scalar. For double see expression.h; whoever has another scalar includes this and
// brings, where argument-dependent lookup finds them: + - * / < <= > >=, `sqrt floor abs min max select both either invert` (as in
// engine/sdf/scalar.h), and `sine_degrees cosine_degrees arc_tangent exponential logarithm`. `is_number`, `modulo`, `power`, `hypotenuse`,
// `joined` and `arc_tangent_degrees` have general forms below, which a scalar's own replace.
#pragma once
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>

#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/expression/expression.h"

namespace pinfield::expressions {

inline double sqrt(double a) { return std::sqrt(a); }
inline double floor(double a) { return std::floor(a); }
inline double abs(double a) { return std::fabs(a); }
inline double min(double a, double b) { return b < a ? b : a; }
inline double max(double a, double b) { return a < b ? b : a; }
inline double select(bool condition, double yes, double no) { return condition ? yes : no; }
inline bool both(bool a, bool b) { return a && b; }
inline bool either(bool a, bool b) { return a || b; }
inline bool invert(bool a) { return !a; }

/// Is it a number, or what comes of having none? Scalars of many values say yes.
inline bool is_number(double a) { return std::isfinite(a); }
template <class Real>
bool is_number(const Real&) { return true; }

/// a - b floor(a / b), floored as in mathematics: the result is 0 or has the sign of b, so that -1 % 3 is 2. For double without rounding
/// but the last, and never b itself.
double modulo(double a, double b);
template <class Real>
Real modulo(const Real& a, const Real& b) { return a - b * floor(a / b); }

/// a^b by logarithms; a double's whole exponents by multiplication.
double power(double a, double b);
template <class Real>
Real power(const Real& a, const Real& b) { return exponential(b * logarithm(a)); }

template <class Real>
Real hypotenuse(const Real& a, const Real& b) { return sqrt(a * a + b * b); }
/// Of two that are the same where one gives way to the other.
template <class Mask, class Real>
Real joined(const Mask& condition, const Real& yes, const Real& no) { return select(condition, yes, no); }
/// In degrees.
template <class Real>
Real arc_tangent_degrees(const Real& y, const Real& x) { return arc_tangent(y, x) * Real(180 / pi); }

/// a^n by squaring (Knuth, TAOCP 4.6.3, algorithm A).
template <class Real>
Real whole_power(Real a, int n) {
    Real out(1);
    for (int left = n < 0 ? -n : n; left > 0; left /= 2, a = a * a)
        if (left % 2 != 0) out = out * a;
    return n < 0 ? Real(1) / out : out;
}
inline constexpr double largest_whole_power = 1024;
inline bool is_whole_power(double b) { return b == std::floor(b) && std::fabs(b) <= largest_whole_power; }

inline const ExpressionNode& node_at(const Expression& expression, int index) { return at(expression.nodes, index); }

/// Over an Expression, or over whatever else has its nodes: then node_at(tree, index) gives something with `operation`, `operands` and
/// `value`, everything has a value, be it infinite, and the branches of a choice whose own value is not 0 are known to meet.
template <class Real, class Tree = Expression>
class Evaluation {
public:
    using Node = decltype(node_at(std::declval<const Tree&>(), 0));
    using Mask = decltype(std::declval<const Real&>() < std::declval<const Real&>());

    Evaluation(const Tree& tree, std::span<const Real> names) : tree_(tree), names_(names) {}

    Real number(int index) {
        const Node node = node_at(tree_, index);
        const Real value = computed(node);
        if constexpr (!std::is_same_v<Tree, Expression>) return value;
        if (is_number(value)) return value;
        if (fault_ < 0) fault_ = index;
        return Real(0);
    }

    /// The first node that has no value, or -1.
    int fault() const { return fault_; }

private:
    using Plain = std::remove_cvref_t<Node>;

    Real operand(const Plain& node, int i) { return number(node.operands[static_cast<std::size_t>(i)]); }

    Mask condition(int index) {
        const Node node = node_at(tree_, index);
        if (node.operation == Operation::invert) return invert(condition(node.operands[0]));
        if (node.operation == Operation::both || node.operation == Operation::either) {
            const Mask a = condition(node.operands[0]);
            // Only what decides is looked at: `n != 0 and 1 / n > 2` has a value at 0.
            if constexpr (std::is_same_v<Mask, bool>)
                if (a == (node.operation == Operation::either)) return a;
            const Mask b = condition(node.operands[1]);
            return node.operation == Operation::both ? both(a, b) : either(a, b);
        }
        const Real a = operand(node, 0), b = operand(node, 1);
        switch (node.operation) {
            case Operation::less: return a < b;
            case Operation::less_or_equal: return a <= b;
            case Operation::greater: return a > b;
            case Operation::greater_or_equal: return a >= b;
            case Operation::equal: return both(a <= b, a >= b);
            default: return invert(both(a <= b, a >= b));
        }
    }

    Real chosen(const Plain& node) {
        const Mask decides = condition(node.operands[0]);
        if constexpr (std::is_same_v<Mask, bool>) return operand(node, decides ? 1 : 2);
        else if (node.value != 0) return joined(decides, operand(node, 1), operand(node, 2));
        else return select(decides, operand(node, 1), operand(node, 2));
    }

    Real raised(const Plain& node) {
        const Real base = operand(node, 0);
        const Node exponent = node_at(tree_, node.operands[1]);
        const bool negated = exponent.operation == Operation::negate;
        const Node digits = negated ? node_at(tree_, exponent.operands[0]) : exponent;
        if (digits.operation == Operation::literal && is_whole_power(digits.value))
            return whole_power(base, static_cast<int>(negated ? -digits.value : digits.value));
        return power(base, operand(node, 1));
    }

    Real stepped(const Plain& node) {
        const Real low = operand(node, 0), high = operand(node, 1), x = operand(node, 2);
        const Real t = min(max((x - low) / (high - low), Real(0)), Real(1));
        return t * t * (Real(3) - Real(2) * t);
    }

    Real computed(const Plain& node) {
        switch (node.operation) {
            case Operation::literal: return Real(node.value);
            case Operation::name: return names_[static_cast<std::size_t>(node.operands[0])];
            case Operation::choose: return chosen(node);
            case Operation::power: return raised(node);
            case Operation::smoothstep: return stepped(node);
            default: break;
        }
        const Real a = operand(node, 0);
        if (node.operands[1] < 0) return of_one(node.operation, a);
        const Real b = operand(node, 1);
        if (node.operation == Operation::clamp) return min(max(a, b), operand(node, 2));
        if (node.operation == Operation::mix) return a + (b - a) * operand(node, 2);
        return of_two(node.operation, a, b);
    }

    static Real of_one(Operation operation, const Real& a) {
        switch (operation) {
            case Operation::negate: return -a;
            case Operation::absolute: return abs(a);
            case Operation::floor: return floor(a);
            case Operation::ceiling: return Real(0) - floor(-a);
            case Operation::root: return sqrt(a);
            case Operation::sine: return sine_degrees(a);
            case Operation::cosine: return cosine_degrees(a);
            case Operation::tangent: return sine_degrees(a) / cosine_degrees(a);
            case Operation::exponential: return exponential(a);
            case Operation::logarithm: return logarithm(a);
            default: return select(Real(0) < a, Real(1), select(a < Real(0), Real(-1), Real(0)));  // sign
        }
    }

    static Real of_two(Operation operation, const Real& a, const Real& b) {
        switch (operation) {
            case Operation::add: return a + b;
            case Operation::subtract: return a - b;
            case Operation::multiply: return a * b;
            case Operation::divide: return a / b;
            case Operation::modulo: return modulo(a, b);
            case Operation::minimum: return min(a, b);
            case Operation::maximum: return max(a, b);
            case Operation::arc_tangent: return arc_tangent_degrees(a, b);
            default: return hypotenuse(a, b);  // length
        }
    }

    const Tree& tree_;
    std::span<const Real> names_;
    int fault_ = -1;
};

/// The expression's value for any scalar, its names' values parallel to Expression::names.
template <class Real>
Real value_of(const Expression& expression, std::span<const Real> names) {
    return Evaluation<Real>(expression, names).number(expression.root());
}

extern template class Evaluation<double>;

}  // namespace pinfield::expressions

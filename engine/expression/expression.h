// What a number may be written as: "petal * 1.6", "clamp(2 * gap, 30mm, 46mm)". Parsed once into a flat arena of nodes, each of which knows
// its bytes of the author's text; measured and evaluated as often as needed.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "engine/core/error_codes.h"
#include "engine/core/source_text.h"
#include "engine/core/units.h"

namespace pinfield {

/// What a (part of an) expression gives.
struct Measure {
    Dimension dimension{};
    bool bare = false;       ///< a number without a unit is in it; with no other dimension it may stand for any
    bool condition = false;  ///< true or false, no number

    bool adapts() const { return bare && dimension.is_plain() && !condition; }
    bool operator==(const Measure&) const = default;
};

/// What is wrong with an expression. `span` lies within its text.
struct ExpressionError {
    Code code = Code::bad_expression;
    Span span;
    std::string message;
    std::string hint;
};

enum class Operation : unsigned char {
    literal,
    name,
    negate,
    add,
    subtract,
    multiply,
    divide,
    modulo,
    power,
    less,
    less_or_equal,
    greater,
    greater_or_equal,
    equal,
    not_equal,
    invert,
    both,
    either,
    choose,
    minimum,
    maximum,
    clamp,
    absolute,
    floor,
    ceiling,
    root,
    sine,
    cosine,
    tangent,
    arc_tangent,
    sign,
    exponential,
    logarithm,
    length,
    mix,
    smoothstep,
};

struct ExpressionNode {
    Operation operation = Operation::literal;
    std::array<int, 3> operands{-1, -1, -1};  ///< nodes that come before this one; `choose`: condition, yes, no; a name: which, alone
    double value = 0;                         ///< of a literal, in m, deg, s, kg and what they make
    Measure measure{};                        ///< of a literal
    Span span;                                ///< in the text, without brackets around it
};

/// A name that an expression depends on, and where it says it first.
struct ExpressionName {
    std::string text;
    Span span;
};

/// A parsed expression. Its last node is the whole.
struct Expression {
    std::string text;
    std::vector<ExpressionNode> nodes;
    std::vector<ExpressionName> names;  ///< each once, in the order of the text

    int root() const { return static_cast<int>(nodes.size()) - 1; }
    std::string_view slice(Span span) const { return std::string_view(text).substr(span.begin, span.end - span.begin); }
};

/// Brackets, signs, exponents and branches within each other, and nodes, that an expression may have.
inline constexpr int most_expression_depth = 64, most_expression_nodes = 1000;

/// Reads an expression. From loosest to tightest: `a if c else b`; `or`; `and`; `not`; == != < <= > >=; + -; * / %; a sign; `^`, which
/// groups to the right: -2^2 is -4. A name is [a-z_][a-z0-9_]*, several of them with dots between; one before a bracket is a function:
/// those of function_names(). `pi` is the number. A unit follows its number without a blank: 3mm/s is a speed, 3mm / s a quotient.
tl::expected<Expression, ExpressionError> parse_expression(std::string_view text);

std::span<const std::string_view> function_names();
/// Words that no param may be called: they mean something in every expression.
bool is_reserved_name(std::string_view name);

/// What the whole gives where its names (parallel to Expression::names) give what `names` says; or the first place where dimensions
/// disagree. A bare number adapts to what it meets; + - % min max clamp mix, comparisons and the branches of a choice take two of the same;
/// products and quotients combine; sin, cos, tan take an angle, atan2 gives one; floor, ceil, exp and log take plain numbers.
tl::expected<Measure, ExpressionError> measure_of(const Expression& expression, std::span<const Measure> names);

/// Why what an expression gives may not stand where `due` is, or nothing.
std::optional<ExpressionError> why_unfit(const Expression& expression, const Measure& given, const Dimension& due);

/// The value with these values of its names (parallel to Expression::names, finite), in m, deg, s, kg and what they make. Fails where it has
/// none: a division by zero, the root or logarithm of what has none, a number too large for a double. Only the branch that is chosen is
/// looked at. For an expression that measure_of() takes for a number.
tl::expected<double, ExpressionError> evaluate(const Expression& expression, std::span<const double> names);

/// The same expression with every part that depends on no name and has a value made a literal. It evaluates to the same bits.
Expression folded(const Expression& expression, std::span<const Measure> names);

}  // namespace pinfield

// Precedence climbing (Norvell, "Parsing Expressions by Recursive Descent", 1999).
#include <fmt/format.h>

#include <algorithm>

#include "engine/core/at.h"
#include "engine/core/closest.h"
#include "engine/core/trig.h"
#include "engine/expression/tokens.h"

namespace pinfield {
namespace {

enum Level : int { lowest = 0, of_or, of_and, of_not, of_comparison, of_sum, of_product, of_sign, of_power };

struct Binary {
    std::string_view sign;
    Operation operation;
    Level level;
};
constexpr std::array binaries{
    Binary{"or", Operation::either, of_or},
    Binary{"and", Operation::both, of_and},
    Binary{"<", Operation::less, of_comparison},
    Binary{"<=", Operation::less_or_equal, of_comparison},
    Binary{">", Operation::greater, of_comparison},
    Binary{">=", Operation::greater_or_equal, of_comparison},
    Binary{"==", Operation::equal, of_comparison},
    Binary{"!=", Operation::not_equal, of_comparison},
    Binary{"+", Operation::add, of_sum},
    Binary{"-", Operation::subtract, of_sum},
    Binary{"*", Operation::multiply, of_product},
    Binary{"/", Operation::divide, of_product},
    Binary{"%", Operation::modulo, of_product},
    Binary{"^", Operation::power, of_power},
};

struct Function {
    std::string_view name;
    Operation operation;
    std::size_t least, most;
    std::string_view example;
};
constexpr std::size_t any_count = most_expression_nodes;
constexpr std::array functions{
    Function{"min", Operation::minimum, 2, any_count, "min(a, b)"},
    Function{"max", Operation::maximum, 2, any_count, "max(a, b)"},
    Function{"clamp", Operation::clamp, 3, 3, "clamp(x, lowest, highest)"},
    Function{"abs", Operation::absolute, 1, 1, "abs(x)"},
    Function{"floor", Operation::floor, 1, 1, "floor(x)"},
    Function{"ceil", Operation::ceiling, 1, 1, "ceil(x)"},
    Function{"sqrt", Operation::root, 1, 1, "sqrt(x)"},
    Function{"sin", Operation::sine, 1, 1, "sin(angle)"},
    Function{"cos", Operation::cosine, 1, 1, "cos(angle)"},
    Function{"tan", Operation::tangent, 1, 1, "tan(angle)"},
    Function{"atan2", Operation::arc_tangent, 2, 2, "atan2(y, x)"},
    Function{"sign", Operation::sign, 1, 1, "sign(x)"},
    Function{"pow", Operation::power, 2, 2, "pow(x, exponent)"},
    Function{"exp", Operation::exponential, 1, 1, "exp(x)"},
    Function{"log", Operation::logarithm, 1, 1, "log(x)"},
    Function{"length", Operation::length, 2, 2, "length(x, y)"},
    Function{"mix", Operation::mix, 3, 3, "mix(first, second, share)"},
    Function{"smoothstep", Operation::smoothstep, 3, 3, "smoothstep(low, high, x)"},
    Function{"mod", Operation::modulo, 2, 2, "mod(a, b)"},
};
constexpr std::array reserved{std::string_view("and"), std::string_view("or"), std::string_view("not"),  std::string_view("if"),
                              std::string_view("else"), std::string_view("pi"), std::string_view("true"), std::string_view("false")};

constexpr auto all_names = [] {
    std::array<std::string_view, functions.size()> out;
    for (std::size_t i = 0; i < functions.size(); ++i) out[i] = functions[i].name;
    return out;
}();

/// Every function gives the node it has made, or -1 once something is wrong.
class Parser {
public:
    explicit Parser(std::string_view text) { out_.text = text; }

    tl::expected<Expression, ExpressionError> run() && {
        advance();
        const int root = whole();
        if (root >= 0 && now_.sort != Token::Sort::end) unexpected();
        if (error_) return tl::unexpected(std::move(*error_));
        return std::move(out_);
    }

private:
    /// One step further into brackets, signs, exponents and branches.
    struct Deeper {
        explicit Deeper(Parser& parser) : parser_(parser) {
            if (++parser_.depth_ > most_expression_depth)
                parser_.report(Code::expression_too_deep, parser_.now_.span,
                               fmt::format("more than {} brackets, signs and branches within each other", most_expression_depth),
                               "give a part of it a name in params");
        }
        ~Deeper() { --parser_.depth_; }
        Deeper(const Deeper&) = delete;
        Deeper& operator=(const Deeper&) = delete;
        Parser& parser_;
    };

    int report(Code code, Span span, std::string message, std::string hint = {}) {
        if (!error_) error_ = ExpressionError{code, span, std::move(message), std::move(hint)};
        return -1;
    }

    void advance() {
        before_ = now_;
        auto next = next_token(out_.text, now_.span.end);
        if (next) now_ = *next;
        else if (!error_) error_ = std::move(next.error());
    }
    bool is(std::string_view text) const { return now_.sort != Token::Sort::end && now_.sort != Token::Sort::number && now_.text == text; }
    bool take(std::string_view text) {
        if (error_ || !is(text)) return false;
        advance();
        return true;
    }
    bool expect(std::string_view text, std::string_view what) {
        if (take(text)) return true;
        if (now_.sort == Token::Sort::end) report(Code::bad_expression, now_.span, fmt::format("{} is missing at the end", what));
        else unexpected();
        return false;
    }

    /// A token that cannot stand where it does.
    int unexpected() {
        const bool after_number = before_.sort == Token::Sort::number;
        if (now_.sort == Token::Sort::end)
            return report(Code::bad_expression, now_.span, out_.nodes.empty() && now_.span.begin == 0 ? "an expression is due here" : "the expression ends too early");
        if (after_number && !before_.suffix && now_.sort == Token::Sort::name && find_suffix(now_.text))
            return report(Code::malformed_number, {before_.span.begin, now_.span.end},
                          fmt::format("{} {} has a blank before its unit", before_.text, now_.text),
                          fmt::format("write {}{}", before_.text, now_.text));
        std::string hint;
        if (now_.text == ")") hint = "no bracket is open";
        else if (now_.text == "not") hint = "put it into brackets: (not ...)";
        else if (now_.sort != Token::Sort::sign && (after_number || before_.sort == Token::Sort::name || before_.text == ")"))
            hint = "a product is written with *";
        return report(Code::bad_expression, now_.span, fmt::format("{} cannot stand here", now_.text), std::move(hint));
    }

    int add(Operation operation, std::array<int, 3> operands, Span span) {
        if (error_) return -1;
        if (out_.nodes.size() == static_cast<std::size_t>(most_expression_nodes))
            return report(Code::expression_too_long, span, fmt::format("more than {} numbers, names and operations", most_expression_nodes),
                          "give a part of it a name in params");
        ExpressionNode node;
        node.operation = operation;
        node.operands = operands;
        node.span = span;
        out_.nodes.push_back(node);
        return out_.root();
    }
    int add_literal(double value, const UnitSuffix* suffix, Span span) {
        const int node = add(Operation::literal, {-1, -1, -1}, span);
        if (node < 0) return node;
        out_.nodes.back().value = value;
        out_.nodes.back().measure = suffix ? Measure{suffix->dimension, false, false} : Measure{{}, true, false};
        return node;
    }
    Span from(std::size_t begin) const { return {begin, before_.span.end}; }

    int whole() {
        const std::size_t begin = now_.span.begin;
        const int yes = binary(lowest);
        if (error_ || !take("if")) return yes;
        const int condition = binary(lowest);
        if (error_ || !expect("else", "else")) return -1;
        const Deeper deeper(*this);
        const int no = error_ ? -1 : whole();
        return add(Operation::choose, {condition, yes, no}, from(begin));
    }

    int binary(int lowest_level) {
        const std::size_t begin = now_.span.begin;
        int left = prefix(lowest_level);
        while (!error_) {
            const auto found = std::find_if(binaries.begin(), binaries.end(), [&](const Binary& b) { return is(b.sign); });
            if (found == binaries.end() || found->level < lowest_level) break;
            advance();
            if (error_) break;
            const int right = found->level == of_power ? exponent() : binary(found->level + 1);
            left = add(found->operation, {left, right, -1}, from(begin));
            if (found->level == of_comparison && is_comparison())
                return report(Code::bad_expression, now_.span, "two comparisons in a row", "write a < b and b < c");
        }
        return error_ ? -1 : left;
    }
    int exponent() {
        const Deeper deeper(*this);
        return error_ ? -1 : binary(of_power);
    }
    bool is_comparison() const {
        return std::any_of(binaries.begin(), binaries.end(), [&](const Binary& b) { return b.level == of_comparison && is(b.sign); });
    }

    int prefix(int lowest_level) {
        const std::size_t begin = now_.span.begin;
        if (error_) return -1;
        if (is("-") || is("+") || (is("not") && lowest_level <= of_not)) {
            const bool minus = is("-"), invert = is("not");
            const Deeper deeper(*this);
            advance();
            const int operand = error_ ? -1 : binary(invert ? of_not : of_sign);
            if (!minus && !invert) return operand;
            return add(minus ? Operation::negate : Operation::invert, {operand, -1, -1}, from(begin));
        }
        return primary();
    }

    int primary() {
        const Token token = now_;
        if (token.sort == Token::Sort::number) {
            advance();
            return add_literal(token.value, token.suffix, token.span);
        }
        if (token.sort == Token::Sort::name) return named(token);
        if (!take("(")) return error_ ? -1 : unexpected();
        const Deeper deeper(*this);
        const int inner = error_ ? -1 : whole();
        return !error_ && expect(")", ") of the bracket") ? inner : -1;
    }

    int named(const Token& token) {
        if (token.text == "pi") {
            advance();
            return add_literal(pi, nullptr, token.span);
        }
        if (std::find(reserved.begin(), reserved.end(), token.text) != reserved.end()) return unexpected();
        advance();
        if (!error_ && is("(")) return call(token);
        const auto same = [&](const ExpressionName& name) { return name.text == token.text; };
        const auto found = std::find_if(out_.names.begin(), out_.names.end(), same);
        const auto index = static_cast<int>(found - out_.names.begin());
        if (found == out_.names.end()) out_.names.push_back({std::string(token.text), token.span});
        return add(Operation::name, {index, -1, -1}, token.span);
    }

    int call(const Token& token) {
        const auto function = std::find_if(functions.begin(), functions.end(), [&](const Function& f) { return f.name == token.text; });
        if (function == functions.end())
            return report(Code::bad_expression, token.span, fmt::format("no function is called {}", token.text),
                          suggestion(token.text, all_names));
        advance();
        const Deeper deeper(*this);
        std::vector<int> arguments;
        do {
            if (error_) return -1;
            arguments.push_back(whole());
        } while (take(","));
        if (error_ || !expect(")", ") of " + std::string(token.text))) return -1;
        if (arguments.size() < function->least || arguments.size() > function->most)
            return report(Code::bad_expression, from(token.span.begin),
                          fmt::format("{} takes {}{} numbers, not {}", token.text, function->least,
                                      function->most > function->least ? " or more" : "", arguments.size()),
                          fmt::format("write {}", function->example));
        const auto argument = [&](std::size_t i) { return i < arguments.size() ? arguments[i] : -1; };
        if (function->most <= 3) return add(function->operation, {argument(0), argument(1), argument(2)}, from(token.span.begin));
        int folded = arguments[0];
        for (const int next : std::span(arguments).subspan(1)) folded = add(function->operation, {folded, next, -1}, from(token.span.begin));
        return folded;
    }

    Expression out_;
    Token now_, before_;
    int depth_ = 0;
    std::optional<ExpressionError> error_;
};

}  // namespace

std::span<const std::string_view> function_names() { return all_names; }

bool is_reserved_name(std::string_view name) { return std::find(reserved.begin(), reserved.end(), name) != reserved.end(); }

tl::expected<Expression, ExpressionError> parse_expression(std::string_view text) { return Parser(text).run(); }

}  // namespace pinfield

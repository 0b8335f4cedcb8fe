#include "editor/typed_number.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <optional>
#include <string>

#include "engine/core/numbers.h"
#include "engine/io/quantity.h"

namespace pinfield::editor {
namespace {

/// A quantity of the field, or a number that has no unit yet.
struct Term {
    double value = 0;
    bool is_bare = true;
};

constexpr int deepest_brackets = 50;

class Reader {
public:
    Reader(std::string_view text, Unit unit, std::string_view shown_unit) : text_(text), unit_(unit), shown_unit_(shown_unit) {}

    Result<double> read() {
        const Term sum = read_sum();
        skip_spaces();
        if (!failed() && at_ < text_.size()) fail(fmt::format("\"{}\" is not expected here", text_.substr(at_)));
        const double value = in_unit(sum).value;
        if (!failed() && !std::isfinite(value)) fail("that is no number");
        if (failed()) return failure(why_);
        return is_computed_ ? *parse_number(fmt::format("{:.12g}", value)) : value;  // a file keeps no digits that only rounding put there
    }

private:
    bool failed() const { return !why_.empty(); }
    void fail(std::string why) {
        if (!failed()) why_ = std::move(why);
    }
    void skip_spaces() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    }
    bool take(char c) {
        skip_spaces();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    Term quantity(const std::string& text) {
        const QuantityResult read = read_quantity(text, unit_);
        if (!read) fail(read.error().message);
        return {read ? read->value : 0, false};
    }
    /// A bare number stands for the unit that is shown.
    Term in_unit(const Term& term) {
        if (!term.is_bare || shown_unit_.empty()) return {term.value, false};
        return quantity(to_text(term.value) + std::string(shown_unit_));
    }

    Term read_sum() {
        Term sum = read_product();
        while (!failed()) {
            const bool plus = take('+'), minus = !plus && take('-');
            if (!plus && !minus) break;
            Term other = read_product();
            is_computed_ = true;
            if (sum.is_bare != other.is_bare) sum = in_unit(sum), other = in_unit(other);
            sum.value += plus ? other.value : -other.value;
        }
        return sum;
    }
    Term read_product() {
        Term product = read_sign();
        while (!failed()) {
            const bool times = take('*'), over = !times && take('/');
            if (!times && !over) break;
            const Term other = read_sign();
            is_computed_ = true;
            if (!other.is_bare && (over || !product.is_bare)) fail("only one of the factors may have a unit, and not the divisor");
            if (over && other.value == 0) fail("that would divide by 0");
            product = {times ? product.value * other.value : product.value / other.value, product.is_bare && other.is_bare};
        }
        return product;
    }
    Term read_sign() {
        if (take('-')) {
            const Term term = read_atom();
            return {-term.value, term.is_bare};
        }
        take('+');
        return read_atom();
    }
    Term read_atom() {
        if (take('(')) {
            if (++depth_ > deepest_brackets) fail("too many brackets");
            const Term inner = failed() ? Term{} : read_sum();
            --depth_;
            if (!take(')')) fail("a ) is missing");
            return inner;
        }
        const std::size_t begin = at_;
        while (at_ < text_.size() && is_part_of_number(begin)) ++at_;
        const std::string digits(text_.substr(begin, at_ - begin));
        skip_spaces();
        const std::size_t unit_begin = at_;
        while (at_ < text_.size() && is_part_of_unit(unit_begin)) ++at_;
        const std::string unit(text_.substr(unit_begin, at_ - unit_begin));
        const std::optional<double> number = parse_number(digits);
        if (!number) fail(digits.empty() ? "type a number" : fmt::format("{} is not a number", digits));
        return unit.empty() || !number ? Term{number.value_or(0), true} : quantity(digits + unit);
    }
    bool is_part_of_number(std::size_t begin) const {
        const char c = text_[at_];
        if (std::isdigit(static_cast<unsigned char>(c)) || c == '.') return true;
        const bool after_digit = at_ > begin && std::isdigit(static_cast<unsigned char>(text_[at_ - 1]));
        const char next = at_ + 1 < text_.size() ? text_[at_ + 1] : ' ';
        if (c == 'e' && after_digit) return std::isdigit(static_cast<unsigned char>(next)) || next == '-' || next == '+';
        return (c == '-' || c == '+') && at_ > begin && text_[at_ - 1] == 'e';
    }
    /// "m/s^2" is a unit, "26mm/2" is not: a slash belongs to it where a letter follows.
    bool is_part_of_unit(std::size_t begin) const {
        const auto letter = [&](std::size_t i) { return i < text_.size() && (std::isalpha(static_cast<unsigned char>(text_[i])) || text_[i] & 0x80); };
        const char c = text_[at_];
        if (letter(at_)) return true;
        if (at_ == begin) return c == '%';
        return (c == '/' && letter(at_ + 1)) || c == '^' || (c == '2' && text_[at_ - 1] == '^');
    }

    std::string_view text_;
    Unit unit_;
    std::string_view shown_unit_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool is_computed_ = false;
    std::string why_;
};

}  // namespace

Result<double> typed_number(std::string_view text, Unit unit, std::string_view shown_unit) { return Reader(text, unit, shown_unit).read(); }

}  // namespace pinfield::editor

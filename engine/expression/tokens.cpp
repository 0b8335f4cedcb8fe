#include "engine/expression/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "engine/core/closest.h"

namespace pinfield {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_in_name(char c) { return is_letter(c) || is_digit(c); }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
/// A byte of a character beyond ASCII, or a quotation mark: what people write units with.
bool is_in_sign_of_unit(char c) { return static_cast<unsigned char>(c) >= 0x80 || c == '"' || c == '\''; }

tl::unexpected<ExpressionError> wrong(Code code, Span span, std::string message, std::string hint = {}) {
    return tl::unexpected(ExpressionError{code, span, std::move(message), std::move(hint)});
}

/// The longest unit that the text begins with and that ends where a word may.
const UnitSuffix* suffix_at(std::string_view text) {
    const UnitSuffix* best = nullptr;
    for (const UnitSuffix& suffix : unit_suffixes()) {
        const std::size_t end = suffix.text.size();
        if (text.starts_with(suffix.text) && (end == text.size() || !(is_in_name(text[end]) || is_in_sign_of_unit(text[end]))) &&
            (!best || end > best->text.size()))
            best = &suffix;
    }
    return best;
}

tl::unexpected<ExpressionError> unknown_unit(std::string_view digits, std::string_view word, Span span) {
    if (const std::string_view meant = suffix_for(word); !meant.empty())
        return wrong(Code::unknown_unit, span, fmt::format("{} is no unit here", word), fmt::format("write {}{}", digits, meant));
    std::vector<std::string_view> words;
    for (const UnitSuffix& suffix : unit_suffixes()) words.push_back(suffix.text);
    // In two letters anything is near anything: km is not mm.
    const auto close = word.size() > 2 ? closest_match(word, words) : std::nullopt;
    return wrong(Code::unknown_unit, span, fmt::format("{} is no unit", word),
                 close ? fmt::format("did you mean {}?", *close) : "a product is written with *: 2 * x");
}

tl::expected<Token, ExpressionError> number_token(std::string_view text, std::size_t begin) {
    const std::string_view rest = text.substr(begin), digits = rest.substr(0, number_length(rest, false));
    std::string_view word = rest.substr(digits.size());
    const UnitSuffix* suffix = suffix_at(word);
    std::size_t length = suffix ? suffix->text.size() : 0;
    while (!suffix && length < word.size() && (is_in_name(word[length]) || is_in_sign_of_unit(word[length]))) ++length;
    word = word.substr(0, length);
    const Span span{begin, begin + digits.size() + word.size()};
    const auto value = number_in(digits, suffix);
    if (!value) {
        const WrongDigits why = why_no_number(digits);
        return wrong(Code::malformed_number, span, fmt::format("{}{} {}", digits, word, why.what), std::string(why.hint));
    }
    if (!suffix && !word.empty()) return unknown_unit(digits, word, {span.begin + digits.size(), span.end});
    return Token{Token::Sort::number, span, rest.substr(0, digits.size() + word.size()), *value, suffix};
}

tl::expected<Token, ExpressionError> name_token(std::string_view text, std::size_t begin) {
    std::size_t end = begin;
    while (end < text.size() && (is_in_name(text[end]) || (text[end] == '.' && end + 1 < text.size() && is_letter(text[end + 1])))) ++end;
    const Span span{begin, end};
    const std::string_view name = text.substr(begin, end - begin);
    if (std::any_of(name.begin(), name.end(), [](char c) { return c >= 'A' && c <= 'Z'; }))
        return wrong(Code::bad_name, span, fmt::format("{} is not a valid name", name), "small letters, digits and _");
    return Token{Token::Sort::name, span, name};
}

/// What other languages write, and what is written here.
struct OtherSign {
    std::string_view theirs, hint;
};
constexpr std::array other_signs{
    OtherSign{"**", "a power is written ^"},       OtherSign{"&&", "write and"},
    OtherSign{"||", "write or"},                   OtherSign{"=", "a comparison is written =="},
    OtherSign{"!", "write not"},                   OtherSign{"?", "write a if c else b"},
    OtherSign{"$", "in an expression a name stands without $"},
    OtherSign{"\u00d7", "a product is written *"}, OtherSign{"\u00b7", "a product is written *"},
    OtherSign{"\u2212", "a minus is written -"},   OtherSign{"\u221a", "write sqrt(...)"},
};

std::size_t length_of_character(std::string_view text) {
    std::size_t length = 1;
    while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) ++length;
    return length;
}

tl::expected<Token, ExpressionError> sign_token(std::string_view text, std::size_t begin) {
    const std::string_view rest = text.substr(begin);
    for (const std::string_view two : {"<=", ">=", "==", "!="})
        if (rest.starts_with(two)) return Token{Token::Sort::sign, {begin, begin + 2}, rest.substr(0, 2)};
    for (const OtherSign& other : other_signs)
        if (rest.starts_with(other.theirs))
            return wrong(Code::bad_expression, {begin, begin + other.theirs.size()}, fmt::format("{} means nothing here", other.theirs),
                         std::string(other.hint));
    if (std::string_view("+-*/%^<>(),").find(rest.front()) != std::string_view::npos)
        return Token{Token::Sort::sign, {begin, begin + 1}, rest.substr(0, 1)};
    const std::size_t length = length_of_character(rest);
    return wrong(Code::bad_expression, {begin, begin + length}, fmt::format("{} means nothing here", rest.substr(0, length)));
}

}  // namespace

tl::expected<Token, ExpressionError> next_token(std::string_view text, std::size_t at) {
    while (at < text.size() && is_blank(text[at])) ++at;
    if (at == text.size()) return Token{Token::Sort::end, {at, at}, {}};
    if (is_digit(text[at]) || (text[at] == '.' && at + 1 < text.size() && is_digit(text[at + 1]))) return number_token(text, at);
    return is_letter(text[at]) ? name_token(text, at) : sign_token(text, at);
}

}  // namespace pinfield

#include "engine/io/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "engine/core/closest.h"
#include "engine/core/numbers.h"
#include "engine/reflect/node_type.h"

namespace pinfield {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool looks_numeric(std::string_view text) {
    if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
    if (!text.empty() && text[0] == '.') text.remove_prefix(1);
    return !text.empty() && is_digit(text[0]);
}

bool looks_infinite(std::string_view text) {
    std::string word;
    for (const char c : text)
        if (c != '.' && c != '+' && c != '-') word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return word == "nan" || word == "inf" || word == "infinity";
}

/// What other programs take for true and false.
bool is_boolean_word(std::string_view text) {
    constexpr std::array words{"true", "false", "yes", "no", "on", "off"};
    return std::find(words.begin(), words.end(), text) != words.end();
}

/// Anything that a number, a name or an operator may be part of; prose is not.
bool looks_like_expression(std::string_view text) {
    if (text.empty()) return false;
    if (text.find_first_of("+-*/%^()<>=$") != std::string_view::npos) return true;
    return is_letter(text[0]) && std::all_of(text.begin(), text.end(), [](char c) {
               return is_letter(c) || is_digit(c) || c == '_' || c == '.';
           });
}

QuantityError expression_of(std::string_view text) {
    return {Code::wrong_type, fmt::format("a number is due here, not {}", text), "", true};
}

QuantityError malformed(std::string_view text, std::string_view digits) {
    const WrongDigits wrong = why_no_number(digits);
    return {Code::malformed_number, fmt::format("{} {}", text, wrong.what), std::string(wrong.hint)};
}

QuantityError unit_error(std::string_view text, std::string_view word, Unit unit) {
    const std::string allowed = suffixes_of(unit);
    const std::string units = allowed.empty() ? "write it without a unit" : fmt::format("units here: {}", allowed);
    if (const UnitSuffix* other = find_suffix(word))
        return {Code::wrong_dimension,
                fmt::format("{} is {} where {} is due", text, measured(other->dimension), measured(dimension_of(unit))), units};
    std::vector<std::string_view> words;
    for (const UnitSuffix& s : unit_suffixes())
        if (s.dimension == dimension_of(unit)) words.push_back(s.text);
    // In two letters anything is near anything: km is not mm.
    const auto close = word.size() > 2 ? closest_match(word, words) : std::nullopt;
    return {Code::unknown_unit, fmt::format("{} is no unit", word),
            close ? fmt::format("did you mean {}?", *close) : units};
}

}  // namespace

Dimension dimension_of(Unit unit) {
    switch (unit) {
        case Unit::none: return {};
        case Unit::metre: return {1, 0, 0, 0};
        case Unit::degree: return {0, 1, 0, 0};
        case Unit::second: return {0, 0, 1, 0};
        case Unit::kilogram: return {0, 0, 0, 1};
        case Unit::metre_per_second: return {1, 0, -1, 0};
        case Unit::metre_per_second2: return {1, 0, -2, 0};
        case Unit::degree_per_second: return {0, 1, -1, 0};
        case Unit::degree_per_second2: return {0, 1, -2, 0};
        case Unit::seconds_per_metre: return {-1, 0, 1, 0};
    }
    return {};
}

Unit unit_of(const Dimension& dimension) {
    constexpr std::array units{Unit::metre,  Unit::degree, Unit::second, Unit::kilogram, Unit::metre_per_second, Unit::metre_per_second2,
                               Unit::degree_per_second, Unit::degree_per_second2, Unit::seconds_per_metre};
    const auto* const found = std::find_if(units.begin(), units.end(), [&](Unit unit) { return dimension_of(unit) == dimension; });
    return found == units.end() ? Unit::none : *found;
}

QuantityResult read_quantity(std::string_view written, Unit unit) {
    const std::string_view text =
        written.size() > 60 ? written.substr(0, 60) : written;  // longer ones are wrong, and messages are for people
    if (text.size() < written.size() && parse_number(written))
        return Quantity{*parse_number(written), written, nullptr};
    if (looks_infinite(text)) return QuantityError{Code::not_finite, fmt::format("{} is no finite number", text), ""};
    if (!looks_numeric(text)) {
        if (!is_boolean_word(text) && looks_like_expression(text))
            return expression_of(text);
        return QuantityError{Code::wrong_type, "a number is due here", ""};
    }
    const std::string_view digits = text.substr(0, number_length(text, true));
    std::string_view word = text.substr(digits.size());
    const std::string_view trimmed = word.substr(std::min(word.find_first_not_of(' '), word.size()));
    const UnitSuffix* suffix = find_suffix(trimmed);
    if (suffix && suffix->dimension != dimension_of(unit)) suffix = nullptr;
    if (const std::string_view meant = suffix_for(trimmed); !meant.empty() && parse_number(digits)) {
        const QuantityResult right = read_quantity(fmt::format("{}{}", digits, meant), unit);
        if (right) return QuantityError{Code::unknown_unit, fmt::format("{} is no unit here", trimmed), fmt::format("write {}{}", digits, meant)};
        return right.error();
    }
    if (digits.size() == 1 && digits[0] == '0' && !word.empty() && (word[0] == 'x' || word[0] == 'o'))
        return QuantityError{Code::malformed_number, fmt::format("{} is not a decimal number", text),
                             "write it in decimal digits"};
    if (!word.empty() && !suffix && word.find_first_of("+-*%()<>= ") != std::string_view::npos &&
        word != trimmed)
        return expression_of(text);
    if (!trimmed.empty() && !suffix) {
        const bool unit_like =
            std::all_of(word.begin(), word.end(),
                        [](char c) { return is_letter(c) || c == '/' || c == '^' || is_digit(c); }) &&
            is_letter(word[0]);
        if (!unit_like && parse_number(digits))
            return expression_of(text);
        if (!parse_number(digits)) return malformed(text, digits);
        return unit_error(text, trimmed, unit);
    }
    if (word != trimmed)
        return QuantityError{Code::malformed_number, fmt::format("{} has a blank before its unit", text),
                             fmt::format("write {}{}", digits, trimmed)};
    const std::optional<double> value = number_in(digits, suffix);
    if (!value) return malformed(text, digits);
    return Quantity{*value, digits, suffix};
}

namespace {

/// Shortest digits of value * 10^-power: those of the value, with the point moved.
std::string shifted_text(double value, int power) {
    if (power == 0 || value == 0) return to_text(value);
    char buffer[64];
    const char* const end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific).ptr;
    const std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
    const std::size_t e = text.find('e');
    std::string_view written = text.substr(e + 1);
    if (written.starts_with('+')) written.remove_prefix(1);
    int exponent = 0;
    std::from_chars(written.data(), written.data() + written.size(), exponent);
    exponent -= power;
    std::string sign = text[0] == '-' ? "-" : "", digits;
    for (const char c : text.substr(0, e))
        if (is_digit(c)) digits += c;
    if (exponent < -8 || exponent > 15)
        return fmt::format("{}{}{}{}e{}", sign, digits[0], digits.size() > 1 ? "." : "", digits.substr(1), exponent);
    if (exponent < 0) return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
    const auto whole = static_cast<std::size_t>(exponent) + 1;
    if (digits.size() <= whole) return sign + digits + std::string(whole - digits.size(), '0');
    return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

std::size_t decimals_of(std::string_view digits) {
    const std::size_t point = digits.find('.');
    return point == std::string_view::npos || digits.find_first_of("eE") != std::string_view::npos
               ? 0
               : digits.size() - point - 1;
}

void pad_decimals(std::string& digits, std::size_t decimals) {
    if (decimals == 0 || digits.find('e') != std::string::npos) return;
    std::size_t have = decimals_of(digits);
    if (have == 0 && digits.find('.') == std::string::npos) digits += '.';
    for (; have < decimals; ++have) digits += '0';
}

/// Digits d with d * factor == value, searched among the neighbours of the quotient.
std::optional<std::string> divided_text(double value, double factor) {
    const double quotient = value / factor;
    double below = quotient, above = quotient;
    // Prefer few digits: 12 significant ones first, which is what a person would have written.
    if (const auto rounded = parse_number(fmt::format("{:.12g}", quotient)); rounded && *rounded * factor == value)
        return to_text(*rounded);
    for (int i = 0; i < 4; ++i) {
        if (below * factor == value) return to_text(below);
        if (above * factor == value) return to_text(above);
        below = std::nextafter(below, -HUGE_VAL);
        above = std::nextafter(above, HUGE_VAL);
    }
    return {};
}

}  // namespace

std::string write_quantity(double value, Unit unit, std::string_view like) {
    const QuantityResult old = like.empty() ? QuantityResult(QuantityError{}) : read_quantity(like, unit);
    if (!old) return to_text(value);
    const UnitSuffix* suffix = old->suffix;
    std::string digits;
    if (suffix && suffix->factor != 1) {
        const auto text = divided_text(value, suffix->factor);
        if (!text) return to_text(value);
        digits = *text;
    } else {
        digits = shifted_text(value, suffix ? suffix->power_of_ten : 0);
    }
    pad_decimals(digits, decimals_of(old->digits));
    return digits + std::string(suffix ? suffix->text : "");
}

}  // namespace pinfield

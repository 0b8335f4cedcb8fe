#include "engine/core/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace pinfield {
namespace {

/// Takes the digits off the front of `text` and says how many there were.
std::size_t take_digits(std::string_view& text) {
    std::size_t count = 0;
    while (count < text.size() && text[count] >= '0' && text[count] <= '9') ++count;
    text.remove_prefix(count);
    return count;
}

bool take(std::string_view& text, char a, char b) {
    if (text.empty() || (text.front() != a && text.front() != b)) return false;
    text.remove_prefix(1);
    return true;
}

/// The unsigned part of the grammar that parse_number promises.
bool is_unsigned_decimal(std::string_view text) {
    const bool leads_with_zero = text.starts_with('0');
    const std::size_t whole = take_digits(text);
    if (leads_with_zero && whole > 1) return false;
    std::size_t fraction = 0;
    if (take(text, '.', '.')) fraction = take_digits(text);
    if (whole + fraction == 0) return false;
    if (take(text, 'e', 'E')) {
        take(text, '+', '-');
        if (take_digits(text) == 0) return false;
    }
    return text.empty();
}

}  // namespace

std::string to_text(double x) {
    const double size = std::fabs(x);
    if (!std::isfinite(x) || size == 0) return fmt::format("{}", x);
    const bool plain = size >= 1e-4 && size < 1e15;
    char buffer[64];
    const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, x, format).ptr);
}

std::string to_text(double x, int decimals) {
    std::string text = fmt::format("{:.{}f}", x, decimals);
    if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
    return text;
}

std::optional<double> parse_number(std::string_view text) {
    std::string_view digits = text;
    const bool plus = take(digits, '+', '+');
    const bool minus = !plus && take(digits, '-', '-');
    if (!is_unsigned_decimal(digits)) return std::nullopt;
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
    return minus ? -value : value;
}

}  // namespace pinfield

// Numbers as text, the same on every machine and in every locale.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace pinfield {

/// Shortest text that reads back as the same double. Plain digits for 1e-4 <= |x| < 1e15, else with an exponent:
/// "1e-07". -0 is "-0"; what is not finite is "inf", "-inf", "nan".
std::string to_text(double x);

/// Rounded to a fixed number of decimals: to_text(0.5, 3) is "0.500"; never "-0.000".
std::string to_text(double x, int decimals);

/// The whole text as a decimal number: an optional sign, digits with an optional point, an optional exponent.
/// Accepts "-2.5", "+1", ".5", "5.", "1e-3". Refuses what people mistake for numbers: leading zeros ("007"), "1_000",
/// "1:30", "0x10", "inf", "nan", blanks, and what a
/// double cannot hold ("1e999", "1e-999").
std::optional<double> parse_number(std::string_view text);

}  // namespace pinfield

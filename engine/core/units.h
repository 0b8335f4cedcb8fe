// What numbers measure, and THE table of the units that they may be written in.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pinfield {

/// Exponents of length, angle, time and mass: a speed is {1, 0, -1, 0}. An angle is a dimension of its own, so that 30deg is no length.
struct Dimension {
    signed char length = 0, angle = 0, time = 0, mass = 0;
    bool operator==(const Dimension&) const = default;
    bool is_plain() const { return *this == Dimension{}; }
};

/// One spelling of a unit. A factor that is a power of ten shifts the decimal point, so that nothing is rounded twice.
struct UnitSuffix {
    std::string_view text;
    Dimension dimension;
    int power_of_ten;
    double factor;  ///< in m, deg, s, kg and what they make; 1 where power_of_ten says it all
};

/// Those that measure the same stand together.
std::span<const UnitSuffix> unit_suffixes();
/// The suffix of this spelling, or null.
const UnitSuffix* find_suffix(std::string_view text);
/// "um, mm, cm, m, in, ft"; empty for a plain number.
std::string suffixes_of(const Dimension& dimension);
/// The suffix that a sign or a word stands for, such as "degrees"; empty when there is none.
std::string_view suffix_for(std::string_view word);
/// "a length", "an area"; "a number in m^3/s" for what has no name of its own.
std::string measured(const Dimension& dimension);
/// "m/s^2", in the units that bare numbers are in; "" for a plain number.
std::string symbol(const Dimension& dimension);

/// The beginning of `text` that is a number or was meant as one: digits, points, `_`, `:`, an exponent; a sign before them only where
/// `may_have_sign`. Its length in bytes.
std::size_t number_length(std::string_view text, bool may_have_sign);
/// The number that digits with this suffix (null: none) say, in m, deg, s, kg and what they make; nothing when they are no number, or one
/// that a double cannot hold.
std::optional<double> number_in(std::string_view digits, const UnitSuffix* suffix);
/// What is wrong with digits that are no number, such as "has a leading zero", and how to mend it.
struct WrongDigits {
    std::string_view what, hint;
};
WrongDigits why_no_number(std::string_view digits);

}  // namespace pinfield

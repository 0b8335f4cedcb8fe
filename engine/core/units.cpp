#include "engine/core/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "engine/core/numbers.h"

namespace pinfield {
namespace {

constexpr double degrees_per_radian = 57.295779513082320876798;

constexpr Dimension length{1, 0, 0, 0}, angle{0, 1, 0, 0}, time{0, 0, 1, 0}, mass{0, 0, 0, 1}, speed{1, 0, -1, 0},
    acceleration{1, 0, -2, 0}, angular_speed{0, 1, -1, 0}, angular_acceleration{0, 1, -2, 0}, inverse_speed{-1, 0, 1, 0};

constexpr std::array suffixes{
    UnitSuffix{"um", length, -6, 1},
    UnitSuffix{"mm", length, -3, 1},
    UnitSuffix{"cm", length, -2, 1},
    UnitSuffix{"m", length, 0, 1},
    UnitSuffix{"in", length, 0, 0.0254},
    UnitSuffix{"ft", length, 0, 0.3048},
    UnitSuffix{"deg", angle, 0, 1},
    UnitSuffix{"rad", angle, 0, degrees_per_radian},
    UnitSuffix{"us", time, -6, 1},
    UnitSuffix{"ms", time, -3, 1},
    UnitSuffix{"s", time, 0, 1},
    UnitSuffix{"g", mass, -3, 1},
    UnitSuffix{"kg", mass, 0, 1},
    UnitSuffix{"mm/s", speed, -3, 1},
    UnitSuffix{"cm/s", speed, -2, 1},
    UnitSuffix{"m/s", speed, 0, 1},
    UnitSuffix{"mm/s^2", acceleration, -3, 1},
    UnitSuffix{"m/s^2", acceleration, 0, 1},
    UnitSuffix{"deg/s", angular_speed, 0, 1},
    UnitSuffix{"rad/s", angular_speed, 0, degrees_per_radian},
    UnitSuffix{"deg/s^2", angular_acceleration, 0, 1},
    UnitSuffix{"rad/s^2", angular_acceleration, 0, degrees_per_radian},
    UnitSuffix{"s/m", inverse_speed, 0, 1},
};

struct NamedDimension {
    Dimension dimension;
    std::string_view name;
};
constexpr std::array names{
    NamedDimension{{}, "a plain number"},
    NamedDimension{length, "a length"},
    NamedDimension{{2, 0, 0, 0}, "an area"},
    NamedDimension{angle, "an angle"},
    NamedDimension{time, "a time"},
    NamedDimension{mass, "a mass"},
    NamedDimension{speed, "a speed"},
    NamedDimension{acceleration, "an acceleration"},
    NamedDimension{angular_speed, "an angular speed"},
    NamedDimension{angular_acceleration, "an angular acceleration"},
    NamedDimension{inverse_speed, "an inverse speed"},
};

/// Signs and words for what has a suffix here.
struct Spelling {
    std::string_view theirs, suffix;
};
constexpr std::array spellings{
    Spelling{"\u00b0", "deg"},       Spelling{"degree", "deg"},     Spelling{"degrees", "deg"},   Spelling{"radians", "rad"},
    Spelling{"\"", "in"},           Spelling{"''", "in"},          Spelling{"\u2033", "in"},     Spelling{"inch", "in"},
    Spelling{"inches", "in"},       Spelling{"'", "ft"},           Spelling{"\u2032", "ft"},     Spelling{"feet", "ft"},
    Spelling{"\u00b5m", "um"},       Spelling{"\u03bcm", "um"},      Spelling{"metre", "m"},       Spelling{"metres", "m"},
    Spelling{"meter", "m"},         Spelling{"meters", "m"},       Spelling{"millimetres", "mm"}, Spelling{"millimeters", "mm"},
    Spelling{"centimetres", "cm"},  Spelling{"centimeters", "cm"}, Spelling{"sec", "s"},         Spelling{"seconds", "s"},
    Spelling{"mps", "m/s"},         Spelling{"grams", "g"},
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The digits with a power of ten appended: the point is moved, nothing is multiplied.
std::optional<double> shifted(std::string_view digits, int power) {
    const std::size_t e = digits.find_first_of("eE");
    int exponent = 0;
    std::string_view mantissa = digits;
    if (e != std::string_view::npos) {
        mantissa = digits.substr(0, e);
        std::string_view written = digits.substr(e + 1);
        if (written.starts_with('+')) written.remove_prefix(1);
        if (std::from_chars(written.data(), written.data() + written.size(), exponent).ec != std::errc{} ||
            std::abs(exponent) > 9999)
            return {};
    }
    return parse_number(fmt::format("{}e{}", mantissa, exponent + power));
}

}  // namespace

std::span<const UnitSuffix> unit_suffixes() { return suffixes; }

const UnitSuffix* find_suffix(std::string_view text) {
    const auto found = std::find_if(suffixes.begin(), suffixes.end(), [&](const UnitSuffix& s) { return s.text == text; });
    return found == suffixes.end() ? nullptr : &*found;
}

std::string suffixes_of(const Dimension& dimension) {
    std::string out;
    for (const UnitSuffix& s : suffixes)
        if (s.dimension == dimension) out += (out.empty() ? "" : ", ") + std::string(s.text);
    return out;
}

std::string_view suffix_for(std::string_view word) {
    const auto found = std::find_if(spellings.begin(), spellings.end(), [&](const Spelling& s) { return s.theirs == word; });
    return found == spellings.end() ? std::string_view{} : found->suffix;
}

std::string measured(const Dimension& dimension) {
    const auto found = std::find_if(names.begin(), names.end(), [&](const NamedDimension& n) { return n.dimension == dimension; });
    return found == names.end() ? "a number in " + symbol(dimension) : std::string(found->name);
}

std::string symbol(const Dimension& dimension) {
    struct Power {
        std::string_view unit;
        int exponent;
    };
    const std::array powers{Power{"m", dimension.length}, Power{"deg", dimension.angle}, Power{"kg", dimension.mass},
                            Power{"s", dimension.time}};
    std::string above, below;
    for (const Power& power : powers) {
        std::string& side = power.exponent > 0 ? above : below;
        const int times = std::abs(power.exponent);
        if (times == 0) continue;
        if (!side.empty()) side += ' ';
        side += times > 1 ? fmt::format("{}^{}", power.unit, times) : std::string(power.unit);
    }
    if (below.empty()) return above;
    return fmt::format("{}/{}", above.empty() ? "1" : above, below);
}

std::size_t number_length(std::string_view text, bool may_have_sign) {
    std::size_t i = 0;
    if (may_have_sign && i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    while (i < text.size() && (is_digit(text[i]) || text[i] == '.' || text[i] == '_' || text[i] == ':')) ++i;
    if (i + 1 < text.size() && (text[i] == 'e' || text[i] == 'E')) {
        std::size_t j = i + 1;
        if (text[j] == '+' || text[j] == '-') ++j;
        if (j < text.size() && is_digit(text[j])) {
            while (j < text.size() && is_digit(text[j])) ++j;
            i = j;
        }
    }
    return i;
}

std::optional<double> number_in(std::string_view digits, const UnitSuffix* suffix) {
    if (!suffix) return parse_number(digits);
    if (!parse_number(digits)) return {};
    const std::optional<double> value = shifted(digits, suffix->power_of_ten);
    if (!value || !std::isfinite(*value * suffix->factor)) return {};
    return *value * suffix->factor;
}

WrongDigits why_no_number(std::string_view digits) {
    const std::size_t first = digits.find_first_not_of("+-");
    const std::string_view unsigned_digits = digits.substr(first == std::string_view::npos ? 0 : first);
    if (digits.find('_') != std::string_view::npos) return {"has a _ in a number", "write the digits without it"};
    if (digits.find(':') != std::string_view::npos) return {"has a colon in a number", "a time is in seconds: 90s"};
    if (unsigned_digits.size() > 1 && unsigned_digits[0] == '0' && is_digit(unsigned_digits[1]))
        return {"has a leading zero", "some programs would read it as octal: leave the zero away"};
    return {"is not a number a computer can hold", ""};
}

}  // namespace pinfield

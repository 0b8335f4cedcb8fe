// Formulas to try the promises on: those of which a distance can be made, and those of which none can.
#pragma once
#include <array>
#include <string_view>

namespace pinfield::test {

/// In a window of 80 mm by 80 mm. Every function of the language is in one of them.
inline constexpr std::array good_formulas{
    std::string_view("length(x, y) - 30mm"),
    std::string_view("length(x, y) - 30mm + 2mm * sin(8 * atan2(y, x))"),
    std::string_view("sqrt(x * x + y ^ 2) - 2cm"),
    std::string_view("max(abs(x) - 3cm, abs(y) - 1cm)"),
    std::string_view("length(max(abs(x) - 2cm, 0), max(abs(y) - 1cm, 0)) - 5mm"),
    std::string_view("abs(x) + abs(y) - 25mm"),
    std::string_view("y - 5mm * cos(x / 1mm * 12)"),
    std::string_view("(x * x + y * y) / 2cm - 1cm"),
    std::string_view("1cm - 2cm ^ 2 / length(x - 1cm, y) / 4 - 2cm ^ 2 / length(x + 1cm, y) / 4"),
    std::string_view("(abs(x) ^ 4 + abs(y) ^ 4) ^ 0.25 - 3cm"),
    std::string_view("((abs(x) / 3cm) ^ 2.5 + (abs(y) / 2cm) ^ 2.5 - 1) * 1cm"),
    std::string_view("(((x / 2cm) ^ 2 + (y / 2cm) ^ 2 - 1) ^ 3 - (x / 2cm) ^ 2 * (y / 2cm) ^ 3) * 1cm"),
    std::string_view("length(x, y) - 2cm - 1cm * abs(cos(2.5 * atan2(y, x)))"),
    std::string_view("length(x, y) - 3cm * (1 - abs(atan2(x, y)) / 400deg)"),
    std::string_view("exp(x / 1cm) * 1mm + abs(y) - 1cm"),
    std::string_view("2cm * log(length(x, y) / 1cm + 1) - 2cm"),
    std::string_view("5mm * tan(x / 1mm * 1deg) + y"),
    std::string_view("mix(length(x, y) - 3cm, abs(x) - 1cm, 0.5)"),
    std::string_view("abs(y) - 1cm - 5mm * smoothstep(-2cm, 2cm, x)"),
    std::string_view("clamp(x, -1cm, 3cm) + y / 2"),
    std::string_view("min(length(x - 15mm, y), length(x + 15mm, y), length(x, y - 2cm)) - 1cm"),
    std::string_view("-log(exp(-length(x - 1cm, y) / 4mm) + exp(-length(x + 1cm, y) / 4mm)) * 4mm - 1cm"),
    std::string_view("length(x, y) - 3cm + 1mm * sin(360 * (x % 1cm) / 1cm)"),
    std::string_view("x if x > -1m else floor(y / 1cm) * 1cm"),
    std::string_view("abs(x) - 2cm + 1um * floor(length(x, y) / 1m)"),
    std::string_view("length(x, y) - 2cm + 1cm * sign(x + 1m)"),
    std::string_view("max(length(x, y) - 2cm, -1cm - ceil(-x / 1m) * 1m)"),
    std::string_view("(length(x, y) - 2cm) * pow(2, y / 4cm)"),
    std::string_view("length(x + 2cm, y) - 1cm if x < -2cm else abs(y) - 1cm if x < 2cm else length(x - 2cm, y) - 1cm"),
    std::string_view("y - (2 * x if x > 0 else -x) / 2"),
    std::string_view("(abs(x) if abs(x) >= abs(y) else abs(y)) - 2cm"),
    std::string_view("y - 1cm - (x ^ 2 / 2cm if 1cm > x else x - 5mm)"),
    std::string_view("abs(x) - 2cm + ((x + 7m) % (y + x / 2 + 3m) - 1m) / 10"),
    std::string_view("x * y / 2cm"),
    std::string_view("max(x, y, -x - y) - 5mm"),
    std::string_view("length(x, y) - 2cm if not (x > 5cm or y > 5cm) and x != 6cm else 1cm"),
    std::string_view("length(x, y) - 5mm * (4 + sin(3 * atan2(y, x) + 20deg))"),
    std::string_view("length(x, y) - 35mm + 1um * floor(length(x, y) / 1cm)"),
    std::string_view("abs(length(x, y) - 2cm) - sqrt(3mm * 3mm + x * x / 100)"),
};

struct BadFormula {
    std::string_view text, part, why;
};
inline constexpr std::array bad_formulas{
    BadFormula{"floor(x / 1cm) * 1cm", "floor(x / 1cm)", "jumps"},
    BadFormula{"x / y * 1cm", "x / y", "divides by"},
    BadFormula{"1cm ^ 2 / x", "1cm ^ 2 / x", "divides by"},
    BadFormula{"1cm * tan(x / 1mm * 10)", "tan(x / 1mm * 10)", "divides by"},
    BadFormula{"sqrt(x * 1cm) - 1cm", "sqrt(x * 1cm)", "below 0"},
    BadFormula{"sqrt(abs(x) * 1cm) + y - 1mm", "sqrt(abs(x) * 1cm)", "steep"},
    BadFormula{"log(x / 1cm) * 1cm", "log(x / 1cm)", "below 0"},
    BadFormula{"x * sign(y) - 1cm", "sign(y)", "jumps"},
    BadFormula{"length(x % 2cm, y) - 5mm", "x % 2cm", "jumps"},
    BadFormula{"y - 1cm - (x ^ 2 / 2cm if 1cm > x else x - 4mm)", "x ^ 2 / 2cm if 1cm > x else x - 4mm", "one branch"},
    BadFormula{"y - 1cm - (1mm + x if x > 0 else x)", "1mm + x if x > 0 else x", "one branch"},
    BadFormula{"y - 1cm if x > 0 and y < 1m else y", "y - 1cm if x > 0 and y < 1m else y", "one branch"},
    BadFormula{"x if y > 0 else 1cm - x", "x if y > 0 else 1cm - x", "one branch"},
    BadFormula{"length(x, y) - 1mm * sin(3.5 * atan2(y, x)) - 2cm", "atan2(y, x)", "jumps"},
    BadFormula{"length(x, y) - 2cm - 1cm * abs(cos(2.25 * atan2(y, x)))", "atan2(y, x)", "jumps"},
    BadFormula{"length(x, y) - 2cm - 1cm * cos(2.5 * atan2(y, x))", "atan2(y, x)", "jumps"},
    BadFormula{"length(x, y) - 2cm - 1mm * sin(4 * atan2(y, x) + 180 * floor(x / 1cm))", "floor(x / 1cm)", "jumps"},
    BadFormula{"1mm * atan2(y, x) / 1deg", "atan2(y, x)", "jumps"},
    BadFormula{"length(x, y) / length(x, y) * 1cm - 1mm", "length(x, y) / length(x, y)", "divides by"},
    BadFormula{"(x / 1cm) ^ 0.5 * 1cm", "(x / 1cm) ^ 0.5", "below 0"},
    BadFormula{"(abs(x) / 1cm) ^ 0.5 * 1cm", "(abs(x) / 1cm) ^ 0.5", "steep"},
};

}  // namespace pinfield::test

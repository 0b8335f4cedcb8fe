// What a field can hold, as tools see it.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/core/geometry.h"

namespace pinfield {

/// Numbers are SI; angles are degrees, as in the file (radians begin where a value is packed for a formula).
/// A choice, a color and an id are texts; `choices` and `names` are lists of choices and of ids.
enum class FieldKind : unsigned char { boolean, integer, number, vec2, points, text, choice, choices, color, id, names };

using Value = std::variant<bool, std::int64_t, double, Vec2, std::vector<Vec2>, std::string, std::vector<std::string>>;

/// Bit-for-bit equality: 0.0 and -0.0 differ, so that "unchanged" means unchanged.
bool identical(const Value& a, const Value& b);

/// The word the format uses for a kind: "number", "vec2" ...
std::string_view name(FieldKind kind);

}  // namespace pinfield

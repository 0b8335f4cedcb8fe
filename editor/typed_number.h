// What somebody types over a number: "30", "26+4", "1in", "(40mm - 2)/3".
#pragma once
#include <string_view>

#include "engine/core/result.h"
#include "engine/reflect/node_type.h"

namespace pinfield::editor {

/// The value, in the field's own unit, of a sum of quantities with + - * / and brackets. A number without a unit stands for the unit that
/// is shown: where a length of 0.026 m reads "26 mm", 30 is 0.03, and so is 26+4. What is computed is rounded to 12 digits. Fails with
/// the reason, also for a product of two quantities and for a quotient by one.
Result<double> typed_number(std::string_view text, Unit unit, std::string_view shown_unit);

}  // namespace pinfield::editor

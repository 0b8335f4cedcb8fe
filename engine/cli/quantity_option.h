// Options of the command line that are numbers as a table writes them: bare, or with a unit ("2ms").
#pragma once
#include <optional>
#include <string>

#include "engine/cli/arguments.h"
#include "engine/reflect/describe.h"

namespace pinfield::cli {

/// What is wrong with `text` as a number of this unit and range, or "". On success `value` (may be null) receives it.
std::string why_invalid_quantity(const std::string& text, Unit unit, Limit min, Limit max, double* value);

/// An option that takes one such number; anything else is wrong usage.
Option add_quantity(const Command& command, const std::string& name, std::optional<double>& target, Unit unit, Limit min, Limit max,
                    const std::string& doc);

}  // namespace pinfield::cli

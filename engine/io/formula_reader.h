// The text of a formula, where a field takes one.
#pragma once
#include <optional>
#include <string>

#include "engine/io/read_context.h"

namespace pinfield {

/// A formula as its node reads it: its x and y are left, and the params, arguments and numbers of copies that it names are put in. Nothing,
/// and the reason reported, where it is none.
std::optional<std::string> read_formula(ReadContext& context, const FieldType& field, const YamlNode& node);

}  // namespace pinfield

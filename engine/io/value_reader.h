// One field's value from the author's text.
#pragma once
#include <optional>

#include "engine/io/read_context.h"
#include "engine/reflect/node_type.h"

namespace pinfield {

/// Reads what `field` holds, checks it against the field's range, and reports what is wrong with it. `node` is
/// resolved.
std::optional<Value> read_value(ReadContext& context, const FieldType& field, const YamlNode& node);

}  // namespace pinfield

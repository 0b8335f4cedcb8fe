// Values as the author would have written them.
#pragma once
#include <string>
#include <string_view>

#include "engine/io/yaml_tree.h"
#include "engine/reflect/node_type.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// A text so that YAML reads back the same: plain where it may be, else quoted; in the quotes of `style` where they can
/// hold it.
std::string write_text(std::string_view text, YamlStyle style = YamlStyle::plain);

/// A value on one line in flow style: 0.03, [1, 2], [[0, 0], [1, 0]], crimson, "#7c5"; its numbers in the unit of
/// `like`.
std::string write_value(const FieldType& field, const Value& value, std::string_view like = {});
/// Likewise, numbers that their author wrote as expressions as such.
std::string write_slot(const FieldType& field, const FieldSlot& slot, std::string_view like = {});

/// A single value (number, word, text, color, name ...) in the style of the scalar that it replaces: its unit,
/// decimals and quotes.
std::string write_scalar_like(const FieldType& field, const Value& value, const YamlNode& scalar);
/// Likewise one component of a pair.
std::string write_number_like(const FieldType& field, double value, const YamlNode* scalar);

}  // namespace pinfield

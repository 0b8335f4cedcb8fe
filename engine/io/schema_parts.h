// What JSON Schemas of sections and of nodes are made of.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/reflect/describe.h"

namespace pinfield::schema {

using Json = nlohmann::ordered_json;

/// What is_name() lets pass.
inline constexpr const char* name_pattern = "^[a-z_][a-z0-9_]*$";

/// A definition of the schema by its name.
Json reference(const std::string& definition);
/// A number, or a text of a number with one of the unit's suffixes, in the field's range.
Json number(const FieldMeta& meta);
/// [x, y] of such numbers.
Json pair(const FieldMeta& meta);
Json one_or_list(const Json& item);
/// A map from the author's names to such values, or nothing.
Json named_map(const Json& value);
/// A list of such items, or nothing.
Json list(const Json& item);

}  // namespace pinfield::schema

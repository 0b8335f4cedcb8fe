// What the JSON Schemas of sections and of nodes are made of, as JSON text: only json_schema.cpp makes a document of it.
#pragma once
#include <string>

#include "engine/reflect/describe.h"

namespace pinfield::schema {

/// What is_name() lets pass.
inline constexpr const char* name_pattern = "^[a-z_][a-z0-9_]*$";

/// A definition of the schema by its name.
std::string reference(std::string_view definition);
/// Something that calculates: it has an operator or a bracket behind its first character, or is a name. What it says only `check` can judge.
std::string expression();
/// A number, or a text of a number with one of the unit's suffixes, in the field's range.
std::string number(const FieldMeta& meta);
/// A number with any unit or none, or a text that calculates one.
std::string any_number();
/// [x, y] of such numbers.
std::string pair(const FieldMeta& meta);
std::string one_or_list(std::string_view item);
/// A map from the author's names to such values, or nothing.
std::string named_map(std::string_view value);
/// A list of such items, or nothing.
std::string list(std::string_view item);

}  // namespace pinfield::schema

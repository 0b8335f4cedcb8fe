// Entries put into and taken out of the author's maps, in the style their neighbours have.
#pragma once
#include <string>
#include <string_view>

#include "engine/io/yaml_tree.h"

namespace pinfield {

/// Puts `text` in the place of `replaced`; every other byte of the text stays.
struct Splice {
    Span replaced;
    std::string text;
};

/// Adds "key: value" to a map so that it becomes entry `index`.
Splice insert_entry(std::string_view text, const YamlNode& map, std::size_t index, std::string_view entry);

/// Gives an entry that has no value yet the value {entry}.
Splice insert_body(std::string_view text, const YamlNode& missing, std::string_view entry);

/// Takes out entry `index`: from a flow map with its comma, from a block map with its line and the comment on it.
Splice remove_entry(std::string_view text, const YamlNode& map, std::size_t index);

}  // namespace pinfield

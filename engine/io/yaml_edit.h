// Entries put into and taken out of the author's maps and lists, in the style their neighbours have.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/yaml_tree.h"

namespace pinfield {

/// Puts `text` in the place of `replaced`; every other byte of the text stays.
struct Splice {
    Span replaced;
    std::string text;
};

/// Adds "key: value" to a map so that it becomes entry `index`. Lines after the first are indented as far as the entry.
Splice insert_entry(std::string_view text, const YamlNode& map, std::size_t index, std::string_view entry);

/// Gives an entry that has no value yet the value {entry}.
Splice insert_body(std::string_view text, const YamlNode& missing, std::string_view entry);

/// Takes out entry `index`: from a flow map with its comma, from a block map with its line and the comment on it.
Splice remove_entry(std::string_view text, const YamlNode& map, std::size_t index);

/// "\r\n" where the text's first line ends so, else "\n".
std::string_view line_break(std::string_view text);
/// Where the next line begins, or the text ends.
std::size_t next_line(std::string_view text, std::size_t at);
/// Is there nothing but blanks before `at` in its line?
bool begins_its_line(std::string_view text, std::size_t at);
/// In a line of its own or lines, from the one that holds `begin` to the one that holds `last`: taken out whole.
Splice remove_lines(std::string_view text, std::size_t begin, std::size_t last);

// What a flow map and a flow list have in common: pieces between brackets, with commas between them.
Splice insert_flow(std::string_view text, Span brackets, const std::vector<Span>& pieces, std::size_t index, std::string_view piece);
Splice remove_flow(std::string_view text, Span brackets, const std::vector<Span>& pieces, std::size_t index);

}  // namespace pinfield

// Items of the author's lists taken out, put in and carried elsewhere, with the comments that belong to them.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/yaml_edit.h"

namespace pinfield {

/// An item of a list as text that can be put elsewhere.
struct ItemText {
    std::string block;  ///< its lines and the comments above and behind; the dash in the first column, no break at the end
    std::string flow;   ///< in one line, for a list in brackets; empty where that would lose a comment or an anchor
};

/// How far lists are indented where the author writes an item a line.
struct ListStyle {
    std::size_t dash = 2;  ///< from a key to the dashes of its list
    std::size_t body = 4;  ///< from a dash to the fields of its item
};

/// What the lists of a table that has some do most often.
ListStyle list_style(std::string_view text, const YamlTree& tree);

/// The item's own lines, or its piece of a line, as they stand.
ItemText item_text(std::string_view text, const YamlNode& list, std::size_t index);
/// The same of an item that stands in no list: "- circle: {}" with its dash in the first column.
ItemText item_text(std::string block);

/// The item's lines with the comments that belong to it; in a list in brackets its piece of a line.
Span item_extent(std::string_view text, const YamlNode& list, std::size_t index);

/// Takes an item out, in a block list with its lines and comments; a list left empty becomes []. In the order of the text.
std::vector<Splice> remove_item(std::string_view text, const YamlNode& list, std::size_t index);

/// Puts an item into a list that holds some, so that it becomes item `index`; nothing where a list in brackets would lose a comment.
std::optional<Splice> insert_item(std::string_view text, const YamlNode& list, std::size_t index, const ItemText& item);

/// Puts an item into the list `key` of a map, where that list is empty or not yet there. Nothing where it cannot be done without losing a
/// comment or an anchor. In the order of the text.
std::optional<std::vector<Splice>> insert_first_item(std::string_view text, const YamlNode& body, std::string_view key, const ItemText& item,
                                                     ListStyle style);
/// The same in entry `index` of a map, whose value is such a body or is missing. In a block list the entry gets lines of its own.
std::optional<std::vector<Splice>> insert_first_item(std::string_view text, const YamlNode& map, std::size_t index, std::string_view key,
                                                     const ItemText& item, ListStyle style);

/// Comments in a node's text or between `begin` and `end`, each without its line break.
std::vector<Span> comments_in(std::string_view text, Span whole, const YamlNode& node);

/// A node once more, in one line: without its anchors, which stay where they are. Aliases stay aliases, or say what they stand for.
enum class Aliases : unsigned char { kept, written_out };
std::string copy_in_line(std::string_view text, const YamlNode& node, Aliases aliases);

/// Every line that is not empty moved to the right.
std::string indented_lines(std::string_view lines, std::size_t column);

}  // namespace pinfield

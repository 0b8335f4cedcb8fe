// Nodes and records as text: canonical, for write_table(), or in the style of the table that they are put into.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "engine/io/yaml_items.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// {a, b}
std::string flow_map(const std::vector<std::string>& entries);

/// "key: value" of each field that differs from its default or is required; the common ones first, so that a line begins with id and place.
std::vector<std::string> entries_of(const Node& node);

/// "left: [Z, LeftShift]", "[Z, LeftShift]" and "key: value" of a test, as sections write them.
std::string entry_of(const InputBinding& input);
std::string keys_text(const std::vector<std::string>& keys);
std::vector<std::string> entries_of(const TableTest& test);

/// A list of scene nodes with all below them, a line a node where it has no children, each indented by `indent`.
std::string write_nodes(const Scene& scene, const std::vector<NodeId>& nodes, std::size_t indent);

/// "  # parts/walls.yaml\n" before an item that stands in another file than the one before it, which `file` is and then is no more. Nothing
/// for one that stands nowhere.
std::string file_comment(const Scene& scene, FileId& file, const Place& place);

/// The style of the table that a new node is put into.
struct NodeStyle {
    ListStyle lists;
    std::function<std::string(Unit)> number;  ///< a number in the unit to write such quantities in; empty: without a unit
};

/// "key: value" of each field that the text is to say.
std::vector<std::string> explicit_entries(const Node& node, const NodeStyle& style);

/// A node and all in it as an item of a list, its dash in the first column; no break at the end.
std::string write_item(const Subtree& nodes, const NodeStyle& style);

/// "- type:" with the entries and, in a list of its own, the items given, each of which has its dash in the first column.
std::string write_item_around(const Node& node, const std::vector<std::string>& items, const NodeStyle& style);

}  // namespace pinfield

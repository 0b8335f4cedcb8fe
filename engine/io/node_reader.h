// Scene nodes and records from the author's text. Knows no concrete node: everything comes from the NodeType.
#pragma once
#include "engine/io/read_context.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// Fields of `node` from a map (or nothing); unknown keys, missing fields and broken contracts are reported. `key` is
/// the word the map belongs to. Keys that `skipped` holds are left to the caller.
void read_fields(ReadContext& context, Node& node, const YamlNode& key, const YamlNode& body,
                 const std::vector<std::string_view>& skipped = {});

/// The fields of a record (table, physics, a material) and where it stands.
void read_record(ReadContext& context, Node& record, const YamlNode& key, const YamlNode& body);

/// A list of scene nodes under `parent` (none: the scene itself).
void read_nodes(ReadContext& context, Scene& scene, NodeId parent, const YamlNode& list);

/// An item of a list of nodes: its one key, what stands behind it, and the type of the node that it makes.
struct NodeItem {
    const YamlNode& key;
    const YamlNode& body;
    const NodeType& type;  ///< of `use`: a group
    bool is_use() const { return key.text == "use"; }
};

/// A node without fields at the place of an item; null, and reported once, where the table has too many.
Node* add_node(ReadContext& context, Scene& scene, NodeId parent, const NodeItem& item, const NodeType& type);
/// The one node that an item says, without its copies, and all that is in it.
Node* read_single(ReadContext& context, Scene& scene, NodeId parent, const NodeItem& item);

}  // namespace pinfield

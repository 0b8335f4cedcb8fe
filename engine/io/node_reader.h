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

}  // namespace pinfield

// Scene nodes and records from the author's text. Knows no concrete node: everything comes from the NodeType.
#pragma once
#include "engine/io/read_context.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// Fields of `node` from a map (or nothing); unknown keys, missing fields and broken contracts are reported. `key` is
/// the word the map belongs to. Keys that `skipped` holds are left to the caller.
void read_fields(ReadContext& context, Node& node, const YamlNode& key, const YamlNode& body,
                 const std::vector<std::string_view>& skipped = {});

/// A list of scene nodes under `parent` (none: the scene itself).
void read_nodes(ReadContext& context, Scene& scene, NodeId parent, const YamlNode& list);

/// What only the whole scene can tell: ids said twice, materials and inputs that do not exist, domains on one layer.
void check_scene(ReadContext& context, const Scene& scene);

}  // namespace pinfield

// Nodes and records as canonical text, for write_table().
#pragma once
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace pinfield {

/// {a, b}
std::string flow_map(const std::vector<std::string>& entries);

/// "key: value" of each field that differs from its default or is required; the common ones first, so that a line begins with id and place.
std::vector<std::string> entries_of(const Node& node);

/// A list of scene nodes with all below them, a line a node where it has no children, each indented by `indent`.
std::string write_nodes(const Scene& scene, const std::vector<NodeId>& nodes, std::size_t indent);

}  // namespace pinfield

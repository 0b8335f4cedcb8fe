// All that a scene may hold: the shapes and operations of engine/sdf/catalog.h and the parts of part_list.h.
#pragma once
#include "engine/reflect/catalog.h"

namespace pinfield {

/// The built-in shapes, operations and parts, and the records `table`, `physics` and `material`; every scene node's type
/// already carries the common fields after its own. A program may add types of its own with add_scene_type().
Catalog built_in_catalog();

/// Adds a shape or operation (from sdf_node_type<N>()) to a catalog of scene nodes: appends the common fields.
const NodeType& add_scene_type(Catalog& catalog, NodeType type);

}  // namespace pinfield

// All that a scene may hold: the shapes and operations of engine/sdf/catalog.h and the parts named here.
#pragma once
#include <memory>

#include "engine/reflect/catalogue.h"
#include "engine/scene/parts/bumper.h"
#include "engine/scene/parts/domain.h"
#include "engine/scene/parts/drain.h"
#include "engine/scene/parts/flipper.h"
#include "engine/scene/parts/group.h"
#include "engine/scene/parts/plunger.h"
#include "engine/scene/parts/spawn.h"

namespace pinfield {

template <class... P>
struct PartList {};

using BuiltInParts = PartList<parts::Group, parts::Domain, parts::Flipper, parts::Bumper, parts::Plunger, parts::Drain, parts::Spawn>;

/// The built-in shapes, operations and parts, and the records `table`, `physics` and `material`; every scene node's type
/// already carries the common fields after its own. A program may add types of its own with add_scene_type().
Catalogue built_in_catalogue();

/// Adds a shape or operation (from sdf_node_type<N>()) to a catalogue of scene nodes: appends the common fields.
const NodeType& add_scene_type(Catalogue& catalogue, NodeType type);

}  // namespace pinfield

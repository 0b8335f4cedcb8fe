// Which node of one scene is which of another, when all that is known of them is what they say.
#pragma once
#include <map>

#include "engine/scene/scene.h"

namespace pinfield {

/// Nodes of `now`, each with the node of `before` that it is: by id, else among the children of the same parent by what it says, then by
/// type and order, then, with another id, where most of what it says is the same; last, anywhere, by all that it says.
std::map<NodeId, NodeId> match(const Scene& before, const Scene& now);

}  // namespace pinfield

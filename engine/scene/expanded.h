// A scene as though its author had written every node and number of it out.
#pragma once
#include "engine/scene/scene.h"

namespace pinfield {

/// The same nodes and values without params, templates, copies and expressions. Ids of made nodes become plain ones: lane.1 -> lane_1, here
/// and in the tests. It compiles into the same program. Where a node came from stays known (Node::origin).
Scene expanded(Scene scene);

/// The same of one node and what is in it; the rest of the table stays as it is, params and templates with it.
Scene expanded(Scene scene, NodeId node);

}  // namespace pinfield

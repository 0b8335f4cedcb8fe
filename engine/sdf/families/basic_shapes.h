// Discs, boxes and walls: the shapes that most tables are made of. To add one: write its header, name it here, give it a scene in
// scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/capsule.h"
#include "engine/sdf/nodes/circle.h"
#include "engine/sdf/nodes/half_plane.h"
#include "engine/sdf/nodes/segment.h"
#include "engine/sdf/nodes/uneven_capsule.h"

namespace pinfield::sdf {

using BasicShapes = NodeList<Circle, Box, Segment, Capsule, UnevenCapsule, HalfPlane>;

}  // namespace pinfield::sdf

// The shapes that everything else is compared with. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/arc.h"
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/capsule.h"
#include "engine/sdf/nodes/circle.h"
#include "engine/sdf/nodes/ellipse.h"
#include "engine/sdf/nodes/half_plane.h"
#include "engine/sdf/nodes/polygon.h"
#include "engine/sdf/nodes/regular_polygon.h"
#include "engine/sdf/nodes/segment.h"
#include "engine/sdf/nodes/star.h"
#include "engine/sdf/nodes/triangle.h"
#include "engine/sdf/nodes/uneven_capsule.h"

namespace pinfield::sdf {

using BasicShapes = NodeList<
    Circle, Box, Segment, Capsule, UnevenCapsule, HalfPlane, Triangle, Polygon, Arc, Ellipse, RegularPolygon, Star>;

}  // namespace pinfield::sdf

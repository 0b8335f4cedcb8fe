// Figures that everything else is compared with. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/arc.h"
#include "engine/sdf/nodes/ellipse.h"
#include "engine/sdf/nodes/polygon.h"
#include "engine/sdf/nodes/regular_polygon.h"
#include "engine/sdf/nodes/star.h"
#include "engine/sdf/nodes/triangle.h"

namespace pinfield::sdf {

using BasicFigures = NodeList<Triangle, Polygon, Arc, Ellipse, RegularPolygon, Star>;

}  // namespace pinfield::sdf

// Bezier curves and conic sections, with thickness. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/cubic_bezier.h"
#include "engine/sdf/nodes/hyperbola.h"
#include "engine/sdf/nodes/parabola.h"
#include "engine/sdf/nodes/parabola_segment.h"
#include "engine/sdf/nodes/quadratic_bezier.h"

namespace pinfield::sdf {

using BeziersAndConics = NodeList<QuadraticBezier, CubicBezier, Parabola, ParabolaSegment, Hyperbola>;

}  // namespace pinfield::sdf

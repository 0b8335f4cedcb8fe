// Shapes along other curves. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/blobby_cross.h"
#include "engine/sdf/nodes/circle_wave.h"
#include "engine/sdf/nodes/cubic_bezier.h"
#include "engine/sdf/nodes/hyperbola.h"
#include "engine/sdf/nodes/parabola.h"
#include "engine/sdf/nodes/parabola_segment.h"
#include "engine/sdf/nodes/path.h"
#include "engine/sdf/nodes/quadratic_bezier.h"
#include "engine/sdf/nodes/quadratic_circle.h"
#include "engine/sdf/nodes/spiral.h"

namespace pinfield::sdf {

using ShapesOfCurves = NodeList<
    QuadraticBezier, CubicBezier, Parabola, ParabolaSegment, Hyperbola, BlobbyCross, QuadraticCircle, CircleWave, Spiral, Path>;

}  // namespace pinfield::sdf

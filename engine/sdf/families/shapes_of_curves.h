// Shapes along other curves. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/blobby_cross.h"
#include "engine/sdf/nodes/circle_wave.h"
#include "engine/sdf/nodes/formula.h"
#include "engine/sdf/nodes/path.h"
#include "engine/sdf/nodes/quadratic_circle.h"
#include "engine/sdf/nodes/spiral.h"

namespace pinfield::sdf {

using ShapesOfCurves = NodeList<BlobbyCross, QuadraticCircle, CircleWave, Spiral, Path, Formula>;

}  // namespace pinfield::sdf

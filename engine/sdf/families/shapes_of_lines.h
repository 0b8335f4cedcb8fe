// Shapes whose outline is mostly straight. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/arrow.h"
#include "engine/sdf/nodes/chamfer_box.h"
#include "engine/sdf/nodes/cross.h"
#include "engine/sdf/nodes/equilateral_triangle.h"
#include "engine/sdf/nodes/hexagon.h"
#include "engine/sdf/nodes/hexagram.h"
#include "engine/sdf/nodes/isosceles_triangle.h"
#include "engine/sdf/nodes/octagon.h"
#include "engine/sdf/nodes/oriented_box.h"
#include "engine/sdf/nodes/parallelogram.h"
#include "engine/sdf/nodes/pentagon.h"
#include "engine/sdf/nodes/pentagram.h"
#include "engine/sdf/nodes/rhombus.h"
#include "engine/sdf/nodes/rounded_box.h"
#include "engine/sdf/nodes/square_stairs.h"
#include "engine/sdf/nodes/stairs.h"
#include "engine/sdf/nodes/trapezoid.h"

namespace pinfield::sdf {

using ShapesOfLines = NodeList<
    ChamferBox, RoundedBox, OrientedBox, Rhombus, Trapezoid, Parallelogram, IsoscelesTriangle, EquilateralTriangle, Pentagon, Hexagon,
    Octagon, Hexagram, Pentagram, Cross, Stairs, SquareStairs, Arrow>;

}  // namespace pinfield::sdf

// Three and four corners, some of them cut or rounded. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/chamfer_box.h"
#include "engine/sdf/nodes/equilateral_triangle.h"
#include "engine/sdf/nodes/isosceles_triangle.h"
#include "engine/sdf/nodes/oriented_box.h"
#include "engine/sdf/nodes/parallelogram.h"
#include "engine/sdf/nodes/rhombus.h"
#include "engine/sdf/nodes/rounded_box.h"
#include "engine/sdf/nodes/trapezoid.h"

namespace pinfield::sdf {

using BoxesAndTriangles = NodeList<
    ChamferBox, RoundedBox, OrientedBox, Rhombus, Trapezoid, Parallelogram, IsoscelesTriangle, EquilateralTriangle>;

}  // namespace pinfield::sdf

// Shapes with more corners than four. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/arrow.h"
#include "engine/sdf/nodes/cross.h"
#include "engine/sdf/nodes/hexagon.h"
#include "engine/sdf/nodes/hexagram.h"
#include "engine/sdf/nodes/octagon.h"
#include "engine/sdf/nodes/pentagon.h"
#include "engine/sdf/nodes/pentagram.h"
#include "engine/sdf/nodes/square_stairs.h"
#include "engine/sdf/nodes/stairs.h"

namespace pinfield::sdf {

using ShapesOfLines = NodeList<
    Pentagon, Hexagon, Octagon, Hexagram, Pentagram, Cross, Stairs, SquareStairs, Arrow>;

}  // namespace pinfield::sdf

// Figures whose outline is mostly arcs of circles. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/circle_cross.h"
#include "engine/sdf/nodes/cool_s.h"
#include "engine/sdf/nodes/egg.h"
#include "engine/sdf/nodes/heart.h"
#include "engine/sdf/nodes/rounded_x.h"
#include "engine/sdf/nodes/tunnel.h"

namespace pinfield::sdf {

using ShapesOfArcs = NodeList<Egg, Heart, RoundedX, CircleCross, Tunnel, CoolS>;

}  // namespace pinfield::sdf

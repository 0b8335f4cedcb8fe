// Shapes whose outline is mostly arcs of circles. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/circle_cross.h"
#include "engine/sdf/nodes/cool_s.h"
#include "engine/sdf/nodes/cut_disk.h"
#include "engine/sdf/nodes/egg.h"
#include "engine/sdf/nodes/heart.h"
#include "engine/sdf/nodes/horseshoe.h"
#include "engine/sdf/nodes/joint.h"
#include "engine/sdf/nodes/moon.h"
#include "engine/sdf/nodes/oriented_vesica.h"
#include "engine/sdf/nodes/pie.h"
#include "engine/sdf/nodes/ring.h"
#include "engine/sdf/nodes/rounded_x.h"
#include "engine/sdf/nodes/tunnel.h"
#include "engine/sdf/nodes/vesica.h"

namespace pinfield::sdf {

using ShapesOfArcs = NodeList<
    Pie, Moon, Ring, CutDisk, Horseshoe, Joint, Vesica, OrientedVesica, Egg, Heart, RoundedX, CircleCross, Tunnel, CoolS>;

}  // namespace pinfield::sdf

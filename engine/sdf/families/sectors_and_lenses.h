// Parts of discs and rings, and what two discs have in common or apart. To add one: write its header, name it here, give it a scene in
// scenes/nodes/.
#pragma once
#include "engine/sdf/node_list.h"
#include "engine/sdf/nodes/cut_disk.h"
#include "engine/sdf/nodes/horseshoe.h"
#include "engine/sdf/nodes/joint.h"
#include "engine/sdf/nodes/moon.h"
#include "engine/sdf/nodes/oriented_vesica.h"
#include "engine/sdf/nodes/pie.h"
#include "engine/sdf/nodes/ring.h"
#include "engine/sdf/nodes/vesica.h"

namespace pinfield::sdf {

using SectorsAndLenses = NodeList<Pie, Moon, Ring, CutDisk, Horseshoe, Joint, Vesica, OrientedVesica>;

}  // namespace pinfield::sdf

// Operations. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/found_outline.h"
#include "engine/sdf/node_list.h"
#include "engine/sdf/operations/bend.h"
#include "engine/sdf/operations/complement.h"
#include "engine/sdf/operations/difference.h"
#include "engine/sdf/operations/displace.h"
#include "engine/sdf/operations/elongate.h"
#include "engine/sdf/operations/inset.h"
#include "engine/sdf/operations/intersection.h"
#include "engine/sdf/operations/lerp.h"
#include "engine/sdf/operations/mirror.h"
#include "engine/sdf/operations/onion.h"
#include "engine/sdf/operations/repeat.h"
#include "engine/sdf/operations/repeat_infinite.h"
#include "engine/sdf/operations/repeat_polar.h"
#include "engine/sdf/operations/round.h"
#include "engine/sdf/operations/smooth_difference.h"
#include "engine/sdf/operations/smooth_intersection.h"
#include "engine/sdf/operations/smooth_union.h"
#include "engine/sdf/operations/stretch.h"
#include "engine/sdf/operations/twist.h"
#include "engine/sdf/operations/union.h"
#include "engine/sdf/operations/xor.h"

namespace pinfield::sdf {

using Operations = NodeList<
    Union, Intersection, Difference, Xor, Complement, SmoothUnion, SmoothIntersection, SmoothDifference, Lerp, Round, Inset,
    Onion, Mirror, Repeat, RepeatPolar, RepeatInfinite, Elongate, Stretch, Twist, Bend, Displace,
    FoundOutline  // last: no node of any table, only compiling one makes use of it
    >;

}  // namespace pinfield::sdf

// THE list of shapes and operations. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/nodes/arc.h"
#include "engine/sdf/nodes/blobby_cross.h"
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/capsule.h"
#include "engine/sdf/nodes/circle.h"
#include "engine/sdf/nodes/circle_wave.h"
#include "engine/sdf/nodes/cubic_bezier.h"
#include "engine/sdf/nodes/ellipse.h"
#include "engine/sdf/nodes/half_plane.h"
#include "engine/sdf/nodes/hyperbola.h"
#include "engine/sdf/nodes/moon.h"
#include "engine/sdf/nodes/parabola.h"
#include "engine/sdf/nodes/parabola_segment.h"
#include "engine/sdf/nodes/path.h"
#include "engine/sdf/nodes/pie.h"
#include "engine/sdf/nodes/polygon.h"
#include "engine/sdf/nodes/quadratic_bezier.h"
#include "engine/sdf/nodes/quadratic_circle.h"
#include "engine/sdf/nodes/regular_polygon.h"
#include "engine/sdf/nodes/segment.h"
#include "engine/sdf/nodes/spiral.h"
#include "engine/sdf/nodes/star.h"
#include "engine/sdf/nodes/triangle.h"
#include "engine/sdf/nodes/uneven_capsule.h"
#include "engine/sdf/operations/complement.h"
#include "engine/sdf/operations/difference.h"
#include "engine/sdf/operations/inset.h"
#include "engine/sdf/operations/intersection.h"
#include "engine/sdf/operations/lerp.h"
#include "engine/sdf/operations/mirror.h"
#include "engine/sdf/operations/onion.h"
#include "engine/sdf/operations/repeat.h"
#include "engine/sdf/operations/repeat_polar.h"
#include "engine/sdf/operations/round.h"
#include "engine/sdf/operations/smooth_difference.h"
#include "engine/sdf/operations/smooth_intersection.h"
#include "engine/sdf/operations/smooth_union.h"
#include "engine/sdf/operations/union.h"
#include "engine/sdf/operations/xor.h"

namespace pinfield::sdf {

template <template <class> class... N>
struct NodeList {
    static constexpr int size = sizeof...(N);
};

using BuiltIn = NodeList<
    // shapes
    Circle, Box, Segment, Capsule, UnevenCapsule, HalfPlane, Triangle, Polygon, Arc, Ellipse, RegularPolygon, Star,
    Pie, Moon,
    QuadraticBezier, CubicBezier, Parabola, ParabolaSegment, Hyperbola, BlobbyCross, QuadraticCircle, CircleWave,
    Spiral, Path,
    // operations
    Union, Intersection, Difference, Xor, Complement, SmoothUnion, SmoothIntersection, SmoothDifference, Lerp, Round, Inset,
    Onion, Mirror, Repeat, RepeatPolar>;

}  // namespace pinfield::sdf

// THE list of shapes and operations. To add one: write its header, name it here, give it a scene in scenes/nodes/.
#pragma once
#include "engine/sdf/boundary.h"
#include "engine/sdf/nodes/arc.h"
#include "engine/sdf/nodes/arrow.h"
#include "engine/sdf/nodes/blobby_cross.h"
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/capsule.h"
#include "engine/sdf/nodes/chamfer_box.h"
#include "engine/sdf/nodes/circle.h"
#include "engine/sdf/nodes/circle_cross.h"
#include "engine/sdf/nodes/circle_wave.h"
#include "engine/sdf/nodes/cool_s.h"
#include "engine/sdf/nodes/cross.h"
#include "engine/sdf/nodes/cubic_bezier.h"
#include "engine/sdf/nodes/cut_disk.h"
#include "engine/sdf/nodes/egg.h"
#include "engine/sdf/nodes/ellipse.h"
#include "engine/sdf/nodes/equilateral_triangle.h"
#include "engine/sdf/nodes/half_plane.h"
#include "engine/sdf/nodes/heart.h"
#include "engine/sdf/nodes/hexagon.h"
#include "engine/sdf/nodes/hexagram.h"
#include "engine/sdf/nodes/horseshoe.h"
#include "engine/sdf/nodes/hyperbola.h"
#include "engine/sdf/nodes/isosceles_triangle.h"
#include "engine/sdf/nodes/joint.h"
#include "engine/sdf/nodes/moon.h"
#include "engine/sdf/nodes/octagon.h"
#include "engine/sdf/nodes/oriented_box.h"
#include "engine/sdf/nodes/oriented_vesica.h"
#include "engine/sdf/nodes/parabola.h"
#include "engine/sdf/nodes/parabola_segment.h"
#include "engine/sdf/nodes/parallelogram.h"
#include "engine/sdf/nodes/path.h"
#include "engine/sdf/nodes/pentagon.h"
#include "engine/sdf/nodes/pentagram.h"
#include "engine/sdf/nodes/pie.h"
#include "engine/sdf/nodes/polygon.h"
#include "engine/sdf/nodes/quadratic_bezier.h"
#include "engine/sdf/nodes/quadratic_circle.h"
#include "engine/sdf/nodes/regular_polygon.h"
#include "engine/sdf/nodes/rhombus.h"
#include "engine/sdf/nodes/ring.h"
#include "engine/sdf/nodes/rounded_box.h"
#include "engine/sdf/nodes/rounded_x.h"
#include "engine/sdf/nodes/segment.h"
#include "engine/sdf/nodes/spiral.h"
#include "engine/sdf/nodes/square_stairs.h"
#include "engine/sdf/nodes/stairs.h"
#include "engine/sdf/nodes/star.h"
#include "engine/sdf/nodes/trapezoid.h"
#include "engine/sdf/nodes/triangle.h"
#include "engine/sdf/nodes/tunnel.h"
#include "engine/sdf/nodes/uneven_capsule.h"
#include "engine/sdf/nodes/vesica.h"
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

template <template <class> class... N>
struct NodeList {
    static constexpr int size = sizeof...(N);
};

using BuiltIn = NodeList<
    // shapes
    Circle, Box, Segment, Capsule, UnevenCapsule, HalfPlane, Triangle, Polygon, Arc, Ellipse, RegularPolygon, Star,
    ChamferBox, RoundedBox, OrientedBox, Rhombus, Trapezoid, Parallelogram, IsoscelesTriangle, EquilateralTriangle, Pentagon, Hexagon,
    Octagon, Hexagram, Pentagram, Cross, Stairs, SquareStairs, Arrow,
    Pie, Moon, Ring, CutDisk, Horseshoe, Joint, Vesica, OrientedVesica, Egg, Heart, RoundedX, CircleCross, Tunnel, CoolS,
    QuadraticBezier, CubicBezier, Parabola, ParabolaSegment, Hyperbola, BlobbyCross, QuadraticCircle, CircleWave, Spiral, Path,
    // operations
    Union, Intersection, Difference, Xor, Complement, SmoothUnion, SmoothIntersection, SmoothDifference, Lerp, Round, Inset,
    Onion, Mirror, Repeat, RepeatPolar, Elongate, Stretch, Twist, Bend, Displace>;

/// What kernels are compiled for: the list, and what only compiling a table makes use of.
template <template <class> class... N>
NodeList<N..., Boundary> with_boundary(NodeList<N...>);
using Compiled = decltype(with_boundary(BuiltIn{}));

}  // namespace pinfield::sdf

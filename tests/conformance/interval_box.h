// Boxes of points as intervals, and what enclosures of values and gradients over them are made of.
#pragma once
#include "engine/core/geometry.h"
#include "engine/sdf/interval.h"

namespace pinfield::sdf {

/// A box of points, in the frame it is asked in.
using IntervalBox = Point<Interval>;

inline IntervalBox interval_box(const Box2& box) { return {{box.lo.x(), box.hi.x()}, {box.lo.y(), box.hi.y()}}; }
inline IntervalBox interval_box(const Vec2& p) { return {Interval(p.x()), Interval(p.y())}; }

/// Holds the images of a box's points, by the arithmetic of Similarity's own operator*: also as doubles have them.
inline IntervalBox operator*(const Similarity& m, const IntervalBox& box) {
    const Interval c(m.cosine), s(m.sine), scale(m.scale), y = m.mirrored ? -box.y : box.y;
    return {Interval(m.offset.x()) + scale * (c * box.x - s * y), Interval(m.offset.y()) + scale * (s * box.x + c * y)};
}

/// A value and its gradient over a box. The gradient's is right up to jumps of the value.
struct IntervalSample {
    Interval value, dx, dy;
};

/// Where a warp sends a box, what it adds there, and the derivatives of both.
struct IntervalWarped {
    IntervalSample x, y, lift;
};

}  // namespace pinfield::sdf

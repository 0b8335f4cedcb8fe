// Closed loops of points on the zero line of an op's field: where it crosses a lattice laid over the solid.
#pragma once
#include <optional>
#include <vector>

#include "engine/program/program.h"

namespace pinfield {

/// A place on the zero line.
struct ZeroPoint {
    Vec2 at{0, 0};
    Vec2 along{1, 0};  ///< unit, the solid on the left
    double slope = 0;  ///< length of the field's gradient
};

/// What the field says at p, a point of its zero line; nothing where it has no gradient.
std::optional<ZeroPoint> zero_point_at(const Field& field, int op, const Vec2& p);

/// The field's zero point on the line through p along the gradient, found by Newton's iteration; nothing where that does not settle.
std::optional<ZeroPoint> zero_point_near(const Field& field, int op, const Vec2& p, double size);

/// A place where two smooth parts of the zero line meet.
struct ZeroCorner {
    Vec2 at{0, 0};
    double sine = 1;  ///< of the angle by which it turns there, > 0
};

/// The corner of the zero line within about `reach` of p; nothing where the line is smooth.
std::optional<ZeroCorner> zero_corner_near(const Field& field, int op, const Vec2& p, double reach, double size);

/// Of the zero line within a window.
struct ZeroLoops {
    std::vector<std::vector<ZeroPoint>> loops;  ///< the solid on the left
    bool complete = true;                       ///< no place is left that may hide more of the line
};

/// All loops within `window`, a square: neighbouring points are at most a 128th of its side apart. What is at least an 8192nd of the side
/// wide, the solid's or what is around it, is seen, and a tenth of a millimetre whatever the side. Nothing when too much of the window may
/// hide something smaller, and nothing when the line leaves it.
std::optional<ZeroLoops> zero_loops(const Field& field, int op, const Box2& window);

}  // namespace pinfield

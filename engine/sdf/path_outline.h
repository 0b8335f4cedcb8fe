// What a path of pieces looks like from outside, in double: boxes, joints, and its boundary where the pieces are lines and arcs.
#pragma once
#include <vector>

#include "engine/core/geometry.h"
#include "engine/sdf/outline.h"
#include "engine/sdf/path_piece.h"
#include "engine/sdf/plain_stroke.h"

namespace pinfield::sdf {

/// At t from 0 to 1; no direction where the piece stands still.
CurvePoint curve_point(const PieceView& piece, double t);
/// An upper bound of the way gone in a unit of t.
double top_speed_of(const PieceView& piece);
/// Smallest box around a piece.
Box2 bounds_of(const PieceView& piece);
/// Without a kink, of pieces the one of which begins where the other ends.
bool joins_smoothly(const PieceView& arriving, const PieceView& leaving);

/// The circle of an arc is at most 100 times as wide as its points are apart, or the arc at most half of it.
bool is_drawn_well(const PieceView& arc);
/// A line, or an arc with a centre close enough to be told apart from its neighbours.
bool has_parallels(const PieceView& piece);
/// The pieces as they are given, closed by a straight one; of pieces that have parallels.
Outline loop_along(const std::vector<PieceView>& pieces);
/// The boundary of a wall that overlaps itself nowhere along pieces that have parallels and join smoothly.
void outline_wall(const std::vector<PieceView>& pieces, double half_thickness, bool closes, Outline& out);

}  // namespace pinfield::sdf

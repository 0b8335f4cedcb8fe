// Distances and insides straight from an outline's definition, written apart from the engine's formulas.
#pragma once
#include <vector>

#include "engine/sdf/outline.h"
#include "tests/conformance/subject.h"

namespace pinfield::conformance {

double distance_to_piece(const Vec2& p, const sdf::Piece& piece);
double distance_to_outline(const Vec2& p, const sdf::Outline& pieces);

/// A closed curve given by points in order.
using Loop = std::vector<Vec2>;
/// Distance to the smooth closed curve through many points, by the parabola through the nearest one and its neighbours.
double distance_to_loop(const Vec2& p, const Loop& loop);

/// Points along a piece, ends included.
std::vector<Vec2> points_along(const sdf::Piece& piece, int count);
/// The pieces as chains of points, arcs cut into short chords.
std::vector<Loop> chords_of(const sdf::Outline& pieces);
/// Even-odd rule; wrong nearer to an arc than its chords' sagitta. A closed chain joins its last point to its first.
bool is_inside(const Vec2& p, const std::vector<Loop>& chains, bool closed);

}  // namespace pinfield::conformance

// Outlines cut at their meeting points: what finding the boundary of a CSG tree and of an offset have in common.
#pragma once
#include <vector>

#include "engine/core/geometry.h"
#include "engine/sdf/outline.h"

namespace pinfield {

/// A piece to be cut. Pieces of one owner leave each other whole.
struct CutPiece {
    sdf::Piece piece;
    int owner = 0;
    int origin = 0;  ///< op that it comes from
    Box2 box;
    std::vector<Vec2> cuts{};
};
CutPiece cut_piece_of(const sdf::Piece& piece, int owner, int origin);

/// Finds where edges meet; closer than `tolerance` (metres) counts as touching.
void cut_all(std::vector<CutPiece>& edges, double tolerance);

/// The edge from cut to cut.
std::vector<sdf::Piece> parts_of(const CutPiece& edge);

/// A point of the piece away from its ends and, for an uncut circle, from `touched`; with the normal to its right.
struct Probe {
    Vec2 at, right;
};
Probe probe_of(const sdf::Piece& piece, const std::vector<Vec2>& touched);

}  // namespace pinfield

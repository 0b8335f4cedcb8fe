// Time of impact of a moving ball against the boundary pieces of lowered solids: the ball's centre against the curve at
// distance `radius` from a segment, an arc, or a corner.
#pragma once
#include <vector>

#include "engine/physics/motion.h"
#include "engine/program/program.h"
#include "engine/sdf/piece.h"

namespace pinfield {

/// A boundary piece with what every sweep needs of it worked out. The centre of a segment is its middle: heights count from there, so that
/// a mirrored one has the same bits.
struct SweepPiece : sdf::Piece {
    Vec2 along{1, 0}, normal{0, 1};  ///< segments: unit, from a to b, and out of the solid
    double length = 0;               ///< metres; segments
    bool corner_a = true, corner_b = true;  ///< a ball can touch that end alone: a convex corner, or a loose end
    int solid = 0, leaf = 0;
    LayerMask layers = ground_layer;
};

/// Pieces of a field in its order. Ends where two pieces join smoothly, or in a concave corner, are no corners.
std::vector<SweepPiece> prepare_pieces(const Field& field);

/// The point of a piece nearest to p.
struct Foot {
    double distance = infinity;  ///< unsigned
    Vec2 normal{0, 0};           ///< unit, from the foot to p
    double concave_radius = 0;   ///< radius of curvature of a concave arc met from inside, else 0
    double convex_radius = infinity;  ///< likewise of what is met from outside: 0 a corner, infinity a straight side or a concave arc
    bool outside = true;         ///< p is on the free side, and the foot is a place that a ball can touch
};
Foot nearest_on(const SweepPiece& piece, const Vec2& p);
/// The foot's distance alone: metres, unsigned.
double distance_to(const SweepPiece& piece, const Vec2& p);

struct PieceHit {
    double time = infinity;
    Vec2 normal{0, 0};    ///< unit, out of the solid
    bool capped = false;  ///< the budget ran out: clear until `time`, unknown beyond
};

/// First contact within `duration`. Straight paths are closed form; a parabola against a line too, and against arcs and
/// corners it is advanced by steps that are certified by the exact range of the second derivative.
PieceHit sweep_piece(const SweepPiece& piece, const Motion& motion, double duration, double radius, const ContactBand& band,
                     int& evaluations);

}  // namespace pinfield

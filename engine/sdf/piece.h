// A piece of a boundary, a line or an arc: where it runs, which directions it sweeps, how far it is from a point and where it is nearest.
// Whoever needs pieces with more to them (outlines in packets of numbers, times of impact) makes them from these.
//
// Sums and products are written so that reflecting an axis, swapping x and y, or walking a piece from its other end
// gives the same bits: a mirrored table then plays the mirrored game.
#pragma once
#include <cmath>

#include "engine/core/geometry.h"

namespace pinfield::sdf {

using pinfield::cross;  // of Eigen vectors, beside those of scalar.h
using pinfield::dot;

/// A straight or circular piece of an outline, from a to b with the solid on its left.
/// A segment has turn == 0. An arc runs about `centre` with `radius`, counter-clockwise when turn > 0 (the solid is on the
/// centre's side) and clockwise when turn < 0; a == b means the full circle.
struct Piece {
    Vec2 a{0, 0}, b{0, 0};
    Vec2 centre{0, 0};
    double radius = 0;  ///< metres; arcs only
    int turn = 0;
    bool reflex = false;  ///< arcs only: sweeps more than half a turn

    static Piece segment(const Vec2& a, const Vec2& b) { return {a, b, {0, 0}, 0, 0, false}; }
    static Piece arc(const Vec2& centre, double radius, const Vec2& a, const Vec2& b, int turn, bool reflex) {
        return {a, b, centre, radius, turn, reflex};
    }
    static Piece circle(const Vec2& centre, double radius, int turn = 1) {
        const Vec2 start = centre + Vec2(radius, 0);
        return {start, start, centre, radius, turn, true};
    }
    bool is_arc() const { return turn != 0; }
    bool is_full_circle() const { return turn != 0 && reflex && a == b; }
};

/// Does the direction `q` from an arc's centre lie within its sweep (ends included)?
inline bool in_sweep(const Piece& arc, const Vec2& q) {
    if (arc.is_full_circle()) return true;
    const Vec2 first = (arc.turn > 0 ? arc.a : arc.b) - arc.centre, last = (arc.turn > 0 ? arc.b : arc.a) - arc.centre;
    if (arc.reflex) return !(cross(last, q) > 0 && cross(q, first) > 0);
    return cross(first, q) >= 0 && cross(q, last) >= 0;
}

/// Square of the distance from p to the piece; inline, as the innermost step of searches over many pieces.
inline double squared_distance_to_piece(const Piece& piece, const Vec2& p) {
    if (piece.turn == 0) {
        const Vec2 half = 0.5 * (piece.b - piece.a), q = p - 0.5 * (piece.a + piece.b);
        const double along = dot(q, half), reach = dot(half, half);
        if (along >= reach) return dot(p - piece.b, p - piece.b);
        if (along <= -reach) return dot(p - piece.a, p - piece.a);
        const double across = cross(half, q);
        return across * across / reach;
    }
    const Vec2 q = p - piece.centre;
    if (in_sweep(piece, q)) {
        const double gap = length(q) - piece.radius;
        return gap * gap;
    }
    return std::min(dot(p - piece.a, p - piece.a), dot(p - piece.b, p - piece.b));
}

inline double distance_to_piece(const Piece& piece, const Vec2& p) { return std::sqrt(squared_distance_to_piece(piece, p)); }

/// The nearest point of a piece, and what is known there.
struct PieceFoot {
    Vec2 foot{0, 0};
    double distance = infinity;  ///< unsigned
    bool interior = false;       ///< of the piece, not one of its ends: then the next two are known
    bool inside = false;         ///< p is on the solid's side
    Vec2 normal{0, 0};           ///< unit, out of the solid
};
/// `normal` of an end is the direction from the end to p: the solid's other piece there may see p on its other side.
PieceFoot foot_on_piece(const Piece& piece, const Vec2& p);

/// Unit direction of travel at the place p of a piece; 0 where there is none.
Vec2 direction_at(const Piece& piece, const Vec2& p);
/// Where the piece is at a share of its chord; of an arc of less than half a turn, or a segment.
Vec2 point_at_share(const Piece& piece, double share);
/// Halfway along.
Vec2 middle_of(const Piece& piece);
/// Grows with the position of p along the piece, from its start: by no measure of length.
double position_along(const Piece& piece, const Vec2& p);

/// The same piece, walked the other way.
Piece reversed(const Piece& piece);
/// Between two places of a piece, in its direction; of a full circle, from one round to the other.
Piece part_of(const Piece& piece, const Vec2& from, const Vec2& to);
/// The piece seen in another frame. A mirrored one runs the other way round to keep the solid on its left; an arc then turns as before.
Piece transformed(const Similarity& to_from, const Piece& piece);

/// Smallest box around a piece.
Box2 bounds_of(const Piece& piece);
/// The greatest distance of its points from the origin.
double farthest_from_origin(const Piece& piece);
/// Between an arc and its chord, m^2; positive where the arc turns counter-clockwise.
double area_beside_chord(const Piece& arc);

}  // namespace pinfield::sdf

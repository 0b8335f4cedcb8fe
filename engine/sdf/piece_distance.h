// Point against boundary piece, the innermost step of every distance query; inline for the searches over many pieces.
// Sums and products are written so that reflecting an axis, swapping x and y, or walking a piece from its other end
// gives the same bits: a mirrored table then plays the mirrored game.
#pragma once
#include "engine/core/geometry.h"
#include "engine/sdf/outline.h"

namespace pinfield::sdf {

using pinfield::cross;  // of Eigen vectors, beside those of scalar.h
using pinfield::dot;

/// Does the direction `q` from an arc's centre lie within its sweep (ends included)?
inline bool in_sweep(const Piece& arc, const Vec2& q) {
    if (arc.is_full_circle()) return true;
    const Vec2 first = (arc.turn > 0 ? arc.a : arc.b) - arc.centre, last = (arc.turn > 0 ? arc.b : arc.a) - arc.centre;
    if (arc.reflex) return !(cross(last, q) > 0 && cross(q, first) > 0);
    return cross(first, q) >= 0 && cross(q, last) >= 0;
}

/// Square of the distance from p to the piece.
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

/// The nearest point of a piece, and what is known there.
struct PieceFoot {
    Vec2 foot{0, 0};
    double distance = infinity;  ///< unsigned
    bool interior = false;       ///< of the piece, not one of its ends: then the next two are known
    bool inside = false;         ///< p is on the solid's side
    Vec2 normal{0, 0};           ///< unit, out of the solid
};

inline PieceFoot foot_on_end(const Vec2& end, const Vec2& p, const Vec2& normal) {
    const Vec2 from_end = p - end;
    const double distance = length(from_end);
    if (distance > 0) return {end, distance, false, false, from_end / distance};
    return {end, 0, true, false, normal};
}

/// `normal` of an end is the direction from the end to p: the solid's other piece there may see p on its other side.
inline PieceFoot foot_on_piece(const Piece& piece, const Vec2& p) {
    if (piece.turn == 0) {
        const Vec2 half = 0.5 * (piece.b - piece.a), middle = 0.5 * (piece.a + piece.b), q = p - middle;
        const double along = dot(q, half), reach = dot(half, half), half_length = std::sqrt(reach);
        const Vec2 normal = half_length > 0 ? Vec2(half.y() / half_length, -half.x() / half_length) : Vec2(1, 0);
        if (along >= reach) return foot_on_end(piece.b, p, normal);
        if (along <= -reach) return foot_on_end(piece.a, p, normal);
        const double across = cross(half, q);
        return {middle + (along / reach) * half, std::fabs(across) / half_length, true, across > 0, normal};
    }
    const Vec2 q = p - piece.centre;
    const double rho = length(q), outward = piece.turn > 0 ? 1.0 : -1.0;
    if (in_sweep(piece, q)) {
        const Vec2 ray = rho > 0 ? Vec2(q / rho) : Vec2((piece.a - piece.centre) / piece.radius);
        const double gap = rho - piece.radius;
        return {piece.centre + piece.radius * ray, std::fabs(gap), true, outward * gap < 0, outward * ray};
    }
    const bool at_b = dot(p - piece.b, p - piece.b) < dot(p - piece.a, p - piece.a);
    const Vec2& end = at_b ? piece.b : piece.a;
    return foot_on_end(end, p, outward * (end - piece.centre) / piece.radius);
}

/// The same piece, walked the other way.
inline Piece reversed(const Piece& piece) {
    Piece out = piece;
    std::swap(out.a, out.b);
    out.turn = -piece.turn;
    return out;
}

/// Smallest box around a piece.
inline Box2 bounds_of(const Piece& piece) {
    Box2 box = Box2::of(piece.a, piece.b);
    if (!piece.is_arc()) return box;
    for (const Vec2& ray : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)})
        if (in_sweep(piece, ray)) box = box.including(piece.centre + piece.radius * ray);
    return box;
}

}  // namespace pinfield::sdf

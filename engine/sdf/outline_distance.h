// The one distance formula of every shape that is written as its outline of lines and arcs alone (HasOutlineOnly in packet_kernels.h):
// exact on both sides, with a unit gradient everywhere. The outline is packed once, by pack_outline(); a query looks at every piece, or,
// one at a time, by boxes around groups of them.
#pragma once
#include <type_traits>

#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// One piece of a packed outline: part of a line or circle from a to b, of at most half a turn, the solid on its left.
/// `curvature` is 1/radius, positive where the solid is on the centre's side, 0 for a line, and (apex, normal) any point of the line
/// or circle with its unit normal out of the solid. A point's foot lies on the piece when the point is past the start and not
/// past the end, as measured along the directions of travel there; a full circle has directions of length 0 and no start.
/// `corner` is a direction out of the solid at a, halfway between the normals of the two pieces that meet there.
struct PackedPiece {
    double ax, ay, start_x, start_y;
    double bx, by, end_x, end_y;
    double apex_x, apex_y, normal_x, normal_y, curvature;
    double corner_x, corner_y;
};
inline constexpr int packed_piece_size = 15;
/// Before the pieces: their number, the largest absolute coordinate, metres, and where in the block the boxes are, or 0.
inline constexpr int packed_head_size = 3;
/// A box (least x and y, greatest x and y) for every so many pieces in turn, so that a search through thousands need not look at each.
inline constexpr int pieces_in_a_box = 16, packed_box_size = 4;

/// A distance and the direction of its gradient.
template <class Real>
struct CurveDistance {
    Real distance, normal_x, normal_y;
};

/// Signed distance to the whole line or circle a piece is part of. With u from the apex and normal n it is the root nearer to 0 of
/// |u - d n - ...| = 0 written as (k u.u + 2 n.u) / (1 + |k u + n|): one formula for lines (k = 0) and for arcs of any radius, which
/// subtracts no two large numbers where the arc is flat.
template <class Real>
CurveDistance<Real> distance_to_curve(const Point<Real>& p, const PackedPiece& c) {
    const Real k(c.curvature), nx(c.normal_x), ny(c.normal_y);
    const Point<Real> u{p.x - Real(c.apex_x), p.y - Real(c.apex_y)};
    const Real x = k * u.x + nx, y = k * u.y + ny, length = sqrt(x * x + y * y);
    const auto at_centre = length <= Real(0);
    const Real scale = Real(1) / select(at_centre, Real(1), length);
    return {(k * (u.x * u.x + u.y * u.y) + Real(2) * (nx * u.x + ny * u.y)) / (Real(1) + length),
            select(at_centre, nx, x * scale), select(at_centre, ny, y * scale)};
}

/// Signed distance to the point a piece starts from; the corner's direction gives the sign.
template <class Real>
CurveDistance<Real> distance_to_start(const Point<Real>& p, const PackedPiece& c) {
    const Real x = p.x - Real(c.ax), y = p.y - Real(c.ay), length = sqrt(x * x + y * y);
    const Real side = sign(x * Real(c.corner_x) + y * Real(c.corner_y));
    const auto there = length <= Real(0);
    const Real scale = side / select(there, Real(1), length);
    return {side * length, select(there, Real(c.corner_x), x * scale), select(there, Real(c.corner_y), y * scale)};
}

/// The nearest foot decides both size and sign: where it lies on a piece, the side of that piece; where it is a corner, the corner lies
/// between the point and the solid or the other way round (Baerentzen and Aanaes, "Signed distance computation using the angle
/// weighted pseudonormal", 2005; in the plane halfway between the two normals will do). Where the outline touches itself pieces are
/// equally near and may disagree: what lies about the point is decided by the one that bends towards it most.
template <class R>
struct OutlineSearch {
    Point<R> q;
    R size, epsilon = R(4 * epsilon_of(R(0)));
    CurveDistance<R> best{R(1e30), R(1), R(0)};
    R best_bend = R(0);

    R tie(const R& d) const { return epsilon * max(size, abs(d)); }
    void offer(const double* packed, int i) {
        const double* v = packed + packed_head_size + packed_piece_size * i;
        const PackedPiece c{v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10], v[11], v[12], v[13], v[14]};
        const R past_start = (q.x - R(c.ax)) * R(c.start_x) + (q.y - R(c.ay)) * R(c.start_y);
        const R past_end = (q.x - R(c.bx)) * R(c.end_x) + (q.y - R(c.by)) * R(c.end_y);
        const auto beside = both(past_start >= R(0), past_end <= R(0));
        const CurveDistance<R> curve = distance_to_curve(q, c), start = distance_to_start(q, c);
        const R d = select(beside, curve.distance, start.distance), gain = abs(best.distance) - abs(d);
        const R bend = select(beside, -sign(d) * R(c.curvature), R(-1e30));
        const auto nearer = either(gain > tie(d), both(gain >= -tie(d), bend > best_bend));
        best.distance = select(nearer, d, best.distance);
        best.normal_x = select(nearer, select(beside, curve.normal_x, start.normal_x), best.normal_x);
        best.normal_y = select(nearer, select(beside, curve.normal_y, start.normal_y), best.normal_y);
        best_bend = select(nearer, bend, best_bend);
    }
};

/// The search of a block with boxes: what the pieces of the nearest box leave to be found decides which others are looked at, in their
/// order, so that the answer is that of the search through all.
template <class R>
void search_boxes(OutlineSearch<R>& search, const double* packed) {
    const int count = static_cast<int>(packed[0]), boxes = (count + pieces_in_a_box - 1) / pieces_in_a_box;
    const double* box = packed + static_cast<int>(packed[2]);
    const auto square_to_box = [&](int k) {
        const double* b = box + packed_box_size * k;
        const R x = max(max(b[0] - search.q.x, search.q.x - b[2]), R(0)), y = max(max(b[1] - search.q.y, search.q.y - b[3]), R(0));
        return x * x + y * y;
    };
    const auto for_pieces_of = [&](int k, OutlineSearch<R>& in) {
        for (int i = k * pieces_in_a_box; i < count && i < (k + 1) * pieces_in_a_box; ++i) in.offer(packed, i);
    };
    int nearest = 0;
    R least = square_to_box(0);
    for (int k = 1; k < boxes; ++k)
        if (const R square = square_to_box(k); square < least) least = square, nearest = k;
    OutlineSearch<R> first = search;
    for_pieces_of(nearest, first);
    const R enough = abs(first.best.distance) + R(4) * search.tie(first.best.distance);
    for (int k = 0; k < boxes; ++k)
        if (square_to_box(k) <= enough * enough) for_pieces_of(k, search);
}

/// Signed, of a packed outline. None of the search's choices needs derivatives: about p the distance is that to the foot found, whose
/// gradient is a unit vector.
template <class Real>
Real distance_to_outline(const Point<Real>& p, const double* packed) {
    using Plain = decltype(frozen(Real(0)));
    OutlineSearch<Plain> search{.q = {frozen(p.x), frozen(p.y)}, .size = Plain(packed[1])};
    const auto look = [&] {
        if constexpr (std::is_same_v<Plain, double>)
            if (packed[2] > 0) return search_boxes(search, packed);
        for (int i = 0; i < static_cast<int>(packed[0]); ++i) search.offer(packed, i);
    };
    look();
    return with_gradient(search.best.distance, search.best.normal_x, search.best.normal_y, p);
}

}  // namespace pinfield::sdf

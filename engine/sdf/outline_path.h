// For shapes that are written as their outline: the pen that draws it, and the packing for outline_distance.h.
#pragma once
#include <vector>

#include "engine/sdf/outline.h"
#include "engine/sdf/outline_distance.h"

namespace pinfield::sdf {

/// Draws one closed loop, the solid on its left: counter-clockwise around solid, clockwise around a hole. Pieces of no length
/// are left out, so that a shape may draw a rounding of radius 0.
class OutlinePen {
public:
    OutlinePen(Outline& out, const Vec2& start) : out_(out), start_(start), at_(start) {}

    void line_to(const Vec2& p) {
        if (p != at_) out_.push_back(Piece::segment(at_, p));
        at_ = p;
    }
    /// Along the circle about `centre` through the present place, counter-clockwise when turn > 0; `reflex`: by more than half a turn.
    void arc_to(const Vec2& p, const Vec2& centre, int turn, bool reflex = false) {
        if (p != at_) out_.push_back(Piece::arc(centre, length(at_ - centre), at_, p, turn, reflex));
        at_ = p;
    }
    /// Round the circle about `centre` through the present place, and back to it.
    void full_circle(const Vec2& centre, int turn) { out_.push_back(Piece::arc(centre, length(at_ - centre), at_, at_, turn, true)); }
    /// Back to the start by a straight line.
    void close() { line_to(start_); }

private:
    Outline& out_;
    Vec2 start_, at_;
};

/// Box around all pieces.
Box2 bounds_of(const Outline& outline);

/// Reals that an outline of `pieces` pieces may take: an arc of more than half a turn is packed as two.
constexpr int packed_outline_size(int pieces) { return packed_head_size + 2 * packed_piece_size * pieces; }
/// Writes the head and then every piece (PackedPiece, in order) to `out`, which holds packed_outline_size(most_pieces) reals.
void pack_outline(const Outline& outline, int most_pieces, double* out);
/// The pieces of a packed outline, in order, in its frame.
Outline unpacked_outline(const double* packed);
/// The block of an outline of any length, for found_outline.h: with boxes where it is long.
std::vector<double> found_outline_block(const Outline& outline);

}  // namespace pinfield::sdf

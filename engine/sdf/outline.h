// The boundary of a line-and-arc solid as oriented pieces: for exact distances, times of impact and tests.
#pragma once
#include <vector>

#include "engine/core/geometry.h"

namespace pinfield::sdf {

/// A straight or circular piece of an outline, from a to b with the solid on its left.
/// A segment has turn == 0. An arc runs about `centre` with `radius`, counter-clockwise when turn > 0 (the solid is on the
/// centre's side) and clockwise when turn < 0; a == b means the full circle.
struct Piece {
    Vec2 a, b;
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

using Outline = std::vector<Piece>;

}  // namespace pinfield::sdf

// One piece of a path: a line, an arc or a Bezier curve, seen in the path's list of points.
#pragma once
#include <array>
#include <string_view>

#include "engine/sdf/arc_through.h"

namespace pinfield::sdf {

enum class PathPiece : unsigned char { line, arc, quadratic, cubic };
constexpr std::array<std::string_view, 4> choice_names(PathPiece) { return {"line", "arc", "quadratic", "cubic"}; }

/// Points that a piece takes beyond the one it starts from; the last of them is its end.
constexpr int points_of(PathPiece piece) {
    switch (piece) {
        case PathPiece::line: return 1;
        case PathPiece::arc:
        case PathPiece::quadratic: return 2;
        case PathPiece::cubic: return 3;
    }
    return 1;
}

/// The points of one piece, its start before them.
struct PieceView {
    const double* xy;
    PathPiece kind;

    bool is_arc() const { return kind == PathPiece::arc; }
    Point<double> operator[](int i) const { return {xy[2 * i], xy[2 * i + 1]}; }
    Point<double> end() const { return (*this)[points_of(kind)]; }
    BezierView bezier() const { return {xy, points_of(kind)}; }
};

template <class R>
ArcThrough arc_of(const PieceView& piece) {
    return arc_through<R>(piece[0], piece[1], piece[2]);
}

template <class R>
Point<R> nearest_on_piece(const Point<R>& p, const PieceView& piece) {
    return piece.is_arc() ? nearest_on_arc(p, arc_of<R>(piece)) : nearest_on_bezier(p, piece.bezier());
}

/// Whether the ray from p along +x crosses the piece an odd number of times.
template <class R>
auto crosses_oddly(const Point<R>& p, const PieceView& piece) {
    return piece.is_arc() ? crosses_oddly(p, arc_of<R>(piece)) : crosses_oddly(p, piece.bezier());
}

/// At t from 0 to 1.
template <class R>
Passage passage_of(const PieceView& piece, double t) {
    if (piece.is_arc()) return passage_of<R>(arc_of<R>(piece), t);
    const PowerForm c = piece.bezier().power_form();
    return {c.at(t), c.velocity(t)};
}

}  // namespace pinfield::sdf

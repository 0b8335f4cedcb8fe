// Points along outlines that are no lines and arcs, for a shape's trace(): dense enough near corners and joints that the curve through
// neighbouring points follows the outline there, too.
#pragma once
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/trig.h"

namespace pinfield::sdf {

/// From 0 at i = 0 to 1 at i = n, in steps that shrink to 35 / n^4 at both ends.
inline double graded(int i, int n) {
    const double u = static_cast<double>(i) / n;
    return u * u * u * u * (35 - u * (84 - u * (70 - 20 * u)));
}

/// The points at(0), at(1) and n - 1 between them, without the last one: it begins the next piece.
template <class At>
void trace_piece(int n, const At& at, std::vector<Vec2>& out) {
    for (int i = 0; i < n; ++i) out.push_back(at(graded(i, n)));
}

/// A point of a wall's middle line and the unit vector along it.
struct CurvePoint {
    Vec2 at, along;
};

/// Outline of a wall with round ends about the middle line curve(0) ... curve(1), each a CurvePoint; its solid on the left. `points` are
/// those of one end; a side takes twice as many.
template <class Curve>
void trace_stroke(const Curve& curve, double half_thickness, int points, std::vector<Vec2>& out) {
    const auto beside = [&](double t, double side) {
        const CurvePoint c = curve(t);
        return Vec2(c.at + side * half_thickness * perpendicular(c.along));
    };
    const auto round_end = [&](double t, double forth) {
        const CurvePoint c = curve(t);
        const Vec2 along = forth * c.along;
        return [=](double u) {
            const SineCosine turn = sine_cosine(pi * u);
            return Vec2(c.at + half_thickness * (turn.sine * along - turn.cosine * perpendicular(along)));
        };
    };
    const int along_side = 2 * points, along_end = points;
    trace_piece(along_side, [&](double t) { return beside(t, -1); }, out);
    trace_piece(along_end, round_end(1, 1), out);
    trace_piece(along_side, [&](double t) { return beside(1 - t, 1); }, out);
    trace_piece(along_end, round_end(0, -1), out);
}

}  // namespace pinfield::sdf

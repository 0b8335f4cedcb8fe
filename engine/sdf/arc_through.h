// The circular arc through three points: its nearest points, crossings, places and directions, for arcs of any radius.
#pragma once
#include "engine/core/trig.h"
#include "engine/sdf/bezier_chain.h"
#include "engine/sdf/outline_distance.h"

namespace pinfield::sdf {

/// From a through `middle` to b. A straight line where the middle lies on it or on an end; where a is b, the full circle about the point
/// halfway to the middle, counter-clockwise.
struct ArcThrough {
    Point<double> a, middle, b;
    bool straight;       ///< then the rest is void
    bool closes;         ///< the full circle
    bool reflex;         ///< more than half a turn
    PackedPiece circle;  ///< positive distances to the right of the way from a to b
};

/// By inversion about one of them, three points of a circle lie on a line along the circle's tangent in that one: from u = middle - a,
/// v = b - middle and w = b - a it is u / u.u - w / w.w in a, v / v.v + u / u.u in the middle and v / v.v - w / w.w in b. The
/// curvature is twice the sine of the angle between two sides over the third.
template <class R>
ArcThrough arc_through(const Point<double>& a, const Point<double>& middle, const Point<double>& b) {
    const Point<double> u = middle - a, v = b - middle, w = b - a;
    const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
    constexpr double nothing = 1e-60;  // square metres, whose cubes are still numbers
    const bool closes = ww < nothing, about_a = !closes && ww < min(uu, vv);  // the shortest side has the surest direction
    const double turn = about_a ? cross(u, w) : cross(u, v), sides = sqrt(uu) * sqrt(vv) * sqrt(ww);
    ArcThrough out{a, middle, b, uu < nothing || vv < nothing || (turn == 0 && !closes), closes, dot(u, v) < 0, {}};
    if (out.straight) return out;
    const Point<double> at_a = u * ww - w * uu, at_b = v * ww - w * vv, at_middle = u * vv + v * uu;
    const Point<double> apex = about_a ? a : middle, along = about_a ? at_a : at_middle;
    const double speed = sqrt(dot(along, along));
    const Point<double> normal = closes ? u * (1 / sqrt(uu)) : Point<double>{along.y / speed, -along.x / speed};
    out.circle = {a.x,    a.y,    at_a.x,   at_a.y,   b.x,                                    b.y, at_b.x, at_b.y,
                  apex.x, apex.y, normal.x, normal.y, closes ? 2 / sqrt(uu) : 2 * turn / sides, 0,   0};
    return out;
}

template <class R>
Point<R> nearest_on_arc(const Point<R>& p, const ArcThrough& arc) {
    if (arc.straight) return nearest_on_line(p, arc.a, arc.b);
    const PackedPiece& c = arc.circle;
    const auto after_start = (p.x - R(c.ax)) * R(c.start_x) + (p.y - R(c.ay)) * R(c.start_y) >= R(0);
    const auto before_end = (p.x - R(c.bx)) * R(c.end_x) + (p.y - R(c.by)) * R(c.end_y) <= R(0);
    const CurveDistance<R> found = distance_to_curve(p, c);
    const Point<R> foot{p.x - found.distance * found.normal_x, p.y - found.distance * found.normal_y};
    const Point<R> a{R(c.ax), R(c.ay)}, b{R(c.bx), R(c.by)}, from_a = p - a, from_b = p - b;
    const Point<R> end = select(dot(from_b, from_b) < dot(from_a, from_a), b, a);
    return select(arc.reflex ? either(after_start, before_end) : both(after_start, before_end), foot, end);
}

/// Whether the ray from p along +x crosses the arc an odd number of times: as the chord does, unless p lies between the chord and the arc.
/// On which side of the chord p lies is found once for both questions, and level with a horizontal chord p counts as above it, as it
/// does for the ends.
template <class R>
auto crosses_oddly(const Point<R>& p, const ArcThrough& arc) {
    if (arc.straight) {
        const double ends[] = {arc.a.x, arc.a.y, arc.b.x, arc.b.y};
        return crosses_oddly(p, BezierView{ends, 1});
    }
    const auto beyond_arc = distance_to_curve(p, arc.circle).distance > R(0);
    const Point<double> chord = arc.b - arc.a;
    const bool turns_left = arc.circle.curvature > 0;
    if (arc.closes) return invert(beyond_arc);
    const R area = R(chord.x) * (p.y - R(arc.a.y)) - R(chord.y) * (p.x - R(arc.a.x));
    const auto left = chord.x > 0 ? area >= R(0) : area > R(0);
    const auto straddles = exactly_one(R(arc.a.y) <= p.y, R(arc.b.y) <= p.y);
    const auto between = turns_left ? both(invert(left), invert(beyond_arc)) : both(left, beyond_arc);
    return exactly_one(both(straddles, chord.y > 0 ? left : invert(left)), between);
}

/// A point of a curve, and the velocity there where the curve is gone through in a unit of time.
struct Passage {
    Point<double> at, velocity;
};

/// At t from 0 to 1, at constant speed: a chord is the arc's length times sin(x) / x, x half its angle, and lies between the tangents.
template <class R>
Passage passage_of(const ArcThrough& arc, double t) {
    if (arc.straight) return {arc.a + (arc.b - arc.a) * t, arc.b - arc.a};
    const auto sine_over = [](double x) { return abs(x) < 1e-9 ? 1.0 : sine(x) / x; };
    const PackedPiece& c = arc.circle;
    const Point<double> chord = arc.b - arc.a, start{c.start_x, c.start_y};
    const double half = arc.closes ? pi : arc_tangent(cross(start, chord), dot(start, chord));
    const double way = abs(half) < 0.1 ? norm(chord) / sine_over(half) : 2 * half / c.curvature;
    const Point<double> tangent = arc.closes ? Point<double>{c.normal_y, -c.normal_x} : start * (1 / norm(start));
    const auto turned = [&](double angle) {
        const SineCosine by = sine_cosine(angle);
        return Point<double>{by.cosine * tangent.x - by.sine * tangent.y, by.sine * tangent.x + by.cosine * tangent.y};
    };
    return {arc.a + turned(half * t) * (way * t * sine_over(half * t)), turned(2 * half * t) * way};
}

}  // namespace pinfield::sdf

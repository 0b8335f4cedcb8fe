// Outlines of straight edges, for the shapes that are little more than their corners.
#pragma once
#include <cmath>
#include <initializer_list>

#include "engine/core/trig.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// The loop through these corners, counter-clockwise around solid. Neighbours that coincide have no edge between them.
inline void outline_through(Outline& out, std::initializer_list<Vec2> corners) {
    OutlinePen pen(out, *corners.begin());
    for (const Vec2& corner : corners) pen.line_to(corner);
    pen.close();
}

/// `value`, or `limit` where they are so close that doubles could not tell the direction of an edge from one to the
/// other.
inline double snapped(double value, double limit, double size) {
    return std::fabs(value - limit) < 1e-9 * size ? limit : value;
}

/// The place this far from the origin, in a direction in degrees counter-clockwise from +x.
inline Vec2 polar(double radius, double direction) {
    const SineCosine t = sine_cosine_degrees(direction);
    return radius * Vec2(t.cosine, t.sine);
}

/// Regular polygon about the origin, standing on a side, its sides `apothem` from the centre.
inline void outline_regular_polygon(Outline& out, int sides, double apothem) {
    const double half = 180.0 / sides, radius = apothem / cosine_degrees(half);
    OutlinePen pen(out, polar(radius, half - 90));
    for (int i = 1; i < sides; ++i) pen.line_to(polar(radius, (2 * i + 1) * half - 90));
    pen.close();
}

/// Star about the origin, its first tip straight up.
inline void outline_star(Outline& out, int tips, double outer, double inner) {
    OutlinePen pen(out, polar(outer, 90));
    for (int i = 1; i < 2 * tips; ++i) pen.line_to(polar(i % 2 == 0 ? outer : inner, 90 + 180.0 * i / tips));
    pen.close();
}

/// Flight of steps that rises to the right from its lower left corner, solid down to the ground: 2 count + 2 pieces.
inline void outline_stairs(Outline& out, const Vec2& foot, const Vec2& step, int count) {
    const auto place = [&](int across, int up) { return Vec2(foot.x() + across * step.x(), foot.y() + up * step.y()); };
    OutlinePen pen(out, foot);
    pen.line_to(place(count, 0));
    pen.line_to(place(count, count));
    for (int i = count - 1; i >= 0; --i) {
        pen.line_to(place(i, i + 1));
        pen.line_to(place(i, i));
    }
}

}  // namespace pinfield::sdf

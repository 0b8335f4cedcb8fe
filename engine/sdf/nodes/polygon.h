#pragma once
#include <tuple>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/edges.h"
#include "engine/sdf/outline.h"
#include "engine/sdf/simple_chain.h"

namespace pinfield::sdf {

/// Region within a closed chain of straight edges, convex or not, in either order.
template <class Real>
struct Polygon {
    static constexpr int max_points = 4096;
    static constexpr double example[] = {-0.04, -0.03, 0.04, -0.03, 0.01, 0, 0.03, 0.04, -0.04, 0.02};

    PointList<Real> points{example, 5};
    double orientation = 1;

    static constexpr auto derived() { return std::tuple(&Polygon::orientation); }
    void derive() { orientation = doubled_area(points.xy, points.count) < 0 ? -1.0 : 1.0; }

    Real distance(const Point<Real>& p) const { return distance_to_chain(p, points.xy, points.count, orientation); }
    template <int K>
    void distances(const Point<Real> (&p)[K], Real (&out)[K]) const {
        distances_to_chain(p, out, points.xy, points.count, orientation);
    }
    Box2 bounds() const {
        Box2 box;
        for (int i = 0; i < points.count; ++i) box = box.including({points[i].x, points[i].y});
        return box;
    }
    void outline(Outline& out) const {
        const int n = points.count;
        for (int i = 0; i < n; ++i) {
            const auto from_point = points[orientation > 0 ? i : n - 1 - i];
            const auto to_point = points[orientation > 0 ? (i + 1) % n : (2 * n - 2 - i) % n];
            const Vec2 a(from_point.x, from_point.y), b(to_point.x, to_point.y);
            if (a != b) out.push_back(Piece::segment(a, b));
        }
    }

    static constexpr auto describe() {
        return shape<Polygon>({.key = "polygon", .doc = "Region within a closed chain of straight edges, convex or not."},
                              fields(field("points", &Polygon::points,
                                           {.unit = Unit::metre,
                                            .step = 0.001,
                                            .required = true,
                                            .meaning = Meaning::place,
                                            .doc = "Corners in order, clockwise or counter-clockwise; the last joins the first."})),
                              contract("at least 3 points", [](const auto& polygon) { return polygon.points.count >= 3; }),
                              contract("at most 4096 points", [](const auto& polygon) { return polygon.points.count <= max_points; }),
                              contract("the points enclose an area",
                                       [](const auto& polygon) {
                                           return polygon.points.count < 3 || doubled_area(polygon.points.xy, polygon.points.count) != 0;
                                       }),
                              contract("no two edges cross or run along each other", [](const auto& polygon) {
                                  return polygon.points.count > max_points || is_simple_chain(polygon.points.xy, polygon.points.count);
                              }));
    }
};

}  // namespace pinfield::sdf

// Distances to straight edges, shared by every shape with corners. Vertices are plain doubles also on SIMD lanes: a direction
// is computed once, exactly as for double, and only the query point is rounded.
#pragma once
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Coordinates of p in the frame whose x axis has the direction (cosine, sine).
template <class Real>
Point<Real> in_frame(const Point<Real>& p, double cosine, double sine) {
    return {p.x * Real(cosine) + p.y * Real(sine), p.y * Real(cosine) - p.x * Real(sine)};
}

/// Unsigned distance to the part |x| <= half of the x axis. Beside it the distance is |y|, which has a unit gradient on
/// the axis itself.
template <class Real>
Real distance_to_span(const Point<Real>& p, const Real& half) {
    const Real beyond = abs(p.x) - half;
    return select(beyond > Real(0), norm(Point<Real>{beyond, p.y}), abs(p.y));
}

/// Unit direction from a to b and its length; a zero vector when a == b.
struct Edge {
    double tx = 0, ty = 0, length = 0;
};
template <class P>
Edge edge_between(const P& a, const P& b) {
    const double x = b.x - a.x, y = b.y - a.y, l = sqrt(x * x + y * y);
    if (!(l > 0)) return {};
    return {x / l, y / l, l};
}

/// Signed distance to the edge from a to b with the solid on its left. Beyond its ends the sign is that of the edge's line.
template <class Real>
Real signed_distance_to_edge(const Point<Real>& p, const Point<double>& a, const Point<double>& b) {
    const Edge e = edge_between(a, b);
    const Point<Real> q = in_frame(Point<Real>{p.x - Real(a.x), p.y - Real(a.y)}, e.tx, e.ty);
    const Real beyond = max(q.x - Real(e.length), -q.x);
    const Real corner = norm(Point<Real>{beyond, q.y});
    return select(beyond > Real(0), select(q.y > Real(0), -corner, corner), -q.y);
}

/// What is known of the signed distance to a closed chain of edges while they are gone through one by one.
template <class Real>
struct ChainDistance {
    Real nearest = Real(1e30), signed_nearest = Real(1e30);
    decltype(Real(0) < Real(0)) inside = Real(0) < Real(0);

    void meet(const Point<Real>& p, const Point<double>& a, const Point<double>& b, const Edge& e, double orientation) {
        const Point<Real> from_a{p.x - Real(a.x), p.y - Real(a.y)};
        const Point<Real> q = in_frame(from_a, e.tx, e.ty);
        const Real outward = q.y * Real(-orientation);
        const auto beside = both(q.x > Real(0), q.x < Real(e.length));
        const Real candidate = select(beside, abs(outward), norm(from_a));
        const auto nearer = candidate < nearest;
        nearest = select(nearer, candidate, nearest);
        signed_nearest = select(nearer, select(beside, outward, candidate), signed_nearest);

        // A point on the edge counts as outside, whichever way the edge runs.
        const auto straddles = exactly_one(Real(a.y) <= p.y, Real(b.y) <= p.y);
        const bool solid_on_the_left = (b.y > a.y) == (orientation > 0);
        const auto on_solid_side = outward < Real(0);
        const auto crosses = both(straddles, solid_on_the_left ? on_solid_side : invert(on_solid_side));
        inside = exactly_one(inside, crosses);
    }
    Real value() const { return select(nearest > Real(0), select(inside, -nearest, nearest), signed_nearest); }
};

/// Signed distances to the region that a closed chain of edges bounds (even-odd rule), exact on both sides as long as the
/// edges meet at vertices only; `orientation` is +1 for counter-clockwise chains, -1 for clockwise ones. `xy` holds x0 y0 x1 y1 ...
/// The nearest edge gives the size: along its line where the foot lies on it, so that points on the outline get the edge's outward
/// normal as gradient, else to its first vertex (the other one belongs to the next edge). The parity of crossings to the
/// right gives the sign. Coincident vertices and edges are harmless: a chain without interior has a distance above zero.
/// Several points at once share the work on each edge.
template <class Real, int K>
void distances_to_chain(const Point<Real> (&p)[K], Real (&distance)[K], const double* xy, int count, double orientation) {
    ChainDistance<Real> found[K];
    for (int i = 0; i < count; ++i) {
        const int j = i + 1 == count ? 0 : i + 1;
        const Point<double> a{xy[2 * i], xy[2 * i + 1]}, b{xy[2 * j], xy[2 * j + 1]};
        const Edge e = edge_between(a, b);
        for (int k = 0; k < K; ++k) found[k].meet(p[k], a, b, e, orientation);
    }
    for (int k = 0; k < K; ++k) distance[k] = found[k].value();
}

template <class Real>
Real distance_to_chain(const Point<Real>& p, const double* xy, int count, double orientation) {
    const Point<Real> points[] = {p};
    Real distance[1];
    distances_to_chain(points, distance, xy, count, orientation);
    return distance[0];
}

/// Twice the signed area of a closed chain: > 0 when counter-clockwise. Relative to its first vertex, against cancellation.
inline double doubled_area(const double* xy, int count) {
    double sum = 0;
    for (int i = 1; i + 1 < count; ++i) {
        const double ax = xy[2 * i] - xy[0], ay = xy[2 * i + 1] - xy[1];
        const double bx = xy[2 * i + 2] - xy[0], by = xy[2 * i + 3] - xy[1];
        sum += ax * by - ay * bx;
    }
    return sum;
}

/// Folds the plane into the sector about +x of a figure with `count`-fold symmetry that is symmetric in the x axis:
/// |angle| <= 180/count degrees, then y >= 0. (cosine, sine) is the turn from one sector to the next.
template <class Real>
Point<Real> folded_into_sector(const Point<Real>& p, int count, double cosine, double sine) {
    const Point<Real> upper{p.x, abs(p.y)};
    Point<Real> best = upper;
    double c = 1, s = 0;
    for (int k = 1; 2 * k <= count; ++k) {
        const double next = c * cosine - s * sine;
        s = s * cosine + c * sine;
        c = next;
        const Point<Real> q = in_frame(upper, c, s);
        best = select(q.x > best.x, q, best);
    }
    return {best.x, abs(best.y)};
}

}  // namespace pinfield::sdf

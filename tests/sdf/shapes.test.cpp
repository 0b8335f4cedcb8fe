#include <catch2/catch.hpp>

#include <cmath>

#include "engine/sdf/nodes/arc.h"
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/capsule.h"
#include "engine/sdf/nodes/circle.h"
#include "engine/sdf/nodes/ellipse.h"
#include "engine/sdf/nodes/half_plane.h"
#include "engine/sdf/nodes/polygon.h"
#include "engine/sdf/nodes/regular_polygon.h"
#include "engine/sdf/nodes/segment.h"
#include "engine/sdf/nodes/star.h"
#include "engine/sdf/nodes/triangle.h"
#include "engine/sdf/nodes/uneven_capsule.h"
#include "tests/sdf/support.h"

namespace pinfield::sdf {
namespace {

template <class A, class B>
double largest_difference(const A& a, const B& b, double half) {
    double worst = 0;
    for (const Vec2& p : points_within(half))
        worst = std::max(worst, std::fabs(a.distance({p.x(), p.y()}) - b.distance({p.x(), p.y()})));
    return worst;
}

/// Least distance to the ellipse by scanning and narrowing its angle: slow, plain, good to 1e-15.
double distance_by_scan(const Vec2& p, double a, double b) {
    const auto distance_at = [&](double t) { return length(Vec2(a * std::cos(t) - p.x(), b * std::sin(t) - p.y())); };
    const int n = 4000;
    double best = 0, step = 6.283185307179586 / n;
    for (int i = 0; i < n; ++i)
        if (distance_at(i * step) < distance_at(best)) best = i * step;
    // At the least distance the derivative of its square changes its sign.
    const auto slope_at = [&](double t) {
        return (a * std::cos(t) - p.x()) * -a * std::sin(t) + (b * std::sin(t) - p.y()) * b * std::cos(t);
    };
    double lo = best - step, hi = best + step;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (lo + hi);
        (slope_at(middle) < 0 ? lo : hi) = middle;
    }
    return std::min(distance_at(best), distance_at(0.5 * (lo + hi)));
}

}  // namespace

TEST_CASE("an uneven capsule of equal radii is a capsule") {
    const auto uneven = ready(UnevenCapsule<double>{.length = 0.06, .radius_a = 0.01, .radius_b = 0.01});
    const Capsule<double> even{0.06, 0.01};
    for (const Vec2& p : points_within(0.2))
        CHECK(uneven.distance({p.x() + 0.03, p.y()}) == Approx(even.distance({p.x(), p.y()})).margin(1e-15));
}

TEST_CASE("an uneven capsule whose one disc holds the other is the larger disc, up to and at the limit") {
    for (const double length : {0.0, 0.005, 0.01}) {
        const auto head = ready(UnevenCapsule<double>{.length = length, .radius_a = 0.02, .radius_b = 0.01});
        const auto tail = ready(UnevenCapsule<double>{.length = length, .radius_a = 0.01, .radius_b = 0.02});
        for (const Vec2& p : points_within(0.1)) {
            CHECK(head.distance({p.x(), p.y()}) == Approx(pinfield::length(p) - 0.02).margin(1e-16));
            CHECK(tail.distance({p.x(), p.y()}) == Approx(pinfield::length(p - Vec2(length, 0)) - 0.02).margin(1e-16));
        }
    }
}

TEST_CASE("an uneven capsule just longer than the limit differs from the larger disc by no more than it sticks out") {
    const auto bat = ready(UnevenCapsule<double>{.length = 0.01 * (1 + 1e-9), .radius_a = 0.02, .radius_b = 0.01});
    const Circle<double> disc{0.02};
    CHECK(largest_difference(bat, disc, 0.1) < 1.1e-11);
}

TEST_CASE("an ellipse of equal axes is a circle") {
    const Ellipse<double> ellipse{{0.04, 0.04}};
    CHECK(largest_difference(ellipse, Circle<double>{0.04}, 0.2) < 1e-15);
}

TEST_CASE("an ellipse is exact on both sides to twelve digits, needles and points on its evolute included") {
    for (const Vec2& radii : {Vec2(0.05, 0.03), Vec2(0.03, 0.05), Vec2(0.1, 0.005), Vec2(0.5, 0.0005), Vec2(0.04, 0.0399999)}) {
        const Ellipse<double> ellipse{{radii.x(), radii.y()}};
        const double a = radii.x(), b = radii.y(), large = std::max(a, b);
        std::vector<Vec2> points = points_within(2 * large);
        for (int i = 0; i <= 40; ++i) {  // centres of curvature, where two feet become one
            const double c = std::cos(i * 0.157), s = std::sin(i * 0.157);
            points.emplace_back((a * a - b * b) / a * c * c * c, (b * b - a * a) / b * s * s * s);
            points.emplace_back(a * c, b * s);
        }
        double worst = 0;
        for (const Vec2& p : points) {
            const double truth = distance_by_scan(p, a, b);
            worst = std::max(worst, std::fabs(std::fabs(ellipse.distance({p.x(), p.y()})) - truth) / std::max(large, length(p)));
        }
        INFO(a << " " << b);
        CHECK(worst < 1e-12);
    }
}

TEST_CASE("a star whose notches lie on the chords of its tips is a regular polygon") {
    const auto star = ready(Star<double>{.points = 6, .outer = 0.04, .inner = 0.04 * std::cos(3.14159265358979323846 / 6)});
    const auto polygon = ready(RegularPolygon<double>{.sides = 6, .radius = 0.04});
    CHECK(largest_difference(star, polygon, 0.2) < 1e-15);
}

TEST_CASE("a star with notches as far out as its tips is a regular polygon of twice as many sides") {
    const auto star = ready(Star<double>{.points = 4, .outer = 0.04, .inner = 0.04});
    const auto polygon = ready(RegularPolygon<double>{.sides = 8, .radius = 0.04});
    CHECK(largest_difference(star, polygon, 0.2) < 1e-15);
}

TEST_CASE("a square is the same as box, polygon and, turned, as regular polygon") {
    const Box<double> box{{0.06, 0.06}, 0.0};
    const double xy[] = {-0.03, -0.03, 0.03, -0.03, 0.03, 0.03, -0.03, 0.03};
    const auto polygon = ready(Polygon<double>{.points = {xy, 4}});
    CHECK(largest_difference(box, polygon, 0.2) < 1e-15);
    const auto diamond = ready(RegularPolygon<double>{.sides = 4, .radius = 0.03 * std::sqrt(2.0)});
    const double c = std::sqrt(0.5);
    for (const Vec2& p : points_within(0.2))
        CHECK(diamond.distance({c * (p.x() - p.y()), c * (p.x() + p.y())}) == Approx(box.distance({p.x(), p.y()})).margin(1e-15));
}

TEST_CASE("a triangle is the same in either order, and as a polygon") {
    const auto one = ready(Triangle<double>{.a = {0, 0}, .b = {0.05, 0.01}, .c = {0.02, 0.06}});
    const auto other = ready(Triangle<double>{.a = {0, 0}, .b = {0.02, 0.06}, .c = {0.05, 0.01}});
    const double xy[] = {0, 0, 0.05, 0.01, 0.02, 0.06};
    CHECK(largest_difference(one, other, 0.2) < 1e-15);
    CHECK(largest_difference(one, ready(Polygon<double>{.points = {xy, 3}}), 0.2) < 1e-15);
}

TEST_CASE("a triangle with its corners on a line is that stretch of the line, without interior") {
    const Triangle<double> lines[] = {{.a = {0, 0}, .b = {0.03, 0.01}, .c = {0.06, 0.02}},
                                      {.a = {0, 0}, .b = {0.06, 0.02}, .c = {0.06, 0.02}},
                                      {.a = {0.06, 0.02}, .b = {0, 0}, .c = {0.03, 0.01}}};
    const auto thread = ready(Segment<double>{.a = {0, 0}, .b = {0.06, 0.02}, .thickness = 0});
    for (const Triangle<double>& line : lines) CHECK(largest_difference(ready(line), thread, 0.2) < 1e-15);
    const auto dot = ready(Triangle<double>{.a = {0.01, 0.02}, .b = {0.01, 0.02}, .c = {0.01, 0.02}});
    CHECK(dot.distance({0.04, 0.06}) == Approx(0.05));
}

TEST_CASE("a segment is a capsule laid from a to b") {
    const auto segment = ready(Segment<double>{.a = {0.01, 0.02}, .b = {0.04, 0.06}, .thickness = 0.02});
    const Capsule<double> capsule{0.05, 0.01};
    for (const Vec2& p : points_within(0.2)) {  // 3-4-5
        const Vec2 q = Vec2(0.025, 0.04) + Vec2(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y());
        CHECK(segment.distance({q.x(), q.y()}) == Approx(capsule.distance({p.x(), p.y()})).margin(1e-15));
    }
}

TEST_CASE("a half plane is its local y") {
    for (const Vec2& p : points_within(10)) CHECK(HalfPlane<double>::distance({p.x(), p.y()}) == p.y());
}

TEST_CASE("a full arc is a ring without seam, an arc of no length a disc") {
    const auto ring = ready(Arc<double>{.radius = 0.04, .from = 30, .to = 390, .thickness = 0.01});
    const auto dot = ready(Arc<double>{.radius = 0.04, .from = 90, .to = 90, .thickness = 0.01});
    for (const Vec2& p : points_within(0.1)) {
        CHECK(ring.distance({p.x(), p.y()}) == Approx(std::fabs(length(p) - 0.04) - 0.005).margin(1e-15));
        CHECK(dot.distance({p.x(), p.y()}) == Approx(length(p - Vec2(0, 0.04)) - 0.005).margin(1e-15));
    }
}

TEST_CASE("an arc is the disc of its width run along its middle line, also where it fills its own centre") {
    for (const auto& [from_angle, to_angle, thickness] :
         {std::tuple(10.0, 80.0, 0.02), {-30.0, 200.0, 0.03}, {0.0, 340.0, 0.03}, {45.0, 135.0, 0.12}}) {
        const auto arc = ready(Arc<double>{.radius = 0.04, .from = from_angle, .to = to_angle, .thickness = thickness});
        for (const Vec2& p : points_within(0.15, 100)) {
            double nearest = infinity;
            for (int i = 0; i <= 4000; ++i) {
                const double t = (from_angle + (to_angle - from_angle) * i / 4000) * 3.14159265358979323846 / 180;
                nearest = std::min(nearest, length(Vec2(0.04 * std::cos(t), 0.04 * std::sin(t)) - p));
            }
            CHECK(arc.distance({p.x(), p.y()}) == Approx(nearest - 0.5 * thickness).margin(5e-5));
        }
    }
}

TEST_CASE("an arc is exact inside as long as it neither fills its centre nor overlaps its own ends") {
    const auto inside_of = [](double to_angle, double thickness) {
        return ready(Arc<double>{.radius = 0.04, .from = 0, .to = to_angle, .thickness = thickness}).exactness().inside;
    };
    CHECK(inside_of(120, 0.079) == Side::exact);
    CHECK(inside_of(120, 0.081) == Side::bound);
    CHECK(inside_of(300, 0.0399) == Side::exact);  // the ends are a radius apart
    CHECK(inside_of(300, 0.0401) == Side::bound);
    CHECK(inside_of(360, 0.079) == Side::exact);
}

TEST_CASE("a point on a polygon's edge gets the edge's outward normal, in either order of corners") {
    const double ccw[] = {0, 0, 0.04, 0, 0.04, 0.04, 0.02, 0.01, 0, 0.04};
    const double cw[] = {0, 0.04, 0.02, 0.01, 0.04, 0.04, 0.04, 0, 0, 0};
    for (const double* xy : {ccw, cw}) {
        const double orientation = doubled_area(xy, 5) < 0 ? -1 : 1;
        const auto normal_at = [&](double x, double y) {
            const Dual d = distance_to_chain(Point<Dual>{Dual(x, 1, 0), Dual(y, 0, 1)}, xy, 5, orientation);
            CHECK(std::fabs(d.v) < 1e-15);
            return Vec2(d.dx, d.dy);
        };
        CHECK(normal_at(0.01, 0).isApprox(Vec2(0, -1)));
        CHECK(normal_at(0.04, 0.01).isApprox(Vec2(1, 0)));
        CHECK(normal_at(0, 0.01).isApprox(Vec2(-1, 0)));
        CHECK(length(normal_at(0.02, 0.01)) == Approx(1));  // a notch: any of its normals
    }
}

}  // namespace pinfield::sdf

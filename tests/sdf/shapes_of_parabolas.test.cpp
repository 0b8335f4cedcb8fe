// Solids bounded by parabolas and hyperbolas, against their definitions.
#include <catch2/catch.hpp>

#include <cmath>

#include "engine/sdf/nodes/blobby_cross.h"
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/hyperbola.h"
#include "engine/sdf/nodes/parabola.h"
#include "engine/sdf/nodes/parabola_segment.h"
#include "engine/sdf/nodes/quadratic_bezier.h"
#include "engine/sdf/nodes/quadratic_circle.h"
#include "engine/sdf/own_node.h"
#include "tests/sdf/support.h"

namespace pinfield::sdf {
namespace {

/// The point of the outline nearest to p, by the value and the gradient there.
template <template <class> class N>
Vec2 foot_of(const N<double>& node, const Vec2& p) {
    static const NodeType type = sdf_node_type<N>();
    std::vector<double> block = pack(type, values_of(node), type.kernels->derived_count);
    type.kernels->derive(block.data());
    const Sample s = type.kernels->sample(block.data(), p.x(), p.y());
    CHECK(s.value == node.distance({p.x(), p.y()}));
    return p - s.value * s.gradient;
}

template <class Node>
double value_at(const Node& node, double x, double y) {
    return node.distance({x, y});
}

/// Share of a box that is solid, by a grid.
template <class Node>
double area_of(const Node& node, const Box2& box) {
    const int n = 1000;
    int solid = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Vec2 p = box.lo + Vec2((i + 0.5) / n * box.size().x(), (j + 0.5) / n * box.size().y());
            solid += value_at(node, p.x(), p.y()) < 0;
        }
    return box.size().x() * box.size().y() * solid / (n * n);
}

}  // namespace

TEST_CASE("a parabola's outline is as far from the focus as from the directrix") {
    for (const double focal : {1e-4, 0.003, 0.02, 5.0}) {
        const Parabola<double> hill{focal};
        for (const Vec2& p : points_within(0.2)) {
            const Vec2 foot = foot_of(hill, p);
            CHECK(length(foot - Vec2(0, -focal)) == Approx(std::fabs(focal - foot.y())).margin(1e-14));
            CHECK((value_at(hill, p.x(), p.y()) < 0) == (4 * focal * p.y() < -p.x() * p.x()));
        }
    }
}

TEST_CASE("a parabola is right on its axis, above, below and beyond the centre of curvature") {
    const double f = 0.02;
    const Parabola<double> hill{f};
    CHECK(value_at(hill, 0, 0) == 0);
    for (const double y : {1e-9, 0.001, 0.03, 5.0}) CHECK(value_at(hill, 0, y) == Approx(y));
    for (const double y : {1e-9, 0.001, 0.02, 0.04}) CHECK(value_at(hill, 0, -y) == Approx(-y));
    for (const double y : {0.0400001, 0.05, 0.3, 10.0}) CHECK(value_at(hill, 0, -y) == Approx(-2 * std::sqrt(f * (y - f))));
    // On the normal at slope -1, whose foot is (2 f, -f).
    for (const double d : {-0.02, 0.0, 0.01, 1.0})
        CHECK(value_at(hill, 2 * f + d / std::sqrt(2.0), -f + d / std::sqrt(2.0)) == Approx(d).margin(1e-16));
}

TEST_CASE("a parabola of tiny focal is a ray, of vast focal a half plane") {
    for (const Vec2& p : points_within(0.2)) {
        const double to_ray = p.y() < 0 ? std::fabs(p.x()) : length(p);
        CHECK(value_at(Parabola<double>{1e-12}, p.x(), p.y()) == Approx(to_ray).margin(2e-6));
        CHECK(value_at(Parabola<double>{1e9}, p.x(), p.y()) == Approx(p.y()).margin(1e-10));
    }
}

TEST_CASE("a parabola segment is two thirds of its box, and the parabola above its chord") {
    for (const Vec2& size : {Vec2(0.1, 0.06), Vec2(0.1, 0.3), Vec2(0.2, 0.01)}) {
        const auto arch = ready(ParabolaSegment<double>{.width = size.x(), .height = size.y()});
        CHECK(area_of(arch, arch.bounds()) == Approx(2 * size.x() * size.y() / 3).epsilon(1e-3));
        const Parabola<double> hill{size.x() * size.x() / (16 * size.y())};
        for (const Vec2& p : points_within(0.3)) {
            const double value = value_at(arch, p.x(), p.y()), above = value_at(hill, p.x(), p.y() - size.y());
            CHECK(value >= std::max(above, -p.y()) - 1e-15);
            if (value <= 0) CHECK(value == Approx(std::max(above, -p.y())).margin(1e-15));
        }
    }
}

TEST_CASE("a parabola segment is right at its corners, its chord and its top") {
    const auto arch = ready(ParabolaSegment<double>{.width = 0.1, .height = 0.06});
    CHECK(value_at(arch, 0, 0.07) == Approx(0.01));
    CHECK(value_at(arch, 0, 0.05) == Approx(-0.01));
    CHECK(value_at(arch, 0, -0.02) == Approx(0.02));
    CHECK(value_at(arch, 0.05, -0.02) == Approx(0.02));
    CHECK(value_at(arch, 0.05, 0) == Approx(0).margin(1e-16));
    CHECK(value_at(arch, 0.08, -0.04) == Approx(0.05));
    CHECK(value_at(arch, -0.08, -0.04) == Approx(0.05));
    CHECK(value_at(arch, 0.02, 0.01) == Approx(-0.01));
}

TEST_CASE("a hyperbola's outline has a constant difference of distances from its foci") {
    for (const double angle : {1.0, 30.0, 70.0, 90.0, 150.0, 179.0})
        for (const double vertex : {0.001, 0.02, 0.3}) {
            const auto wedge = ready(Hyperbola<double>{.angle = angle, .vertex = vertex});
            const double focus = vertex / std::cos(angle * 3.14159265358979323846 / 360);
            const Vec2 lower(0, -focus), upper(0, focus);
            for (const Vec2& p : points_within(0.4, 100)) {
                const Vec2 foot = foot_of(wedge, p);
                CHECK(length(foot - upper) - length(foot - lower) == Approx(2 * vertex).margin(2e-14 * std::max(focus, 1.0)));
                const bool solid = length(p - upper) - length(p - lower) > 2 * vertex;
                if (std::fabs(value_at(wedge, p.x(), p.y())) > 1e-9) CHECK((value_at(wedge, p.x(), p.y()) < 0) == solid);
            }
        }
}

TEST_CASE("a hyperbola with its vertex almost in the origin is a wedge") {
    const auto wedge = ready(Hyperbola<double>{.angle = 90, .vertex = 1e-10});
    const double c = std::sqrt(0.5);
    for (const Vec2& p : points_within(0.2)) {
        const double across = c * (std::fabs(p.x()) + p.y()), along = c * (std::fabs(p.x()) - p.y());
        CHECK(value_at(wedge, p.x(), p.y()) == Approx(along > 0 ? across : length(p)).margin(1e-9));
    }
    CHECK(value_at(ready(Hyperbola<double>{}), 0, 0) == Approx(0.02));
    CHECK(value_at(ready(Hyperbola<double>{}), 0, -0.025) == Approx(-0.005));
}

TEST_CASE("a quadratic circle is the outline of four quadratic Bezier curves") {
    const double r = 0.05;
    const QuadraticCircle<double> cushion{r};
    const Point<double> sides[] = {{r, 0}, {0, r}, {-r, 0}, {0, -r}}, corners[] = {{r, r}, {-r, r}, {-r, -r}, {r, -r}};
    for (const Vec2& p : points_within(0.1)) {
        double truth = infinity;
        for (int i = 0; i < 4; ++i)
            truth = std::min(truth, QuadraticBezier<double>{sides[i], corners[i], sides[(i + 1) % 4], 0}.distance({p.x(), p.y()}));
        CHECK(std::fabs(value_at(cushion, p.x(), p.y())) == Approx(truth).margin(1e-14));
        const double u = std::fabs(p.x()), v = std::fabs(p.y());
        CHECK((value_at(cushion, p.x(), p.y()) < 0) == (std::max(u, v) < r && 2 * (u + v) < 3 * r - (u - v) * (u - v) / r));
    }
    CHECK(value_at(cushion, 0, 0) == Approx(-r));
    CHECK(area_of(cushion, cushion.bounds()) == Approx(10 * r * r / 3).epsilon(1e-3));  // a corner loses r^2 / 6
}

TEST_CASE("a blobby cross with straight sides is a square on its corner, with the widest neck a quadratic circle") {
    const double root = std::sqrt(2.0);
    const auto straight = ready(BlobbyCross<double>{.size = 0.1, .neck = 0.1 / root, .round = 0});
    const Box<double> box{{0.1 / root, 0.1 / root}, 0.0};
    const auto rounded = ready(BlobbyCross<double>{.size = 0.12, .neck = 0.1 / root + 0.02, .round = 0.01});
    const auto widest = ready(BlobbyCross<double>{.size = 0.1, .neck = 0.15 / root, .round = 0});
    for (const Vec2& p : points_within(0.2)) {
        const Vec2 turned = Vec2(p.x() - p.y(), p.x() + p.y()) / root;
        CHECK(value_at(straight, p.x(), p.y()) == Approx(value_at(box, turned.x(), turned.y())).margin(1e-14));
        CHECK(value_at(rounded, p.x(), p.y()) == Approx(value_at(box, turned.x(), turned.y()) - 0.01).margin(1e-14));
        CHECK(value_at(widest, p.x(), p.y()) == Approx(value_at(QuadraticCircle<double>{0.05}, p.x(), p.y())).margin(1e-14));
    }
}

TEST_CASE("a blobby cross spans its size and its neck, between them runs a quadratic Bezier curve") {
    const double diagonal = std::sqrt(0.5);
    for (const double neck : {0.046, 0.06, 0.08}) {
        const auto cross = ready(BlobbyCross<double>{.size = 0.1, .neck = neck, .round = 0.006});
        CHECK(value_at(cross, 0.05, 0) == Approx(0).margin(1e-16));
        CHECK(value_at(cross, 0, -0.06) == Approx(0.01));
        CHECK(value_at(cross, 0.5 * neck * diagonal, -0.5 * neck * diagonal) == Approx(0).margin(1e-16));
        // A parabola's control point is as far beyond its top as the top is beyond the chord.
        const double tip = 0.044, control = (2 * (0.5 * neck - 0.006) - tip * diagonal) * diagonal;
        const QuadraticBezier<double> bite{{tip, 0}, {control, control}, {0, tip}, 0};
        for (const Vec2& p : points_within(0.1)) {
            const Point<double> folded{std::fabs(p.x()), std::fabs(p.y())};
            CHECK(std::fabs(value_at(cross, p.x(), p.y()) + 0.006) == Approx(bite.distance(folded)).margin(1e-14));
            CHECK(value_at(cross, p.x(), p.y()) == Approx(value_at(cross, -p.y(), p.x())).margin(1e-16));
        }
    }
}

}  // namespace pinfield::sdf

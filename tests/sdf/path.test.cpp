#include <catch2/catch.hpp>

#include <cmath>

#include "engine/sdf/nodes/cubic_bezier.h"
#include "engine/sdf/nodes/path.h"
#include "engine/sdf/nodes/polygon.h"
#include "engine/sdf/nodes/quadratic_bezier.h"
#include "engine/sdf/nodes/quadratic_circle.h"
#include "engine/sdf/nodes/segment.h"
#include "tests/sdf/support.h"

namespace pinfield::sdf {
namespace {

/// A path over points that outlive it.
Path<double> path_of(const std::vector<double>& xy, PathPiece piece, bool fill, double thickness) {
    return {{xy.data(), static_cast<int>(xy.size() / 2)}, piece, fill, thickness};
}

template <class A, class B>
double largest_difference(const A& a, const B& b, double half) {
    double worst = 0;
    for (const Vec2& p : points_within(half))
        worst = std::max(worst, std::fabs(a.distance({p.x(), p.y()}) - b.distance({p.x(), p.y()})));
    return worst;
}

}  // namespace

TEST_CASE("a filled path of lines is a polygon, in either order, closed by hand or not") {
    const std::vector<double> open{0, 0, 0.04, 0, 0.04, 0.04, 0.02, 0.01, 0, 0.04},
        closed{0, 0, 0.04, 0, 0.04, 0.04, 0.02, 0.01, 0, 0.04, 0, 0};
    const std::vector<double> backwards{0, 0.04, 0.02, 0.01, 0.04, 0.04, 0.04, 0, 0, 0};
    const auto polygon = ready(Polygon<double>{.points = {open.data(), 5}});
    for (const auto* xy : {&open, &closed, &backwards}) {
        const auto path = path_of(*xy, PathPiece::line, true, 0);
        CHECK(largest_difference(path, polygon, 0.1) < 1e-15);
        CHECK(path.exactness() == Exactness{});
    }
}

TEST_CASE("a filled path of four quadratic or cubic pieces is a quadratic circle") {
    const double r = 0.05, k = r * 2 / 3;  // a quadratic curve's middle control point lies 3/2 as far as a cubic curve's two
    const std::vector<double> quadratic{r, 0, r, r, 0, r, -r, r, -r, 0, -r, -r, 0, -r, r, -r, r, 0};
    const std::vector<double> cubic{r, 0, r, k, k, r, 0, r, -k, r, -r, k, -r, 0, -r, -k, -k, -r, 0, -r, k, -r, r, -k, r, 0};
    const QuadraticCircle<double> cushion{r};
    CHECK(largest_difference(path_of(quadratic, PathPiece::quadratic, true, 0), cushion, 0.1) < 1e-14);
    CHECK(largest_difference(path_of(cubic, PathPiece::cubic, true, 0), cushion, 0.1) < 1e-14);
    const auto grown = path_of(quadratic, PathPiece::quadratic, true, 0.02);
    for (const Vec2& p : points_within(0.1))
        CHECK(grown.distance({p.x(), p.y()}) == Approx(cushion.distance({p.x(), p.y()}) - 0.01).margin(1e-14));
    CHECK(grown.exactness() == Exactness{.inside = Side::bound});
}

TEST_CASE("a half of a quadratic circle is closed by a straight edge") {
    const double r = 0.05;
    const std::vector<double> half{r, 0, r, r, 0, r, -r, r, -r, 0};
    const auto dome = path_of(half, PathPiece::quadratic, true, 0);
    CHECK(dome.distance({0, -0.03}) == Approx(0.03));
    CHECK(dome.distance({0.01, 0.01}) == Approx(-0.01));
    CHECK(dome.distance({0.08, -0.04}) == Approx(0.05));
    CHECK(dome.distance({0, 0.06}) == Approx(0.01));
}

TEST_CASE("a wall along a path is the union of the walls along its pieces") {
    CounterRng rng(31);
    for (int trial = 0; trial < 10; ++trial) {
        std::vector<double> xy;
        for (int i = 0; i < 14; ++i) xy.push_back(rng.in(-0.1, 0.1));
        const auto at = [&](int i) { return Point<double>{xy[2 * static_cast<std::size_t>(i)], xy[2 * static_cast<std::size_t>(i) + 1]}; };
        for (const Vec2& p : points_within(0.2, 50)) {
            const Point<double> q{p.x(), p.y()};
            double lines = infinity, quadratics = infinity, cubics = infinity;
            for (int i = 0; i < 6; i += 1) lines = std::min(lines, ready(Segment<double>{at(i), at(i + 1), 0.01}).distance(q));
            for (int i = 0; i < 6; i += 2)
                quadratics = std::min(quadratics, QuadraticBezier<double>{at(i), at(i + 1), at(i + 2), 0.01}.distance(q));
            for (int i = 0; i < 6; i += 3)
                cubics = std::min(cubics, CubicBezier<double>{at(i), at(i + 1), at(i + 2), at(i + 3), 0.01}.distance(q));
            CHECK(path_of(xy, PathPiece::line, false, 0.01).distance(q) == Approx(lines).margin(1e-15));
            CHECK(path_of(xy, PathPiece::quadratic, false, 0.01).distance(q) == Approx(quadratics).margin(1e-15));
            CHECK(path_of(xy, PathPiece::cubic, false, 0.01).distance(q) == Approx(cubics).margin(1e-15));
        }
    }
}

TEST_CASE("what a path encloses is told by the even-odd rule, also level with corners, joints and turning points") {
    CounterRng rng(32);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<double> xy;
        for (int i = 0; i < 14; ++i) xy.push_back(std::floor(rng.in(-4, 5)) * 0.02);  // on a grid: many equal heights
        for (const PathPiece piece : {PathPiece::line, PathPiece::quadratic, PathPiece::cubic}) {
            const auto path = path_of(xy, piece, true, 0);
            std::vector<Vec2> chain;
            for (int i = 0; i <= 6000; ++i) chain.push_back(path.curve_at(i / 6000.0).at);
            int wrong = 0;
            for (int i = 0; i < 400; ++i) {
                const Vec2 p{rng.in(-0.1, 0.1), i % 2 == 0 ? rng.in(-0.1, 0.1) : std::floor(rng.in(-4, 5)) * 0.02};
                const double value = path.distance({p.x(), p.y()});
                if (std::fabs(value) < 1e-4) continue;
                bool inside = false;  // along a ray upwards, where the path looks along +x
                for (std::size_t k = 0; k < chain.size(); ++k) {
                    const Vec2 &a = chain[k], &b = chain[(k + 1) % chain.size()];
                    if ((a.x() <= p.x()) == (b.x() <= p.x())) continue;
                    inside ^= a.y() + (p.x() - a.x()) / (b.x() - a.x()) * (b.y() - a.y()) > p.y();
                }
                wrong += (value < 0) != inside;
            }
            INFO(choice_names(piece)[static_cast<std::size_t>(piece)]);
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("a path claims no more than it keeps") {
    const std::vector<double> there_and_back{-0.05, 0, 0.05, 0, 0.05, 0.05, 0.05, 0, -0.05, 0};
    CHECK(path_of(there_and_back, PathPiece::line, true, 0).exactness() == Exactness{.outside = Side::bound, .inside = Side::bound});
    const std::vector<double> kinked{-0.05, 0, 0, 0, 0.05, 0.001}, straight{-0.05, 0, 0, 0, 0.05, 0};
    CHECK(path_of(kinked, PathPiece::line, false, 0.01).exactness() == Exactness{.inside = Side::bound});
    CHECK(path_of(straight, PathPiece::line, false, 0.01).exactness() == Exactness{});
}

}  // namespace pinfield::sdf

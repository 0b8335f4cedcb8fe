#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <string>

#include "engine/core/at.h"
#include "engine/sdf/nodes/arc.h"
#include "engine/sdf/nodes/capsule.h"
#include "engine/sdf/nodes/cubic_bezier.h"
#include "engine/sdf/nodes/path.h"
#include "engine/sdf/nodes/polygon.h"
#include "engine/sdf/nodes/quadratic_bezier.h"
#include "engine/sdf/nodes/quadratic_circle.h"
#include "engine/sdf/nodes/segment.h"
#include "engine/sdf/outline_path.h"
#include "tests/sdf/support.h"

namespace pinfield::sdf {
namespace {

using Pieces = std::vector<double>;
const Pieces lines{0}, arcs{1}, quadratics{2}, cubics{3}, all_kinds{3, 0, 1, 2};

/// A path over points and pieces that outlive it.
Path<double> path_of(const std::vector<double>& xy, const Pieces& pieces, bool fill, double thickness) {
    return {{xy.data(), static_cast<int>(xy.size() / 2)}, {pieces.data(), static_cast<int>(pieces.size())}, fill, thickness};
}

std::string names_of(const Pieces& pieces) {
    std::string out;
    for (const double piece : pieces) out += std::string(at(choice_names(PathPiece{}), piece)) + ' ';
    return out;
}

/// Numbers of points in turn on a grid or not; as many as fill whole pieces, at least `count`.
std::vector<double> some_points(const Pieces& pieces, int count, const std::function<double()>& coordinate) {
    std::vector<double> xy{coordinate(), coordinate()};
    for (std::size_t i = 0; static_cast<int>(xy.size()) < 2 * count; i = (i + 1) % pieces.size())
        for (int k = 0; k < 2 * points_of(static_cast<PathPiece>(pieces[i])); ++k) xy.push_back(coordinate());
    return xy;
}

bool is_accepted(const Path<double>& path) {
    return std::apply([&](const auto&... contract) { return (contract.holds(path) && ...); }, Path<double>::describe().contracts);
}

std::vector<Vec2> points_along(const Path<double>& path, int count) {
    const std::vector<PieceView> pieces = path.views();
    std::vector<Vec2> out;
    for (int i = 0; i <= count; ++i) out.push_back(Path<double>::curve_at(pieces, static_cast<double>(i) / count).at);
    return out;
}

/// The signed distance to the path's own outline of lines and arcs.
double distance_to_boundary(const Path<double>& path, const Vec2& p) {
    Outline outline;
    path.outline(outline);
    std::vector<double> packed(static_cast<std::size_t>(packed_outline_size(static_cast<int>(outline.size()))));
    pack_outline(outline, static_cast<int>(outline.size()), packed.data());
    return distance_to_outline(Point<double>{p.x(), p.y()}, packed.data());
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
        const auto path = path_of(*xy, lines, true, 0);
        CHECK(largest_difference(path, polygon, 0.1) < 1e-15);
        CHECK(path.exactness() == Exactness{});
    }
}

TEST_CASE("a filled path of four quadratic or cubic pieces is a quadratic circle") {
    const double r = 0.05, k = r * 2 / 3;  // a quadratic curve's middle control point lies 3/2 as far as a cubic curve's two
    const std::vector<double> quadratic{r, 0, r, r, 0, r, -r, r, -r, 0, -r, -r, 0, -r, r, -r, r, 0};
    const std::vector<double> cubic{r, 0, r, k, k, r, 0, r, -k, r, -r, k, -r, 0, -r, -k, -k, -r, 0, -r, k, -r, r, -k, r, 0};
    const QuadraticCircle<double> cushion{r};
    CHECK(largest_difference(path_of(quadratic, quadratics, true, 0), cushion, 0.1) < 1e-14);
    CHECK(largest_difference(path_of(cubic, cubics, true, 0), cushion, 0.1) < 1e-14);
    const auto grown = path_of(quadratic, quadratics, true, 0.02);
    for (const Vec2& p : points_within(0.1))
        CHECK(grown.distance({p.x(), p.y()}) == Approx(cushion.distance({p.x(), p.y()}) - 0.01).margin(1e-14));
    CHECK(grown.exactness() == Exactness{.inside = Side::bound});
}

TEST_CASE("a half of a quadratic circle is closed by a straight edge") {
    const double r = 0.05;
    const std::vector<double> half{r, 0, r, r, 0, r, -r, r, -r, 0};
    const auto dome = path_of(half, quadratics, true, 0);
    CHECK(dome.distance({0, -0.03}) == Approx(0.03));
    CHECK(dome.distance({0.01, 0.01}) == Approx(-0.01));
    CHECK(dome.distance({0.08, -0.04}) == Approx(0.05));
    CHECK(dome.distance({0, 0.06}) == Approx(0.01));
}

TEST_CASE("a wall along a path is the union of the walls along its pieces") {
    CounterRng rng(31);
    for (int trial = 0; trial < 10; ++trial) {
        const std::vector<double> xy = some_points(all_kinds, 9, [&] { return rng.in(-0.1, 0.1); });
        REQUIRE(xy.size() == 18);
        const auto at = [&](std::size_t i) { return Point<double>{xy[2 * i], xy[2 * i + 1]}; };
        const std::vector<double> of_arc(xy.begin() + 8, xy.begin() + 14);
        for (const Vec2& p : points_within(0.2, 50)) {
            const Point<double> q{p.x(), p.y()};
            const double wall = std::min(
                {CubicBezier<double>{at(0), at(1), at(2), at(3), 0.01}.distance(q), ready(Segment<double>{at(3), at(4), 0.01}).distance(q),
                 path_of(of_arc, arcs, false, 0.01).distance(q), QuadraticBezier<double>{at(6), at(7), at(8), 0.01}.distance(q)});
            CHECK(path_of(xy, all_kinds, false, 0.01).distance(q) == Approx(wall).margin(1e-15));
        }
    }
}

TEST_CASE("an arc of a path is the arc through its three points") {
    CounterRng rng(33);
    for (int trial = 0; trial < 40; ++trial) {
        const double radius = rng.in(0.01, 0.06), from = rng.in(-180, 180), sweep = rng.in(5, 340);
        const auto arc = ready(Arc<double>{radius, from, from + sweep, 0.004});
        const auto on_it = [&](double share) { return arc.point_at(from + share * sweep, radius); };
        const Vec2 a = on_it(0), middle = on_it(rng.in(0.05, 0.95)), b = on_it(1);
        const std::vector<double> forth{a.x(), a.y(), middle.x(), middle.y(), b.x(), b.y()},
            back{b.x(), b.y(), middle.x(), middle.y(), a.x(), a.y()};
        for (const auto* xy : {&forth, &back}) {
            const auto path = path_of(*xy, arcs, false, 0.004);
            CHECK(is_accepted(path));
            CHECK(largest_difference(path, arc, 0.1) < 1e-14);
            CHECK((path.bounds().lo - arc.bounds().lo).norm() < 1e-15);
            CHECK((path.bounds().hi - arc.bounds().hi).norm() < 1e-15);
            for (const Vec2& p : points_along(path, 100)) CHECK(std::fabs(path.distance({p.x(), p.y()}) + 0.002) < 1e-15);
            CHECK((points_along(path, 2)[1] - on_it(0.5)).norm() < 1e-15);
        }
    }
}

TEST_CASE("an arc of a path passes through its three points, however little of the circle it leaves open or takes") {
    CounterRng rng(35);
    for (int trial = 0; trial < 200; ++trial) {
        const double radius = rng.in(0.01, 0.06), open = std::pow(10.0, rng.in(-12, -1)), start = rng.in(-3, 3),
                     middle = start + rng.in(2, 4);
        const auto on_circle = [&](double angle) { return Vec2(radius * std::cos(angle), radius * std::sin(angle)); };
        for (const auto& [a, m, b] : {std::tuple(on_circle(start), on_circle(middle), on_circle(start - open)),
                                      std::tuple(on_circle(start), on_circle(start + 0.4 * open), on_circle(start + open))}) {
            const std::vector<double> xy{a.x(), a.y(), m.x(), m.y(), b.x(), b.y()};
            const auto path = path_of(xy, arcs, false, 0);
            for (const Vec2& p : {a, m, b}) CHECK(path.distance({p.x(), p.y()}) < 1e-16);
            CHECK((points_along(path, 1)[0] - a).norm() < 1e-16);
            CHECK((points_along(path, 1)[1] - b).norm() < 1e-15);
        }
    }
}

TEST_CASE("an arc that ends where it starts is a full circle, and one through a straight line is that line") {
    const std::vector<double> round{0.03, 0.01, -0.05, 0.01, 0.03, 0.01};
    const auto disc = path_of(round, arcs, true, 0), ring = path_of(round, arcs, false, 0.006);
    for (const Vec2& p : points_within(0.1)) {
        const double to_circle = std::hypot(p.x() + 0.01, p.y() - 0.01) - 0.04;
        CHECK(std::fabs(disc.distance({p.x(), p.y()}) - to_circle) < 1e-15);
        CHECK(std::fabs(ring.distance({p.x(), p.y()}) - (std::fabs(to_circle) - 0.003)) < 1e-15);
        CHECK(std::fabs(distance_to_boundary(disc, p) - to_circle) < 1e-15);
        CHECK(std::fabs(distance_to_boundary(ring, p) - (std::fabs(to_circle) - 0.003)) < 1e-15);
    }
    CHECK(ring.exactness() == Exactness{});
    for (const double sagitta : {0.0, 1e-18, 1e-15, 1e-12}) {
        const std::vector<double> flat{-0.04, 0, 0.01, sagitta, 0.05, 0}, ends{-0.04, 0, 0.05, 0};
        CHECK(largest_difference(path_of(flat, arcs, false, 0.01), path_of(ends, lines, false, 0.01), 0.1) <= 2 * sagitta + 1e-16);
    }
    for (const std::vector<double>& beyond : {std::vector<double>{0, 0, 0.05, 0, 0.03, 0}, {0, 0, 0.05, 1e-6, 0.03, 0}})
        CHECK_FALSE(is_accepted(path_of(beyond, arcs, false, 0.01)));
}

TEST_CASE("paths of lines and arcs are the shapes they draw") {
    const Pieces by_turns{0, 1};
    const std::vector<double> stadium{-0.03, -0.02, 0.03, -0.02, 0.05, 0, 0.03, 0.02, -0.03, 0.02, -0.05, 0, -0.03, -0.02};
    const std::vector<double> other_way{-0.03, -0.02, -0.05, 0, -0.03, 0.02, 0.03, 0.02, 0.05, 0, 0.03, -0.02, -0.03, -0.02};
    const Pieces arc_first{1, 0};
    const auto capsule = ready(Capsule<double>{.length = 0.06, .radius = 0.02});
    for (const auto& path : {path_of(stadium, by_turns, true, 0), path_of(other_way, arc_first, true, 0)}) {
        CHECK(largest_difference(path, capsule, 0.1) < 1e-15);
        CHECK(path.exactness() == Exactness{});
    }
    // A rail out, round and back: smooth all along.
    const std::vector<double> hairpin{-0.05, -0.02, 0.03, -0.02, 0.05, 0, 0.03, 0.02, -0.05, 0.02};
    const Pieces rail{0, 1, 0};
    CHECK(path_of(hairpin, rail, false, 0.01).exactness() == Exactness{});
    CHECK(path_of(stadium, by_turns, false, 0.01).exactness() == Exactness{});  // and one that closes
    for (const auto& path : {path_of(stadium, by_turns, true, 0), path_of(other_way, arc_first, true, 0),
                             path_of(hairpin, rail, false, 0.01), path_of(stadium, by_turns, false, 0.01)})
        for (const Vec2& p : points_within(0.1)) CHECK(std::fabs(distance_to_boundary(path, p) - path.distance({p.x(), p.y()})) < 1e-15);
}

TEST_CASE("the outline of a filled path of lines and arcs is as far as the path, and none is drawn that meets itself") {
    CounterRng rng(34);
    const Pieces by_turns{0, 1, 1};
    int drawn = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const std::vector<double> xy = some_points(by_turns, 6, [&] { return rng.in(-0.1, 0.1); });
        const auto path = path_of(xy, by_turns, true, 0);
        Outline outline;
        if (is_accepted(path)) path.outline(outline);
        if (outline.empty()) continue;
        ++drawn;
        double worst = 0;
        for (const Vec2& p : points_within(0.2, 30))
            worst = std::max(worst, std::fabs(distance_to_boundary(path, p) - path.distance({p.x(), p.y()})));
        CHECK(worst < 1e-12);
    }
    CHECK(drawn > 30);
    CHECK(drawn < 200);
    const std::vector<double> eight{0, 0, 0.04, 0, 0.04, 0.04, 0, 0, -0.04, 0, -0.04, -0.04}, back{0, 0, 0.04, 0, 0, 0};
    for (const auto* xy : {&eight, &back}) {
        Outline outline;
        path_of(*xy, lines, true, 0).outline(outline);
        CHECK(outline.empty());
    }
}

TEST_CASE("what a path encloses goes by the even-odd rule, also level with corners, joints and turning points") {
    CounterRng rng(32);
    for (int trial = 0; trial < 40; ++trial)
        for (const Pieces* pieces : {&lines, &arcs, &quadratics, &cubics, &all_kinds}) {
            // on a grid: many equal heights
            const std::vector<double> xy = some_points(*pieces, 7, [&] { return std::floor(rng.in(-4, 5)) * 0.02; });
            const auto path = path_of(xy, *pieces, true, 0);
            if (!is_accepted(path)) continue;
            const std::vector<Vec2> chain = points_along(path, 6000);
            int wrong = 0;
            for (int i = 0; i < 400; ++i) {
                const Vec2 p{rng.in(-0.15, 0.15), i % 2 == 0 ? rng.in(-0.1, 0.1) : std::floor(rng.in(-4, 5)) * 0.02};
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
            INFO(names_of(*pieces));
            CHECK(wrong == 0);
        }
}

TEST_CASE("a path claims no more than it keeps") {
    const std::vector<double> there_and_back{-0.05, 0, 0.05, 0, 0.05, 0.05, 0.05, 0, -0.05, 0};
    CHECK(path_of(there_and_back, lines, true, 0).exactness() == Exactness{.outside = Side::bound, .inside = Side::bound});
    const std::vector<double> kinked{-0.05, 0, 0, 0, 0.05, 0.001}, straight{-0.05, 0, 0, 0, 0.05, 0};
    CHECK(path_of(kinked, lines, false, 0.01).exactness() == Exactness{.inside = Side::bound});
    CHECK(path_of(straight, lines, false, 0.01).exactness() == Exactness{});
}

}  // namespace pinfield::sdf

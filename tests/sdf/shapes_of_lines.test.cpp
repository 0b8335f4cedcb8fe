// Shapes of straight edges against what they are by definition: half planes, unions, other nodes, areas in closed form.
#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

#include "engine/sdf/nodes/arrow.h"
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/chamfer_box.h"
#include "engine/sdf/nodes/cross.h"
#include "engine/sdf/nodes/equilateral_triangle.h"
#include "engine/sdf/nodes/hexagon.h"
#include "engine/sdf/nodes/hexagram.h"
#include "engine/sdf/nodes/isosceles_triangle.h"
#include "engine/sdf/nodes/octagon.h"
#include "engine/sdf/nodes/oriented_box.h"
#include "engine/sdf/nodes/parallelogram.h"
#include "engine/sdf/nodes/pentagon.h"
#include "engine/sdf/nodes/pentagram.h"
#include "engine/sdf/nodes/pie.h"
#include "engine/sdf/nodes/polygon.h"
#include "engine/sdf/nodes/regular_polygon.h"
#include "engine/sdf/nodes/rhombus.h"
#include "engine/sdf/nodes/rounded_box.h"
#include "engine/sdf/nodes/square_stairs.h"
#include "engine/sdf/nodes/stairs.h"
#include "engine/sdf/nodes/star.h"
#include "engine/sdf/nodes/trapezoid.h"
#include "engine/sdf/nodes/triangle.h"
#include "tests/sdf/support.h"

namespace pinfield::sdf {
namespace {

constexpr double half_turn = 3.14159265358979323846;

/// The distance that a shape gets from its outline.
class Outlined {
public:
    template <class T>
    explicit Outlined(const T& node) : packed_(packed_outline_size(T::most_pieces)) {
        node.outline(outline);
        pack_outline(outline, T::most_pieces, packed_.data());
    }
    double distance(const Point<double>& p) const { return distance_to_outline(p, packed_.data()); }

    /// Shoelace, and what every arc adds beyond its chord; for arcs of at most half a turn.
    double area() const {
        double sum = 0;
        for (const Piece& piece : outline) {
            sum += 0.5 * pinfield::cross(piece.a, piece.b);
            if (!piece.is_arc()) continue;
            const double angle = 2 * std::asin(0.5 * pinfield::length(piece.b - piece.a) / piece.radius);
            sum += piece.turn * 0.5 * piece.radius * piece.radius * (angle - std::sin(angle));
        }
        return sum;
    }

    Outline outline;

private:
    std::vector<double> packed_;
};

template <class A, class B>
double largest_difference(const A& a, const B& b, double half) {
    double worst = 0;
    for (const Vec2& p : points_within(half)) {
        const double difference = std::fabs(a.distance({p.x(), p.y()}) - b.distance({p.x(), p.y()}));
        if (!(difference <= worst)) worst = std::isnan(difference) ? infinity : difference;
    }
    return worst;
}

/// Where `inside` says otherwise than the sign of the distance, points on the outline left aside.
int points_on_the_wrong_side(const Outlined& shape, double half, const std::function<bool(double, double)>& inside) {
    int wrong = 0;
    for (const Vec2& p : points_within(half, 4000)) {
        const double d = shape.distance({p.x(), p.y()});
        wrong += std::fabs(d) > 1e-12 && (d < 0) != inside(p.x(), p.y());
    }
    return wrong;
}

Vec2 turned(const Vec2& p, double degrees) {
    const double c = std::cos(degrees * half_turn / 180), s = std::sin(degrees * half_turn / 180);
    return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

/// Another node, turned about the origin.
template <class T>
struct Turned {
    T node;
    double angle;
    double distance(const Point<double>& p) const {
        const Vec2 q = turned({p.x, p.y}, -angle);
        return node.distance({q.x(), q.y()});
    }
};
template <class T>
Turned(T, double) -> Turned<T>;

/// Distance to half planes that have their boundaries `apothem` from the origin, across these directions.
double largest_over_sides(const Point<double>& p, int sides, double first, double apothem) {
    double largest = -infinity;
    for (int i = 0; i < sides; ++i)
        largest = std::max(largest, pinfield::dot(turned({1, 0}, first + 360.0 * i / sides), Vec2(p.x, p.y)) - apothem);
    return largest;
}

}  // namespace

TEST_CASE("a chamfer box is its box less what lies beyond the four cuts") {
    const Outlined plate(ChamferBox<double>{{0.1, 0.06}, 0.015});
    CHECK(points_on_the_wrong_side(plate, 0.08, [](double x, double y) {
              return std::fabs(x) < 0.05 && std::fabs(y) < 0.03 && std::fabs(x) + std::fabs(y) < 0.065;
          }) == 0);
    CHECK(plate.distance({0.05, 0.03}) == Approx(0.015 / std::sqrt(2.0)));  // the box's corner
    CHECK(plate.distance({0, 0}) == Approx(-0.03));
    CHECK(plate.distance({0.054, 0.018}) == Approx(0.005));  // 3-4-5 from the corner at [0.05, 0.015]
    CHECK(plate.area() == Approx(0.1 * 0.06 - 2 * 0.015 * 0.015));
}

TEST_CASE("a chamfer box without chamfers is a box, a square cut to its middles a square on its corner") {
    const Box<double> box{{0.1, 0.06}, 0};
    CHECK(largest_difference(Outlined(ChamferBox<double>{{0.1, 0.06}, 0}), box, 0.2) < 1e-16);
    const auto diamond = ready(RegularPolygon<double>{.sides = 4, .radius = 0.03});
    CHECK(largest_difference(Outlined(ChamferBox<double>{{0.06, 0.06}, 0.03}), diamond, 0.2) < 1e-15);
}

TEST_CASE("a rounded box of equal radii is a box with that rounding") {
    for (const double r : {0.0, 0.01, 0.03})
        CHECK(largest_difference(Outlined(RoundedBox<double>{{0.1, 0.06}, r, r, r, r}), Box<double>{{0.1, 0.06}, r}, 0.2) < 1e-16);
}

TEST_CASE("every corner of a rounded box is rounded by the radius of its name") {
    const Outlined box(RoundedBox<double>{
        .size = {0.1, 0.06}, .top_right = 0.04, .bottom_right = 0.02, .bottom_left = 0.01, .top_left = 0.05});
    struct Corner {
        double x, y, radius;
    };
    for (const Corner& c : {Corner{1, 1, 0.04}, {1, -1, 0.02}, {-1, -1, 0.01}, {-1, 1, 0.05}}) {
        const Vec2 corner(0.05 * c.x, 0.03 * c.y), inward(-c.x, -c.y), centre = corner + c.radius * inward;
        CHECK(box.distance({corner.x(), corner.y()}) == Approx((std::sqrt(2.0) - 1) * c.radius));
        for (const double angle : {5.0, 30.0, 45.0, 60.0, 85.0})
            for (const double beyond : {-0.002, 0.0, 0.01}) {
                const Vec2 t = turned({1, 0}, angle), p = centre + (c.radius + beyond) * Vec2(c.x * t.x(), c.y * t.y());
                CHECK(box.distance({p.x(), p.y()}) == Approx(beyond).margin(1e-16));
            }
    }
    CHECK(box.area() == Approx(0.1 * 0.06 - (1 - half_turn / 4) * (16 + 4 + 1 + 25) * 1e-4));
}

TEST_CASE("a rounding of a whole side makes a quarter disc") {
    const Outlined quarter(RoundedBox<double>{.size = {0.06, 0.06}, .top_right = 0.06, .bottom_right = 0, .bottom_left = 0, .top_left = 0});
    const auto pie = Outlined(Pie<double>{0.06, 0, 90});
    for (const Vec2& p : points_within(0.1))
        CHECK(quarter.distance({p.x() - 0.03, p.y() - 0.03}) == Approx(pie.distance({p.x(), p.y()})).margin(1e-16));
}

TEST_CASE("roundings that meet on a side leave no trace of the side, whatever their sum is rounded to") {
    CounterRng rng(5);
    for (int i = 0; i < 400; ++i) {
        const double share = rng.in(0.1, 0.9), w = rng.in(0.05, 0.1), h = 1.1 * w, right = share * w, left = w - right;
        if (right + left != w) continue;
        const Outlined arch(RoundedBox<double>{
            .size = {w, h}, .top_right = right, .bottom_right = left, .bottom_left = right, .top_left = left});
        int wrong = 0;
        for (const double x : {0.5 * w - right, right - 0.5 * w})  // where the roundings meet, above and below
            for (const double dx : {-1e-6, -1e-17, 0.0, 1e-17, 1e-9})
                for (const double d : {-1e-3, 1e-3}) {
                    const double y = x == 0.5 * w - right ? 1 : -1;
                    wrong += !(std::fabs(arch.distance({x + dx, y * (0.5 * h + d)}) - d) < 1e-8);
                }
        INFO(w << " " << right << " " << left);
        CHECK(wrong == 0);
    }
}

TEST_CASE("an oriented box is a box laid from a to b, either way round") {
    const Box<double> lying{{0.05, 0.02}, 0};
    const auto there = ready(OrientedBox<double>{.a = {0.01, 0.02}, .b = {0.04, 0.06}, .thickness = 0.02});
    const auto back = ready(OrientedBox<double>{.a = {0.04, 0.06}, .b = {0.01, 0.02}, .thickness = 0.02});
    for (const Vec2& p : points_within(0.2)) {  // 3-4-5
        const Vec2 q = Vec2(0.025, 0.04) + Vec2(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y());
        CHECK(there.distance({q.x(), q.y()}) == Approx(lying.distance({p.x(), p.y()})).margin(1e-15));
        CHECK(back.distance({q.x(), q.y()}) == Approx(lying.distance({p.x(), p.y()})).margin(1e-15));
    }
}

TEST_CASE("a rhombus has its corners at half its size on the axes") {
    const Outlined diamond(Rhombus<double>{{0.06, 0.08}});
    CHECK(points_on_the_wrong_side(diamond, 0.06, [](double x, double y) {
              return std::fabs(x) / 0.03 + std::fabs(y) / 0.04 < 1;
          }) == 0);
    CHECK(diamond.distance({0, 0}) == Approx(-0.024));  // the height of a 3-4-5 triangle over its hypotenuse
    CHECK(diamond.distance({0.015 + 0.008, 0.02 + 0.006}) == Approx(0.01));  // from the middle of a side
    CHECK(diamond.distance({0, -0.05}) == Approx(0.01));
    CHECK(diamond.area() == Approx(0.5 * 0.06 * 0.08));
}

TEST_CASE("a trapezoid's width runs evenly from bottom to top, whichever is the wider") {
    for (const auto& [bottom, top] : {std::pair(0.09, 0.05), {0.02, 0.08}, {0.0, 0.06}, {0.06, 0.0}}) {
        const Outlined trapezoid(Trapezoid<double>{bottom, top, 0.04});
        CHECK(points_on_the_wrong_side(trapezoid, 0.06, [b = bottom, t = top](double x, double y) {
                  return std::fabs(y) < 0.02 && std::fabs(x) < 0.5 * (b + (t - b) * (y + 0.02) / 0.04);
              }) == 0);
        CHECK(trapezoid.area() == Approx(0.5 * (bottom + top) * 0.04));
        CHECK(trapezoid.distance({0.001, -0.03}) == Approx(bottom > 0 ? 0.01 : std::sqrt(1e-4 + 1e-6)));
    }
}

TEST_CASE("a trapezoid of equal widths is a box") {
    CHECK(largest_difference(Outlined(Trapezoid<double>{0.08, 0.08, 0.04}), Box<double>{{0.08, 0.04}, 0}, 0.2) < 1e-16);
}

TEST_CASE("an isosceles triangle is the triangle of its base and apex") {
    const auto triangle = ready(Triangle<double>{.a = {-0.03, -0.045}, .b = {0.03, -0.045}, .c = {0, 0.045}});
    CHECK(largest_difference(Outlined(IsoscelesTriangle<double>{0.06, 0.09}), triangle, 0.2) < 1e-16);
}

TEST_CASE("a parallelogram is a box with every level pushed sideways by its height") {
    for (const double skew : {0.03, -0.05, 0.0}) {
        const Outlined slanted(Parallelogram<double>{0.07, 0.05, skew});
        CHECK(points_on_the_wrong_side(slanted, 0.08, [skew](double x, double y) {
                  return std::fabs(y) < 0.025 && std::fabs(x - skew * y / 0.05) < 0.035;
              }) == 0);
        CHECK(slanted.area() == Approx(0.07 * 0.05));
    }
    CHECK(largest_difference(Outlined(Parallelogram<double>{0.07, 0.05, 0}), Box<double>{{0.07, 0.05}, 0}, 0.2) < 1e-16);
    const Outlined slanted(Parallelogram<double>{0.04, 0.04, 0.03});  // slanted sides of length 0.05
    CHECK(slanted.distance({0.02 + 0.008, -0.006}) == Approx(0.01));
    CHECK(slanted.distance({0, 0}) == Approx(-0.02 * 0.8));
}

TEST_CASE("an equilateral triangle has three sides of its length, the lowest one level") {
    const Outlined triangle(EquilateralTriangle<double>{0.08});
    REQUIRE(triangle.outline.size() == 3);
    for (const Piece& piece : triangle.outline) CHECK(pinfield::length(piece.b - piece.a) == Approx(0.08));
    CHECK(triangle.outline.back().a.y() == triangle.outline.back().b.y());
    CHECK(triangle.distance({0, 0}) == Approx(-0.04 / std::sqrt(3.0)));
    CHECK(triangle.distance({0, -0.04 / std::sqrt(3.0) - 0.01}) == Approx(0.01));
    CHECK(triangle.distance({0, 0.08 / std::sqrt(3.0) + 0.01}) == Approx(0.01));
    CHECK(triangle.area() == Approx(std::sqrt(3.0) / 4 * 0.0064));
}

TEST_CASE("pentagon, hexagon and octagon are where all their sides' half planes meet, and stand on a side") {
    const auto is_right = [](const Outlined& shape, int sides) {
        const double apothem = 0.04, radius = apothem / std::cos(half_turn / sides);
        for (const Vec2& q : points_within(0.06)) {
            const Point<double> p{q.x(), q.y()};
            const double d = shape.distance(p), over_sides = largest_over_sides(p, sides, -90, apothem);
            CHECK((d <= 0 ? d == Approx(over_sides).margin(1e-16) : over_sides > -1e-16 && d >= over_sides - 1e-16));
        }
        CHECK(shape.distance({0, 0}) == Approx(-apothem));
        CHECK(shape.distance({0, -apothem - 0.01}) == Approx(0.01));
        CHECK(shape.area() == Approx(sides * apothem * apothem * std::tan(half_turn / sides)));
        const Turned regular{ready(RegularPolygon<double>{.sides = sides, .radius = radius}), 180.0 / sides - 90};
        CHECK(largest_difference(shape, regular, 0.2) < 1e-15);
    };
    is_right(Outlined(Pentagon<double>{0.04}), 5);
    is_right(Outlined(Hexagon<double>{0.04}), 6);
    is_right(Outlined(Octagon<double>{0.04}), 8);
}

TEST_CASE("an octagon is a square with chamfers as long as what they leave of its sides") {
    const double chamfer = 0.08 * (1 - std::sqrt(0.5));
    CHECK(largest_difference(Outlined(Octagon<double>{0.04}), Outlined(ChamferBox<double>{{0.08, 0.08}, chamfer}), 0.2) < 1e-15);
}

TEST_CASE("a hexagram is two triangles, one upside down") {
    const Outlined star(Hexagram<double>{0.05}), triangle(EquilateralTriangle<double>{0.05 * std::sqrt(3.0)});
    for (const Vec2& p : points_within(0.1)) {
        const double d = star.distance({p.x(), p.y()});
        const double either = std::min(triangle.distance({p.x(), p.y()}), triangle.distance({p.x(), -p.y()}));
        CHECK((either > 0 ? d == Approx(either).margin(1e-16) : d <= either + 1e-16));  // a union is exact outside
    }
    CHECK(star.distance({0, 0.06}) == Approx(0.01));
    CHECK(star.area() == Approx(std::sqrt(3.0) * 0.0025));
    const Turned by_radii{ready(Star<double>{.points = 6, .outer = 0.05, .inner = 0.05 / std::sqrt(3.0)}), 90};
    CHECK(largest_difference(star, by_radii, 0.2) < 1e-15);
}

TEST_CASE("a pentagram is what no more than one of the pentagon's five diagonals cuts off") {
    const Outlined star(Pentagram<double>{0.05});
    CHECK(points_on_the_wrong_side(star, 0.06, [](double x, double y) {
              int cut_off = 0;
              for (int i = 0; i < 5; ++i)
                  cut_off += largest_over_sides({x, y}, 1, 90 + 72.0 * i, 0.05 * std::cos(72 * half_turn / 180)) > 0;
              return cut_off <= 1;
          }) == 0);
    CHECK(star.distance({0, 0.06}) == Approx(0.01));
    const double t = std::tan(half_turn / 10);
    CHECK(star.area() == Approx(10 * t / (3 - t * t) * 0.0025));
    // Every stroke is cut by two others; its outer parts are to its whole as 1 to the square of the golden ratio.
    const double golden = 0.5 * (1 + std::sqrt(5.0)), stroke = 0.1 * std::cos(half_turn / 10);
    for (const Piece& piece : star.outline) CHECK(pinfield::length(piece.b - piece.a) == Approx(stroke / (golden * golden)));
}

TEST_CASE("a cross is two bars across each other, stubby arms and round ends included") {
    struct Size {
        double length, thickness, round;
    };
    for (const Size& s :
         {Size{0.09, 0.03, 0}, {0.08, 0.06, 0}, {0.09, 0.03, 0.01}, {0.09, 0.03, 0.015}, {0.08, 0.06, 0.01}, {0.06, 0.06, 0}}) {
        const Outlined plus(Cross<double>{s.length, s.thickness, s.round});
        const Box<double> level{{s.length, s.thickness}, s.round}, upright{{s.thickness, s.length}, s.round};
        for (const Vec2& p : points_within(0.08)) {
            const double d = plus.distance({p.x(), p.y()});
            const double either = std::min(level.distance({p.x(), p.y()}), upright.distance({p.x(), p.y()}));
            CHECK((either > 0 ? d == Approx(either).margin(1e-16) : d <= either + 1e-16));  // a union is exact outside
        }
        // Inside, the nearest of its outline is an inner corner or the middle of an end.
        CHECK(plus.distance({0, 0}) == Approx(-std::min(s.thickness * std::sqrt(0.5), 0.5 * s.length)));
        CHECK(plus.area() == Approx((2 * s.length - s.thickness) * s.thickness - (8 - 2 * half_turn) * s.round * s.round));
    }
}

TEST_CASE("the inside of a cross is that of a polygon") {
    const double l = 0.04, t = 0.025;
    const double xy[] = {l, -t, l, t, t, t, t, l, -t, l, -t, t, -l, t, -l, -t, -t, -t, -t, -l, t, -l, t, -t};
    CHECK(largest_difference(Outlined(Cross<double>{2 * l, 2 * t, 0}), ready(Polygon<double>{.points = {xy, 12}}), 0.1) < 1e-16);
}

TEST_CASE("stairs are columns from the ground, each a step taller than the one to its left") {
    for (const int count : {1, 2, 5, 32}) {
        const Outlined stairs(Stairs<double>{{0.025, 0.015}, count});
        CHECK(points_on_the_wrong_side(stairs, 0.2, [count](double x, double y) {
                  return x > 0 && x < 0.025 * count && y > 0 && y < 0.015 * std::ceil(x / 0.025);
              }) == 0);
        for (const Vec2& p : points_within(0.2)) {
            double columns = infinity;
            for (int i = 0; i < count; ++i)
                columns = std::min(columns, Box<double>{{0.025, 0.015 * (i + 1)}, 0}.distance(
                                                {p.x() - 0.025 * (i + 0.5), p.y() - 0.0075 * (i + 1)}));
            if (columns > 1e-12) CHECK(stairs.distance({p.x(), p.y()}) == Approx(columns));
        }
        CHECK(stairs.area() == Approx(0.025 * 0.015 * count * (count + 1) / 2));
    }
    const double xy[] = {0, 0, 0.06, 0, 0.06, 0.03, 0.04, 0.03, 0.04, 0.02, 0.02, 0.02, 0.02, 0.01, 0, 0.01};
    CHECK(largest_difference(Outlined(Stairs<double>{{0.02, 0.01}, 3}), ready(Polygon<double>{.points = {xy, 8}}), 0.1) < 1e-16);
}

TEST_CASE("square stairs are stairs about the middle of their square, symmetrical in its other diagonal") {
    const Outlined centred(SquareStairs<double>{0.08, 4}), flight(Stairs<double>{{0.02, 0.02}, 4});
    for (const Vec2& p : points_within(0.1)) {
        CHECK(centred.distance({p.x(), p.y()}) == Approx(flight.distance({p.x() + 0.04, p.y() + 0.04})).margin(1e-16));
        CHECK(centred.distance({p.x(), p.y()}) == Approx(centred.distance({-p.y(), -p.x()})).margin(1e-16));
    }
    CHECK(centred.area() == Approx(0.0064 * 5 / 8));
    CHECK(largest_difference(Outlined(SquareStairs<double>{0.08, 1}), Box<double>{{0.08, 0.08}, 0}, 0.2) < 1e-16);
}

TEST_CASE("an arrow is the polygon of its tail, ledges and tip, whichever way it points") {
    const Arrow<double> level{{-0.02, 0.01}, {0.08, 0.01}, 0.02, 0.04, 0.06};
    const double xy[] = {-0.02, 0, 0.04, 0, 0.04, -0.02, 0.08, 0.01, 0.04, 0.04, 0.04, 0.02, -0.02, 0.02};
    const auto polygon = ready(Polygon<double>{.points = {xy, 7}});
    CHECK(largest_difference(Outlined(level), polygon, 0.2) < 1e-16);
    CHECK(Outlined(level).area() == Approx(0.06 * 0.02 + 0.5 * 0.04 * 0.06));
    CHECK(Outlined(level).distance({0.09, 0.01}) == Approx(0.01));
    CHECK(Outlined(level).distance({-0.03, 0.01}) == Approx(0.01));
    const Vec2 tail = turned({-0.02, 0.01}, 130), tip = turned({0.08, 0.01}, 130);
    const Arrow<double> leaning{{tail.x(), tail.y()}, {tip.x(), tip.y()}, 0.02, 0.04, 0.06};
    CHECK(largest_difference(Outlined(leaning), Turned{polygon, 130}, 0.2) < 1e-15);
}

TEST_CASE("an arrow without a shaft is a triangle, with a head as narrow as its shaft a picket") {
    const auto triangle = ready(Triangle<double>{.a = {0, -0.03}, .b = {0.05, 0}, .c = {0, 0.03}});
    CHECK(largest_difference(Outlined(Arrow<double>{{0, 0}, {0.05, 0}, 0.02, 0.05, 0.06}), triangle, 0.2) < 1e-16);
    const double xy[] = {0, -0.01, 0.04, -0.01, 0.05, 0, 0.04, 0.01, 0, 0.01};
    const auto picket = ready(Polygon<double>{.points = {xy, 5}});
    CHECK(largest_difference(Outlined(Arrow<double>{{0, 0}, {0.05, 0}, 0.02, 0.01, 0.02}), picket, 0.2) < 1e-16);
}

TEST_CASE("what is too short to have a direction in doubles is left out: roundings, notches, a shaft") {
    const double tiny = 2e-18, nearly = 1 - 1e-15;
    const Outlined box(RoundedBox<double>{{0.1, 0.06}, tiny, tiny, tiny, tiny});
    CHECK(box.outline.size() == 4);
    CHECK(largest_difference(box, Box<double>{{0.1, 0.06}, 0}, 0.2) < 1e-15);
    CHECK(Outlined(Cross<double>{0.09, 0.03, tiny}).outline.size() == 12);
    const Outlined square(Cross<double>{0.06, 0.06 * nearly, 0});
    CHECK(square.outline.size() == 4);
    CHECK(largest_difference(square, Box<double>{{0.06, 0.06}, 0}, 0.2) < 1e-15);
    const Outlined arrow(Arrow<double>{{0.01, 0.02}, {0.04, 0.06}, 0.02, 0.05 * nearly, 0.06});
    CHECK(arrow.outline.size() == 5);  // two sides, and the base in the three parts that ledges and tail are of
}

TEST_CASE("a long boundary is searched by its boxes with the bits of a search through every piece") {
    CounterRng rng(41);
    Outline gear;  // of arcs and lines in turn, touching themselves nowhere, some of no more than a hair's length
    OutlinePen pen(gear, {0.1, 0});
    constexpr int teeth = 300;
    for (int i = 1; i <= teeth; ++i) {
        const SineCosine turn = sine_cosine(two_pi * i / teeth);
        const Vec2 to = (i == teeth ? 0.1 : rng.in(0.05, 0.1)) * Vec2(turn.cosine, turn.sine);
        if (i % 2 == 0) pen.line_to(to);
        else pen.arc_to(to, 0.5 * (to + (gear.empty() ? Vec2(0.1, 0) : gear.back().b)), i % 4 == 1 ? 1 : -1);
    }
    const int count = static_cast<int>(gear.size());
    std::vector<double> plain(static_cast<std::size_t>(packed_outline_size(count)));
    pack_outline(gear, count, plain.data());
    const std::vector<double> boxed = found_outline_block(gear);
    REQUIRE(boxed[2] > 0);
    std::vector<Vec2> points = points_within(0.15, 4000);
    for (const Piece& piece : gear) points.insert(points.end(), {piece.a, 0.5 * (piece.a + piece.b)});
    int different = 0;
    for (const Vec2& p : points) {
        const Point<Dual> at{Dual(p.x(), 1, 0), Dual(p.y(), 0, 1)};
        const Dual one = distance_to_outline(at, plain.data()), other = distance_to_outline(at, boxed.data());
        different += one.v != other.v || one.dx != other.dx || one.dy != other.dy;
        different += distance_to_outline(Point<double>{p.x(), p.y()}, boxed.data()) != one.v;
    }
    CHECK(different == 0);
}

}  // namespace pinfield::sdf

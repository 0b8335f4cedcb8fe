// What the shapes of lines and arcs are by definition. The conformance battery measures a field against the shape's own outline;
// here the outline itself is measured against something else.
#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/circle_cross.h"
#include "engine/sdf/nodes/cool_s.h"
#include "engine/sdf/nodes/cut_disk.h"
#include "engine/sdf/nodes/egg.h"
#include "engine/sdf/nodes/heart.h"
#include "engine/sdf/nodes/horseshoe.h"
#include "engine/sdf/nodes/joint.h"
#include "engine/sdf/nodes/oriented_vesica.h"
#include "engine/sdf/nodes/pie.h"
#include "engine/sdf/nodes/polygon.h"
#include "engine/sdf/nodes/ring.h"
#include "engine/sdf/nodes/rounded_x.h"
#include "engine/sdf/nodes/segment.h"
#include "engine/sdf/nodes/tunnel.h"
#include "engine/sdf/nodes/uneven_capsule.h"
#include "engine/sdf/nodes/vesica.h"
#include "engine/sdf/outline_path.h"
#include "tests/sdf/support.h"

namespace pinfield::sdf {
namespace {

const double tau = 2 * std::acos(-1.0);

struct Disc {
    double radius;
    double distance(const Point<double>& p) const { return norm(p) - radius; }
};

/// The field of a shape that is written as its outline, packed as the engine does it.
template <class T>
struct Field {
    Outline pieces;
    std::vector<double> packed = std::vector<double>(packed_outline_size(T::most_pieces));

    explicit Field(const T& node) {
        node.outline(pieces);
        REQUIRE(pieces.size() <= static_cast<std::size_t>(T::most_pieces));
        pack_outline(pieces, T::most_pieces, packed.data());
    }
    double at(const Vec2& p) const { return distance_to_outline<double>({p.x(), p.y()}, packed.data()); }
    double at(double x, double y) const { return at(Vec2(x, y)); }
};

template <class T>
double field_of(const T& node, const Vec2& p) {
    return node.distance({p.x(), p.y()});
}
template <class T>
double field_of(const Field<T>& field, const Vec2& p) {
    return field.at(p);
}

template <class A, class B>
double largest_difference(const A& a, const B& b, double half) {
    double worst = 0;
    for (const Vec2& p : points_within(half)) worst = std::max(worst, std::fabs(field_of(a, p) - field_of(b, p)));
    return worst;
}

/// Checks which side of the outline every point is on, but for those that a rounding decides.
template <class T>
void check_inside(const Field<T>& field, double half, const std::function<bool(const Vec2&)>& is_inside) {
    int inside = 0;
    for (const Vec2& p : points_within(half, 2000)) {
        const double d = field.at(p);
        if (std::fabs(d) < 1e-12) continue;
        inside += d < 0;
        if ((d < 0) != is_inside(p)) FAIL_CHECK("at (" << p.x() << ", " << p.y() << "): " << d);
    }
    CHECK(inside > 3);
}

/// By Green's theorem: chords, and the segments between them and their arcs.
double area_of(const Outline& pieces) {
    double doubled = 0;
    for (const Piece& piece : pieces) {
        doubled += pinfield::cross(piece.a, piece.b);
        if (!piece.is_arc()) continue;
        const Vec2 u = piece.a - piece.centre, v = piece.b - piece.centre;
        double sweep = piece.turn * std::atan2(pinfield::cross(u, v), pinfield::dot(u, v));
        if (sweep < 0 || (sweep == 0 && piece.reflex)) sweep += tau;
        doubled += piece.turn * piece.radius * piece.radius * (sweep - std::sin(sweep));
    }
    return 0.5 * doubled;
}

/// Largest sine of the angles by which the outline turns where one piece ends and the next begins.
double sharpest_corner(const Outline& pieces) {
    const auto heading = [](const Piece& piece, const Vec2& p) {
        const Vec2 way = piece.is_arc() ? Vec2(piece.turn * perpendicular(p - piece.centre)) : Vec2(piece.b - piece.a);
        return Vec2(way / pinfield::length(way));
    };
    double worst = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece &piece = pieces[i], &next = pieces[(i + 1) % pieces.size()];
        CHECK(pinfield::length(piece.b - next.a) < 1e-15);
        worst = std::max(worst, std::fabs(pinfield::cross(heading(piece, piece.b), heading(next, next.a))));
    }
    return worst;
}

Vec2 on_circle(double radius, double degrees) {
    const double t = degrees * tau / 360;
    return {radius * std::cos(t), radius * std::sin(t)};
}

}  // namespace

TEST_CASE("a whole ring is an annulus without seam, one as thick as its circle is wide a disc") {
    const Field annulus(Ring<double>{.radius = 0.04, .from = 30, .to = 390, .thickness = 0.02});
    const Field disc(Ring<double>{.radius = 0.04, .from = 30, .to = 390, .thickness = 0.08});
    for (const Vec2& p : points_within(0.15)) {
        CHECK(annulus.at(p) == Approx(std::fabs(length(p) - 0.04) - 0.01).margin(1e-15));
        CHECK(disc.at(p) == Approx(length(p) - 0.08).margin(1e-15));
    }
}

TEST_CASE("a ring is the annulus between two directions") {
    for (const auto& [first, last] : {std::pair(10.0, 80.0), {-30.0, 200.0}, {100.0, 275.0}, {100.0, 280.0}, {100.0, 285.0}, {5.0, 364.0},
                                      {-1.0, 0.0}}) {
        const Field ring(Ring<double>{.radius = 0.04, .from = first, .to = last, .thickness = 0.03});
        check_inside(ring, 0.06, [first = first, last = last](const Vec2& p) {
            double turn = std::atan2(p.y(), p.x()) * 360 / tau - first;
            while (turn < 0) turn += 360;
            return std::fabs(length(p) - 0.04) < 0.015 && turn < last - first;
        });
        CHECK(area_of(ring.pieces) == Approx(tau * 0.04 * 0.03 * (last - first) / 360));
    }
}

TEST_CASE("a ring's ends are flat, straight out from the centre") {
    const Field ring(Ring<double>{.radius = 0.04, .from = 0, .to = 120, .thickness = 0.02});
    for (const double r : {0.03, 0.035, 0.04, 0.05}) {
        CHECK(std::fabs(ring.at(r, 0)) < 1e-16);
        CHECK(ring.at(r, -0.007) == Approx(0.007));
        CHECK(std::fabs(ring.at(on_circle(r, 120))) < 1e-16);
    }
    CHECK(ring.at(0.053, -0.004) == Approx(0.005));
    CHECK(ring.at(0, 0) == Approx(0.03));
}

TEST_CASE("a ring that fills its middle is a pie") {
    const Field ring(Ring<double>{.radius = 0.025, .from = 30, .to = 330, .thickness = 0.05});
    const Field pie(Pie<double>{.radius = 0.05, .from = 30, .to = 330});
    CHECK(largest_difference(ring, pie, 0.1) < 1e-15);
}

TEST_CASE("a cut disk is what of the disc lies above the cut") {
    for (const double height : {-0.04995, -0.03, -0.002, 0.0, 0.002, 0.03, 0.0499}) {
        const Field disk(CutDisk<double>{.radius = 0.05, .height = height});
        for (const Vec2& p : points_within(0.1)) CHECK((disk.at(p) < 0) == (length(p) < 0.05 && p.y() > height));
        const double t = std::acos(height / 0.05);
        CHECK(area_of(disk.pieces) == Approx(0.0025 * (t - std::sin(t) * std::cos(t))));
    }
}

TEST_CASE("a cut disk of 3-4-5 has these distances") {
    const Field disk(CutDisk<double>{.radius = 0.05, .height = 0.03});
    CHECK(disk.at(0, 0.032) == Approx(-0.002));
    CHECK(disk.at(0, 0.045) == Approx(-0.005));
    CHECK(disk.at(0, 0.06) == Approx(0.01));
    CHECK(disk.at(0.02, 0) == Approx(0.03));
    CHECK(disk.at(0.08, 0) == Approx(0.05));  // to the corner (0.04, 0.03)
    CHECK(std::fabs(disk.at(-0.04, 0.03)) < 1e-16);
    const Field whole(CutDisk<double>{.radius = 0.05, .height = -0.05});
    CHECK(largest_difference(whole, Disc{0.05}, 0.1) < 1e-15);
}

TEST_CASE("a horseshoe without legs is a ring about -y, with whatever bend") {
    for (const double angle : {1.0, 90.0, 180.0, 250.0, 359.0}) {
        const Field shoe(Horseshoe<double>{.radius = 0.04, .angle = angle, .leg = 0, .thickness = 0.02});
        const Field ring(Ring<double>{.radius = 0.04, .from = -90 - angle / 2, .to = -90 + angle / 2, .thickness = 0.02});
        CHECK(largest_difference(shoe, ring, 0.1) < 1e-15);
    }
}

TEST_CASE("a horseshoe bent by half a turn is a U between upright legs") {
    const Field shoe(Horseshoe<double>{.radius = 0.04, .angle = 180, .leg = 0.05, .thickness = 0.02});
    check_inside(shoe, 0.06, [](const Vec2& p) {
        return p.y() > 0 ? p.y() < 0.05 && std::fabs(std::fabs(p.x()) - 0.04) < 0.01 : std::fabs(length(p) - 0.04) < 0.01;
    });
    CHECK(shoe.at(0, 0.04) == Approx(0.03));
    CHECK(shoe.at(0.04, 0.06) == Approx(0.01));
    CHECK(shoe.at(0.08, 0.09) == Approx(0.05));  // 3-4-5 from the corner (0.05, 0.05)
}

TEST_CASE("a horseshoe's area is its width times the length of its middle, and its legs go on as the bend ends") {
    const Field shoe(Horseshoe<double>{.radius = 0.04, .angle = 240, .leg = 0.03, .thickness = 0.014});
    CHECK(area_of(shoe.pieces) == Approx(0.014 * (0.06 + 0.04 * tau * 240 / 360)));
    const double t = 30 * tau / 360;  // the bend ends 30 degrees above the horizontal
    const Vec2 end_of_bend(0.04 * std::cos(t), 0.04 * std::sin(t)), up_the_leg(-std::sin(t), std::cos(t));
    for (const double s : {0.0, 0.01, 0.02}) {
        CHECK(shoe.at(end_of_bend + s * up_the_leg) == Approx(-0.007));
        CHECK(shoe.at(end_of_bend - on_circle(0.01, 30) + s * up_the_leg) == Approx(0.003));
    }
    CHECK(std::fabs(shoe.at(end_of_bend + 0.03 * up_the_leg)) < 1e-16);
    CHECK(Horseshoe<double>{.radius = 0.04, .angle = 240, .leg = 0.03, .thickness = 0.014}.opening() ==
          Approx(2 * (0.033 * std::cos(t) - 0.03 * std::sin(t))));
}

TEST_CASE("a vesica is the points within both of two equal discs") {
    // Discs of radius 0.05, their centres 0.06 apart: 0.08 from tip to tip, 0.04 across.
    const auto in_both = [](const Vec2& p, const Vec2& centre) { return length(p - centre) < 0.05 && length(p + centre) < 0.05; };
    const Field flat(Vesica<double>{.length = 0.08, .width = 0.04}), tall(Vesica<double>{.length = 0.04, .width = 0.08});
    check_inside(flat, 0.06, [&](const Vec2& p) { return in_both(p, {0, 0.03}); });
    check_inside(tall, 0.06, [&](const Vec2& p) { return in_both(p, {0.03, 0}); });
    const double half = std::asin(0.8);
    CHECK(area_of(flat.pieces) == Approx(0.0025 * (2 * half - std::sin(2 * half))));
    CHECK(flat.at(0, 0) == Approx(-0.02));
    CHECK(flat.at(0, 0.05) == Approx(0.03));
    CHECK(flat.at(0.08, 0.03) == Approx(0.05));  // from the tip, along the normal of its upper side there
    CHECK(flat.at(0.1, 0) == Approx(0.06));
    for (const Vec2& p : points_within(0.1)) CHECK(tall.at(p) == Approx(flat.at(p.y(), -p.x())).margin(1e-15));
}

TEST_CASE("a vesica as long as wide is a disc, and nearly so on either side of it") {
    const Disc disc{0.04};
    CHECK(largest_difference(Field(Vesica<double>{.length = 0.08, .width = 0.08}), disc, 0.1) < 1e-15);
    CHECK(largest_difference(Field(Vesica<double>{.length = 0.08 * (1 + 1e-9), .width = 0.08}), disc, 0.1) < 1e-10);
    CHECK(largest_difference(Field(Vesica<double>{.length = 0.08, .width = 0.08 * (1 + 1e-9)}), disc, 0.1) < 1e-10);
}

TEST_CASE("an oriented vesica is a vesica laid from tip to tip") {
    const Field oriented(OrientedVesica<double>{.a = {0.01, 0.02}, .b = {0.07, 0.10}, .width = 0.03});
    const Field lens(Vesica<double>{.length = 0.1, .width = 0.03});
    for (const Vec2& p : points_within(0.2)) {  // 3-4-5
        const Vec2 q = Vec2(0.04, 0.06) + Vec2(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y());
        CHECK(oriented.at(q) == Approx(lens.at(p)).margin(1e-15));
    }
    CHECK(std::fabs(oriented.at(0.01, 0.02)) < 1e-16);
    const Field round(OrientedVesica<double>{.a = {0, 0.02}, .b = {0, 0.08}, .width = 0.06});
    for (const Vec2& p : points_within(0.2)) CHECK(round.at(p) == Approx(length(p - Vec2(0, 0.05)) - 0.03).margin(1e-15));
}

TEST_CASE("an egg's sides touch both of its discs and bulge as asked") {
    for (const double bulge : {0.001, 0.2, 0.6, 0.95, 0.999999})
        for (const auto& [a, b, height] : {std::tuple(0.035, 0.015, 0.04), {0.01, 0.03, 0.05}, {0.02, 0.02, 0.03}, {0.03, 0.01, 0.0201}}) {
            INFO(a << " " << b << " " << height << " " << bulge);
            const Field egg(Egg<double>{.lower_radius = a, .upper_radius = b, .height = height, .bulge = bulge});
            REQUIRE(egg.pieces.size() == 4);
            CHECK(sharpest_corner(egg.pieces) < 1e-9);
            CHECK(egg.at(0, -a) == Approx(0).margin(1e-15));
            CHECK(egg.at(0, height + b) == Approx(0).margin(1e-15));
            for (const Piece& side : {egg.pieces[1], egg.pieces[3]}) {
                CHECK(side.radius == Approx(0.5 * (height + a + b) / bulge));
                CHECK(length(side.centre) == Approx(side.radius - a));
                CHECK(length(side.centre - Vec2(0, height)) == Approx(side.radius - b));
            }
        }
}

TEST_CASE("an egg without bulge is an uneven capsule, with all of it a disc, and nearly so at the limits") {
    const auto capsule = ready(UnevenCapsule<double>{.length = 0.04, .radius_a = 0.03, .radius_b = 0.01});
    const Field straight(Egg<double>{.lower_radius = 0.03, .upper_radius = 0.01, .height = 0.04, .bulge = 0});
    for (const Vec2& p : points_within(0.1)) CHECK(straight.at(p) == Approx(capsule.distance({p.y(), -p.x()})).margin(1e-15));
    const Field round(Egg<double>{.lower_radius = 0.03, .upper_radius = 0.01, .height = 0.04, .bulge = 1});
    for (const Vec2& p : points_within(0.1)) CHECK(round.at(p) == Approx(length(p - Vec2(0, 0.01)) - 0.04).margin(1e-15));
    const Field nearly(Egg<double>{.lower_radius = 0.03, .upper_radius = 0.01, .height = 0.04, .bulge = 1 - 1e-9});
    CHECK(largest_difference(nearly, round, 0.1) < 1e-5);  // the sides' centres are off by the root
}

TEST_CASE("an egg with one disc in the other is the larger disc, up to and at the limit") {
    for (const double height : {0.0, 0.01, 0.02, 0.02 * (1 + 1e-15), 0.02 * (1 + 1e-12), 0.02 * (1 + 1e-9)}) {
        const Field below(Egg<double>{.lower_radius = 0.03, .upper_radius = 0.01, .height = height, .bulge = 0.5});
        const Field above(Egg<double>{.lower_radius = 0.01, .upper_radius = 0.03, .height = height, .bulge = 0.5});
        for (const Vec2& p : points_within(0.1)) {
            CHECK(below.at(p) == Approx(length(p) - 0.03).margin(1e-10));
            CHECK(above.at(p) == Approx(length(p - Vec2(0, height)) - 0.03).margin(1e-10));
        }
    }
}

TEST_CASE("an egg with two points for discs is a vesica") {
    const Field egg(Egg<double>{.lower_radius = 0, .upper_radius = 1e-12, .height = 0.08, .bulge = 0.8});  // sides of radius 0.05
    const Field lens(Vesica<double>{.length = 0.04, .width = 0.08});
    for (const Vec2& p : points_within(0.1)) CHECK(egg.at(p + Vec2(0, 0.04)) == Approx(lens.at(p)).margin(1e-11));
}

TEST_CASE("a heart is a square on its corner and a disc over each upper side") {
    const double size = 0.1, c = size / (1 + std::sqrt(2.0));
    const Field heart(Heart<double>{size});
    check_inside(heart, 0.06, [&](const Vec2& p) {
        const Vec2 lobe(c / 2, c / 2), right(std::fabs(p.x()), p.y());
        return std::fabs(p.x()) + std::fabs(p.y()) < c || length(right - lobe) < c * std::sqrt(0.5);
    });
    CHECK(area_of(heart.pieces) == Approx(2 * c * c + tau / 2 * c * c / 2));
    CHECK(heart.at(size / 2, c / 2) == Approx(0).margin(1e-16));
    CHECK(heart.at(0, -c - 0.01) == Approx(0.01));
    CHECK(heart.at(0, c + 0.001) == Approx(length(Vec2(c / 2, c / 2 + 0.001)) - c * std::sqrt(0.5)));  // in the notch
    CHECK(heart.at(0, 0) == Approx(-c * std::sqrt(0.5)));
    const Box2 box = bounds_of(heart.pieces);
    CHECK(box.size().x() == Approx(size));
    CHECK(box.size().y() == Approx(0.9142135624 * size));
}

TEST_CASE("a rounded x is two segments with round ends, outside") {
    for (const double thickness : {0.001, 0.02, 0.04, 0.05, 0.07, 0.099, 0.1}) {
        const Field cross(RoundedX<double>{.size = 0.1, .thickness = thickness});
        const double c = 0.5 * (0.1 - thickness);
        const auto rising = ready(Segment<double>{.a = {-c, -c}, .b = {c, c}, .thickness = thickness});
        const auto falling = ready(Segment<double>{.a = {-c, c}, .b = {c, -c}, .thickness = thickness});
        for (const Vec2& p : points_within(0.1)) {
            const double both = std::min(field_of(rising, p), field_of(falling, p)), d = cross.at(p);
            if (both > 1e-16) CHECK(d == Approx(both).margin(1e-15));
            else CHECK(d <= both + 1e-15);  // a union's inside is only a bound
        }
    }
}

TEST_CASE("a rounded x is exact inside: its middle is as far from the notches as they are from it") {
    const Field cross(RoundedX<double>{.size = 0.1, .thickness = 0.02});
    CHECK(cross.at(0, 0) == Approx(-0.01 * std::sqrt(2.0)));
    CHECK(cross.at(0.02, 0.02) == Approx(-0.01));
    CHECK(cross.at(0, 0.02) == Approx((0.02 - 0.01 * std::sqrt(2.0)) * std::sqrt(0.5)));
    CHECK(largest_difference(Field(RoundedX<double>{.size = 0.1, .thickness = 0.1}), Disc{0.05}, 0.1) < 1e-15);
}

TEST_CASE("a tunnel is a box and a half disc on it") {
    const Field tunnel(Tunnel<double>{.width = 0.06, .height = 0.08});  // the arch springs at y = 0.01
    check_inside(tunnel, 0.06, [](const Vec2& p) {
        return p.y() > 0.01 ? length(p - Vec2(0, 0.01)) < 0.03 : std::fabs(p.x()) < 0.03 && p.y() > -0.04;
    });
    CHECK(area_of(tunnel.pieces) == Approx(0.06 * 0.05 + tau / 4 * 0.0009));
    CHECK(tunnel.at(0, 0.05) == Approx(0.01));
    CHECK(tunnel.at(0.06, -0.08) == Approx(0.05));
    CHECK(tunnel.at(0, 0) == Approx(-0.03));
    CHECK(tunnel.at(0.02, -0.015) == Approx(-0.01));
    const Field arch(Tunnel<double>{.width = 0.06, .height = 0.03});
    const Field half_disc(CutDisk<double>{.radius = 0.03, .height = 0});
    for (const Vec2& p : points_within(0.1)) CHECK(arch.at(p - Vec2(0, 0.015)) == Approx(half_disc.at(p)).margin(1e-15));
}

TEST_CASE("a circle cross of equal arms is a square without a disc about each corner") {
    const Field cross(CircleCross<double>{.size = {0.1, 0.1}, .tip = 0.02});
    check_inside(cross, 0.06, [](const Vec2& p) {
        const Vec2 q(std::fabs(p.x()), std::fabs(p.y()));
        return q.x() < 0.05 && q.y() < 0.05 && length(q - Vec2(0.05, 0.05)) > 0.04;
    });
    CHECK(area_of(cross.pieces) == Approx(0.01 - tau / 2 * 0.0016));
    CHECK(cross.at(0.05, 0.05) == Approx(0.04));
    CHECK(cross.at(0, 0) == Approx(0.04 - 0.05 * std::sqrt(2.0)));
    const Field square(CircleCross<double>{.size = {0.1, 0.1}, .tip = 0.1});
    CHECK(largest_difference(square, Box<double>{{0.1, 0.1}, 0.0}, 0.1) < 1e-15);
}

TEST_CASE("a circle cross with all but pointed arms is that of the article: arcs about (1, k) with k = (h + 1/h) / 2") {
    const double unit = 0.05, h = 0.4, k = 0.5 * (h + 1 / h), tip = 1e-4;
    const Field cross(CircleCross<double>{.size = {2 * unit, 2 * h * unit}, .tip = tip});
    check_inside(cross, 0.06, [&](const Vec2& p) {
        const Vec2 q(std::fabs(p.x()) / unit, std::fabs(p.y()) / unit);
        const bool within = q.x() < 1 && q.y() < h && length(q - Vec2(1, k)) > k;
        // The flat tips shift the arcs by a little: points between the two say nothing.
        return std::fabs(length(q - Vec2(1, k)) - k) < 0.01 ? cross.at(p) < 0 : within;
    });
}

TEST_CASE("a circle cross leaves the longer arm's tip along the arm, whichever arm that is") {
    const Field wide(CircleCross<double>{.size = {0.12, 0.06}, .tip = 0.01}), tall(CircleCross<double>{.size = {0.06, 0.12}, .tip = 0.01});
    for (const Piece& piece : wide.pieces)
        if (piece.is_arc()) {
            CHECK(std::fabs(piece.centre.x()) == Approx(0.06));
            CHECK(length(piece.a - piece.centre) == Approx(length(piece.b - piece.centre)));
        }
    for (const Vec2& p : points_within(0.1)) CHECK(tall.at(p) == Approx(wide.at(p.y(), -p.x())).margin(1e-15));
    const Field bar(CircleCross<double>{.size = {0.12, 0.03}, .tip = 0.03});
    CHECK(largest_difference(bar, Box<double>{{0.12, 0.03}, 0.0}, 0.1) < 1e-15);
    CHECK(std::fabs(wide.at(0.06, 0.005)) < 1e-16);
    CHECK(std::fabs(wide.at(0.005, 0.03)) < 1e-16);
    CHECK(wide.at(0.07, 0) == Approx(0.01));
}

TEST_CASE("a cool s without slits is its silhouette of twelve corners") {
    const Field s(CoolS<double>{.size = 0.2, .gap = 0});
    const double xy[] = {0,     0.1,   -0.04, 0.06,  -0.04, 0.02, -0.02, 0,    -0.04, -0.02, -0.04, -0.06,
                         0, -0.1,  0.04,  -0.06, 0.04,  -0.02, 0.02, 0, 0.04,  0.02, 0.04,  0.06};
    CHECK(largest_difference(s, ready(Polygon<double>{.points = {xy, 12}}), 0.15) < 1e-15);
    CHECK(s.pieces.size() == 12);
}

TEST_CASE("a cool s is its silhouette without two slits of the given width") {
    const double gap = 0.004;
    const Field s(CoolS<double>{.size = 0.2, .gap = gap}), silhouette(CoolS<double>{.size = 0.2, .gap = 0});
    // The upper slit: down the middle, then aside above the line x + y = 0.02.
    const auto in_slit = [&](const Vec2& p) {
        const double beyond = (p.x() + p.y() - 0.02) * std::sqrt(0.5);
        if (p.y() > 0.06 || p.x() < -gap / 2 || p.y() < 0 || beyond < 0) return false;
        return p.x() < gap / 2 || (beyond < gap && p.x() < 0.04);
    };
    check_inside(s, 0.1, [&](const Vec2& p) { return silhouette.at(p) < 0 && !in_slit(p) && !in_slit(-p); });
    CHECK(s.at(0, 0.05) == Approx(gap / 2));
    CHECK(s.at(0, -0.03) == Approx(gap / 2));
    CHECK(s.at(0, 0) == Approx(-0.02 * std::sqrt(0.5)));  // the middle strand
    CHECK(s.at(-0.03, 0.04) == Approx(-0.01));
    for (const Vec2& p : points_within(0.15)) CHECK(s.at(p) == Approx(s.at(-p)).margin(1e-16));
}

TEST_CASE("a straight joint is a box that starts at the origin") {
    const Field joint(Joint<double>{.length = 0.1, .angle = 0, .thickness = 0.02});
    const Box<double> box{{0.1, 0.02}, 0.0};
    for (const Vec2& p : points_within(0.2)) CHECK(joint.at(p) == Approx(field_of(box, p - Vec2(0.05, 0))).margin(1e-15));
}

TEST_CASE("a bent joint is a ring with its middle as long as asked") {
    for (const double angle : {0.05, 1.0, 90.0, 180.0, 270.0}) {
        const double radius = 0.1 * 360 / tau / angle;
        const Field left(Joint<double>{.length = 0.1, .angle = angle, .thickness = 0.02});
        const Field right(Joint<double>{.length = 0.1, .angle = -angle, .thickness = 0.02});
        const Field ring(Ring<double>{.radius = radius, .from = -90, .to = angle - 90, .thickness = 0.02});
        CHECK(area_of(left.pieces) == Approx(0.002));
        CHECK(area_of(right.pieces) == Approx(0.002));
        for (const Vec2& p : points_within(0.2)) {
            CHECK(left.at(p) == Approx(ring.at(p - Vec2(0, radius))).margin(1e-12));
            CHECK(right.at(p) == Approx(left.at(p.x(), -p.y())).margin(1e-15));
        }
    }
}

TEST_CASE("a joint passes through straight, and where its bend becomes even, without a jump") {
    const auto bent_by = [](double angle) { return Field(Joint<double>{.length = 0.1, .angle = angle, .thickness = 0.02}); };
    const double limit = Joint<double>::least_even_angle;
    for (const double angle : {-limit, -limit / 2, -1e-9, 0.0, 1e-9, 1e-6, limit / 3, limit, 2.0}) {
        const double step = 1e-7;  // moves the far end by no more than length times angle
        CHECK(largest_difference(bent_by(angle), bent_by(angle + step), 0.2) < 0.1 * step * tau / 360 + 1e-13);
        CHECK(area_of(bent_by(angle).pieces) == Approx(0.002));
    }
}

}  // namespace pinfield::sdf

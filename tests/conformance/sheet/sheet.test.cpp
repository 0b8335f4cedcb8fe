#include <catch2/catch.hpp>

#include <cmath>

#include "engine/sdf/own_node.h"
#include "engine/sdf/register.h"
#include "tests/conformance/brute_force.h"
#include "tests/conformance/faulty_nodes.h"
#include "tests/conformance/parameters.h"
#include "tests/conformance/sheet/page.h"
#include "tests/conformance/sheet/zero_line.h"

namespace pinfield::conformance {
namespace {

using namespace sdf::faulty;

template <template <class> class N>
Measure measured() {
    Catalog catalog;
    sdf::add_built_in(catalog);
    return measure(catalog, catalog.add(sdf::sdf_node_type<N>()), 0);
}

Measure measured(const char* key) {
    Catalog catalog;
    sdf::add_built_in(catalog);
    return measure(catalog, *catalog.find(key), 0);
}

}  // namespace

TEST_CASE("the zero line of a disc is its circle") {
    const auto disc = [](const Vec2& p) { return length(p) - 0.04; };
    const sdf::Outline chords = zero_line(disc, {Box2::centred(0.05, 0.05), 4e-4, 1e-9, 1});
    CHECK(chords.size() > 100);
    for (int i = 0; i < 100; ++i) {
        const Vec2 p = 0.002 * i * Vec2(std::cos(0.7 * i), std::sin(0.7 * i));
        CHECK(std::fabs(distance_to_outline(p, chords) - std::fabs(disc(p))) < 2e-9);
    }
}

TEST_CASE("the zero line of a field that is only a bound has the true corners, and both walls of a narrow gap") {
    // Two squares 3 mm apart by their largest coordinates: no distance beyond their corners.
    const auto square = [](const Vec2& p) { return 0.3 * (p.cwiseAbs().maxCoeff() - 0.02); };
    const auto field = [&](const Vec2& p) { return std::min(square(p - Vec2(0.0215, 0)), square(p + Vec2(0.0215, 0))); };
    const sdf::Outline chords = zero_line(field, {Box2::centred(0.0501, 0.0502), 4e-4, 1e-9, 0.3});
    for (const Vec2& corner : {Vec2(0.0015, 0.02), Vec2(-0.0015, -0.02), Vec2(0.0415, 0.02), Vec2(-0.0415, 0.02)})
        CHECK(distance_to_outline(corner, chords) < 2e-9);
    CHECK(std::fabs(distance_to_outline({0.0415 + 0.003, 0.02 + 0.004}, chords) - 0.005) < 2e-9);
    CHECK(std::fabs(distance_to_outline({0, 0}, chords) - 0.0015) < 2e-9);
}

TEST_CASE("the zero line parts or joins two solids whose gap is narrower than a cell, as the field does") {
    // Hyperbolas about the origin: two solids with a gap along one diagonal, and one solid with a waist along the other.
    const double c = 0.0008;
    for (const double offset : {c, -c}) {
        const auto field = [&](const Vec2& p) { return offset - p.x() * p.y(); };
        const sdf::Outline chords = zero_line(field, {Box2{{-0.86, -0.84}, {0.74, 0.76}}, 0.1, 1e-9, 2});
        CHECK(distance_to_outline({0, 0}, chords) == Approx(std::sqrt(2 * c)).epsilon(1e-6));
        for (const Vec2& p : {Vec2(0.02, 0.02), Vec2(-0.01, -0.02), Vec2(0.02, -0.02), Vec2(-0.01, 0.01)}) {
            double nearest = infinity;
            for (int i = -100000; i <= 100000; ++i)
                if (i != 0) nearest = std::min(nearest, length(Vec2(i * 1e-5, offset / (i * 1e-5)) - p));
            CHECK(distance_to_outline(p, chords) == Approx(nearest).margin(1e-6));
        }
    }
}

TEST_CASE("a sound shape measures as it claims") {
    for (const char* key : {"circle", "box", "ellipse", "half_plane", "union", "round", "repeat_polar"}) {
        INFO(key);
        const Measure m = measured(key);
        REQUIRE(!m.outside.empty());
        const double floor = floor_of(m.outside[0].reference);
        CHECK(m.outside[0].claimed == Side::exact);
        CHECK(std::max(m.outside[0].over, m.outside[0].under) <= floor);
        for (const SideMeasure& side : m.inside) CHECK(side.over <= floor_of(side.reference));
        CHECK(m.slope == Approx(1).epsilon(1e-9));
    }
    CHECK(measured("circle").outside[0].reference == Reference::outline);
    CHECK(measured("ellipse").outside[0].reference == Reference::curve);
    CHECK(measured("half_plane").outside[0].reference == Reference::zero_line);
    CHECK(measured("union").inside.back().under > 0.1);  // overlapping discs: the inside is a bound
}

TEST_CASE("the measure tells what is wrong with a faulty node") {
    // A disc of 0.9 of its size: too far by a tenth everywhere outside, too near inside the rim.
    const Measure over = measured<OverEstimate>();
    CHECK(over.outside[0].over == Approx(0.1 / 0.9).epsilon(0.2));
    CHECK(over.inside[0].under == Approx(0.1 / 0.9).epsilon(0.2));

    // A square by its largest coordinate: at (4, 4) it says 3, the corner is 3 * sqrt 2 away.
    const Measure claim = measured<WrongClaim>();
    CHECK(claim.outside[0].claimed == Side::exact);
    CHECK(claim.outside[0].under == Approx(3 * (std::sqrt(2.0) - 1)).epsilon(0.01));
    CHECK(claim.outside[0].over <= floor_of(claim.outside[0].reference));

    const Measure steep = measured<WrongLipschitz>();
    CHECK(steep.slope == Approx(1));
    CHECK(steep.slope_claimed == 0.9);
    CHECK(measured<Jump>().slope > 10);
    CHECK(measured<PacketOff>().float_error > 1e-6);
    CHECK(measured<WarpPacketsOff>().float_error > 1e-6);

    const Measure combined = measured<UnionSaidExact>();
    CHECK(combined.inside[0].claimed == Side::exact);
    CHECK(combined.inside[0].under > 0.1);
}

TEST_CASE("errors are told by one digit, rounded up") {
    CHECK(at_most(0.0321, 1e-6) == "0.04");
    CHECK(at_most(0.04, 1e-6) == "0.04");
    CHECK(at_most(0.0400001, 1e-6) == "0.05");
    CHECK(at_most(0.96, 1e-6) == "1");
    CHECK(at_most(3.7e-7, 1e-9) == "4e-07");
    CHECK(at_most(2e-7, 1e-6) == "< 1e-06");
    CHECK(at_most(0, 1e-6) == "< 1e-06");
}

TEST_CASE("timings go through their file") {
    Catalog catalog;
    sdf::add_built_in(catalog);
    const Timings timings{{"circle", {12.34, 0.567, "avx2"}}, {"mirror", {}}};
    const auto back = read_timings(csv_of(catalog, timings));
    REQUIRE(back);
    CHECK(back->at("circle").in_double == 12.0);
    CHECK(back->at("circle").in_packets == 0.6);
    CHECK(back->at("circle").isa == "avx2");
    CHECK(!back->at("mirror").in_double);
    CHECK(csv_of(catalog, *back) == csv_of(catalog, timings));
    CHECK(!read_timings("node,other\n"));
    CHECK(!read_timings("node,double ns,packet ns,instruction set\ncircle,fast,1,avx2\n"));
}

}  // namespace pinfield::conformance

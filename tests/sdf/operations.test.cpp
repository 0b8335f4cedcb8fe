#include <catch2/catch.hpp>

#include <array>
#include <cmath>

#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "engine/sdf/operations/complement.h"
#include "engine/sdf/operations/difference.h"
#include "engine/sdf/operations/inset.h"
#include "engine/sdf/operations/intersection.h"
#include "engine/sdf/operations/lerp.h"
#include "engine/sdf/operations/mirror.h"
#include "engine/sdf/operations/onion.h"
#include "engine/sdf/operations/repeat.h"
#include "engine/sdf/operations/repeat_polar.h"
#include "engine/sdf/operations/round.h"
#include "engine/sdf/operations/smooth_difference.h"
#include "engine/sdf/operations/smooth_intersection.h"
#include "engine/sdf/operations/smooth_union.h"
#include "engine/sdf/operations/union.h"
#include "engine/sdf/operations/xor.h"
#include "tests/sdf/support.h"

namespace pinfield::sdf {
namespace {

constexpr Exactness exact{}, bound{Side::bound, Side::bound};
using Two = std::array<Exactness, 2>;

}  // namespace

TEST_CASE("the complement of the complement is the thing itself") {
    for (const double d : {-0.3, -0.0, 0.0, 0.2}) CHECK(Complement<double>::modify(Complement<double>::modify(d)) == d);
    const std::array<Exactness, 1> child{Exactness{Side::exact, Side::bound, 1}};
    const std::array<Exactness, 1> once{Complement<double>::exactness(child)};
    CHECK(once[0] == Exactness{Side::bound, Side::exact, 1});
    CHECK(Complement<double>::exactness(once) == child[0]);
}

TEST_CASE("the exclusive or of two discs that cross is exact on both sides") {
    // Its outline is all of both circles, so the distance is the lesser of the distances to them.
    const Vec2 a(-0.02, 0), b(0.02, 0.005);
    for (const Vec2& p : points_within(0.1)) {
        const double da = length(p - a) - 0.03, db = length(p - b) - 0.025;
        const double f = Xor<double>::combine(da, db);
        CHECK(std::fabs(f) == std::min(std::fabs(da), std::fabs(db)));
        CHECK((f < 0) == ((da < 0) != (db < 0)));
    }
}

TEST_CASE("the difference is the intersection with the complement, the union its dual") {
    for (const double a : {-0.2, 0.0, 0.1})
        for (const double b : {-0.1, 0.0, 0.3}) {
            CHECK(Difference<double>::combine(a, b) == Intersection<double>::combine(a, -b));
            CHECK(Union<double>::combine(a, b) == -Intersection<double>::combine(-a, -b));
        }
}

TEST_CASE("each operation keeps of its children's exactness what it can and no more") {
    CHECK(Union<double>::exactness(Two{exact, exact}) == Exactness{Side::exact, Side::bound, 1});
    CHECK(Union<double>::exactness(Two{exact, bound}) == bound);
    CHECK(Intersection<double>::exactness(Two{exact, exact}) == Exactness{Side::bound, Side::exact, 1});
    CHECK(Difference<double>::exactness(Two{exact, exact}) == Exactness{Side::bound, Side::exact, 1});
    CHECK(Difference<double>::exactness(Two{exact, {Side::bound, Side::exact, 1}}) == bound);
    CHECK(Difference<double>::exactness(Two{exact, {Side::exact, Side::bound, 1}}) == Exactness{Side::bound, Side::exact, 1});
    CHECK(Intersection<double>::exactness(Two{exact, {Side::exact, Side::exact, 2}}).lipschitz == 2);
    const std::array<Exactness, 1> single{exact};
    CHECK(Union<double>::exactness(single) == exact);
    CHECK(Xor<double>::exactness(single) == exact);
    CHECK(SmoothUnion<double>{}.exactness(single) == exact);
    CHECK(Round<double>{.radius = 0}.exactness(single) == exact);
    CHECK(RepeatPolar<double>{.count = 1}.exactness(single) == exact);
    CHECK(Onion<double>::exactness(std::array{Exactness{Side::exact, Side::bound, 1}}) == bound);
}

TEST_CASE("a smooth union lowers what coincides by k, leaves alone what is 4 k apart, and is symmetric") {
    const SmoothUnion<double> blend{.k = 0.01};
    for (const double a : {-0.05, 0.0, 0.02}) {
        CHECK(blend.combine(a, a) == Approx(a - 0.01).margin(1e-17));
        CHECK(blend.combine(a, a + 0.04) == a);
        CHECK(blend.combine(a + 0.05, a) == a);
        CHECK(blend.combine(a, a + 0.013) == blend.combine(a + 0.013, a));
    }
    const SmoothUnion<double> dry{.k = 0};
    CHECK(dry.combine(0.01, 0.02) == 0.01);
    CHECK(dry.combine(0.01, 0.01) == 0.01);
}

TEST_CASE("every family of blend lowers what coincides by k and nothing by more, with slopes between 0 and 1/2, or of stairs 1") {
    const double k = 0.01;
    const std::array widths{4.0, 6.0, 16.0 / 3, 1 / (1 - std::sqrt(0.5)), infinity, 2.0, 2.0};  // in k, where the bump ends (four stairs')
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const auto family = static_cast<BlendFamily>(i);
        CAPTURE(choice_names(family)[i]);
        CHECK(smooth_min(0.02, 0.02, k, family) == Approx(0.02 - k).epsilon(1e-14));
        CHECK(smooth_min(-0.02, -0.02, 0.0, family) == -0.02);
        double last = k;
        for (double x = 0; x < 0.1; x += 1e-4) {
            const double here = bump(x, k, family);
            CHECK(here <= last);
            CHECK(last - here <= (family == BlendFamily::stairs ? 1 : 0.5) * 1e-4 + 1e-16);
            if (x > widths[i] * k) CHECK(std::fabs(here) < 1e-16);
            last = here;
        }
        CHECK(smooth_min(0.013, 0.02, k, family) == smooth_min(0.02, 0.013, k, family));
    }
}

TEST_CASE("stairs are as many corners between two walls as there are steps, the one in the middle k high, and no distance is overrated") {
    const double k = 0.01;
    for (const int steps : {1, 2, 3, 4, 5, 8, 17, 64}) {
        CAPTURE(steps);
        const double s = k / ((steps + 1) / 2);
        CHECK(smooth_min(0.02, 0.02, k, BlendFamily::stairs, steps) == Approx(0.02 - k).epsilon(1e-14));
        CHECK(smooth_min(0.02, 0.02 + steps * s, k, BlendFamily::stairs, steps) == Approx(0.02).epsilon(1e-14));
        CHECK(smooth_min(-0.02, -0.02, 0.0, BlendFamily::stairs, steps) == -0.02);
        CounterRng random(static_cast<std::uint64_t>(steps));
        for (int i = 0; i < 2000; ++i) {
            const double a = random.in(-0.03, 0.03), b = random.in(-0.03, 0.03);
            double wanted = std::min(a, b);  // the lattice formula of the corners
            for (int step = 1; step <= steps; ++step) wanted = std::min(wanted, std::max(a - step * s, b - (steps + 1 - step) * s));
            const double found = smooth_min(a, b, k, BlendFamily::stairs, steps);
            CHECK(found == Approx(wanted).margin(1e-16));
            CHECK(smooth_min(b, a, k, BlendFamily::stairs, steps) == found);
            const Dual f = smooth_min(Dual(a, 1, 0), Dual(b, 0, 1), Dual(k), BlendFamily::stairs, steps);
            CHECK((f.dx == 0 || f.dx == 1));
            CHECK(f.dx + f.dy == 1);
        }
    }
    // Solid left of x = 0 and below y = 0: three steps of 5 mm, by the corner of each.
    const auto solid = [&](double x, double y) { return smooth_min(x, y, k, BlendFamily::stairs, 3) < 0; };
    for (const Vec2& corner : {Vec2(0.005, 0.015), Vec2(0.010, 0.010), Vec2(0.015, 0.005)}) {
        CHECK(solid(corner.x() - 1e-6, corner.y() - 1e-6));
        CHECK_FALSE(solid(corner.x() + 1e-6, corner.y() - 1e-6));
        CHECK_FALSE(solid(corner.x() - 1e-6, corner.y() + 1e-6));
    }
}

TEST_CASE("the exponential blend is the logarithm of a sum of powers of two, whatever the order") {
    const double k = 0.01;
    for (const double a : {-0.03, 0.0, 0.004})
        for (const double b : {-0.02, 0.001, 0.3, 5.0}) {
            CHECK(smooth_min(a, b, k, BlendFamily::exponential) ==
                  Approx(-k * std::log2(std::exp2(-a / k) + std::exp2(-b / k))).epsilon(1e-13).margin(1e-16));
            const double left = smooth_min(smooth_min(a, b, k, BlendFamily::exponential), 0.002, k, BlendFamily::exponential);
            const double right = smooth_min(a, smooth_min(b, 0.002, k, BlendFamily::exponential), k, BlendFamily::exponential);
            CHECK(left == Approx(right).margin(1e-16));
        }
}

TEST_CASE("the circular blend of two perpendicular walls is a quarter of a circle, the chamfer a bevel of 45 degrees") {
    // Solid left of x = 0 and below y = 0: the filled corner's outline touches both walls at the same distance.
    const double k = 0.01, radius = k / (1 - std::sqrt(0.5));
    for (int i = 1; i < 10; ++i) {
        const double angle = i * 0.157;
        const double x = radius * (1 - std::cos(angle)), y = radius * (1 - std::sin(angle));
        CHECK(std::fabs(smooth_min(x, y, k, BlendFamily::circular)) < 1e-16);
        CHECK(std::fabs(smooth_min(0.002 * i, 2 * k - 0.002 * i, k, BlendFamily::chamfer)) < 1e-16);
    }
}

TEST_CASE("a smooth intersection is the dual of the smooth union") {
    for (const double a : {-0.03, 0.0, 0.02})
        for (const double b : {-0.02, 0.01})
            CHECK(SmoothIntersection<double>{.k = 0.01}.combine(a, b) == -SmoothUnion<double>{.k = 0.01}.combine(-a, -b));
}

TEST_CASE("a lerp goes from its first child to its second, and an inset undoes a rounding of the same size") {
    CHECK(Lerp<double>{.t = 0}.combine(0.3, -0.1) == 0.3);
    CHECK(Lerp<double>{.t = 1}.combine(0.25, -0.125) == -0.125);
    CHECK(Lerp<double>{.t = 0.25}.combine(0.25, -0.25) == 0.125);
    CHECK(Inset<double>{.distance = 0.25}.modify(Round<double>{.radius = 0.25}.modify(0.125)) == 0.125);
}

TEST_CASE("the copies of a repetition stand about the child's own place") {
    const Repeat<double> grid{.count = {3, 2}, .step = {0.25, 0.5}};
    const std::vector<Similarity> images = grid.images();
    REQUIRE(images.size() == 6);
    CHECK(images[0] * Vec2(0, 0) == Vec2(-0.25, -0.25));
    CHECK(images[4] * Vec2(0, 0) == Vec2(0, 0.25));
}

TEST_CASE("a smooth difference is the smooth union of the complement, complemented") {
    const SmoothUnion<double> add{.k = 0.01};
    const SmoothDifference<double> cut{.k = 0.01};
    for (const double a : {-0.03, 0.0, 0.02})
        for (const double b : {-0.02, 0.01}) CHECK(cut.combine(a, b) == -add.combine(-a, b));
    CHECK(cut.combine(0.02, -0.02) == Approx(0.03));
}

TEST_CASE("every smooth operation hands its family and its steps on") {
    const double k = 0.01;
    for (int i = 0; i < 7; ++i)
        for (const int steps : {1, 3, 6}) {
            const auto family = static_cast<BlendFamily>(i);
            CAPTURE(at(choice_names(family), i), steps);
            for (const double a : {-0.012, 0.0, 0.003})
                for (const double b : {-0.009, 0.001}) {
                    CHECK(SmoothUnion<double>{k, family, steps}.combine(a, b) == smooth_min(a, b, k, family, steps));
                    CHECK(SmoothIntersection<double>{k, family, steps}.combine(a, b) == -smooth_min(-a, -b, k, family, steps));
                    CHECK(SmoothDifference<double>{k, family, steps}.combine(a, b) == -smooth_min(-a, b, k, family, steps));
                }
        }
}

TEST_CASE("where two fields tie, a smooth union's weights are one half each") {
    const SmoothUnion<Dual> blend{.k = Dual(0.01)};
    const Dual f = blend.combine(Dual(0.003, 1, 0), Dual(0.003, 0, 1));
    CHECK(f.dx == Approx(0.5));
    CHECK(f.dy == Approx(0.5));
}

TEST_CASE("rounding twice is rounding by the sum, and onions stack") {
    for (const double d : {-0.02, 0.0, 0.03}) {
        CHECK(Round<double>{.radius = 0.01}.modify(Round<double>{.radius = 0.02}.modify(d)) ==
              Approx(Round<double>{.radius = 0.03}.modify(d)).margin(1e-17));
        CHECK(Onion<double>{.thickness = 0.01}.modify(d) == std::fabs(d) - 0.005);
    }
}

TEST_CASE("quarter turns of a polar repetition are exact, and mirror images lie where they should") {
    const std::vector<Similarity> images = RepeatPolar<double>{.count = 4}.images();
    REQUIRE(images.size() == 4);
    CHECK(images[1] * Vec2(1, 2) == Vec2(-2, 1));
    CHECK(images[2] * Vec2(1, 2) == Vec2(-1, -2));
    CHECK(images[3] * Vec2(1, 2) == Vec2(2, -1));
    CHECK(Mirror<double>{.across = Axis::x}.images()[1] * Vec2(1, 2) == Vec2(-1, 2));
    CHECK(Mirror<double>{.across = Axis::y}.images()[1] * Vec2(1, 2) == Vec2(1, -2));
}

}  // namespace pinfield::sdf

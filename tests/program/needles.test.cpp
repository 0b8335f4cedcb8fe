// Traced boundaries at sharp corners, where a hair aside is far along: against closed forms and bisection.
#include <catch2/catch.hpp>

#include <cmath>

#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/program/evaluate.h"
#include "engine/program/trace.h"
#include "engine/program/tree.h"
#include "engine/sdf/piece.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

/// One solid about the origin.
struct Alone {
    ProgramPtr program;
    int index = 0;

    explicit Alone(const std::function<void(Scene&)>& fill) {
        Scene scene(catalog());
        set(scene.table(), "size", Vec2(4, 4));
        fill(scene);
        program = compiled(scene);
        index = first_shape(*program);
    }
    const Field& field() const { return program->fixed; }
    const Solid& solid() const { return at(field().solids, index); }
    double distance(const Vec2& p) const { return nearest_of_solid(field(), index, p).distance; }
    double formula(const Vec2& p) const { return tree_value(field(), solid().root, p); }

    double to_pieces(const Vec2& p) const {
        double best = infinity;
        for (int i = 0; i < solid().piece_count; ++i)
            best = std::min(best, squared_distance_to_piece(at(field().pieces, solid().first_piece + i).piece, p));
        return std::sqrt(best);
    }
    /// Where the outline crosses the way from a solid place to a free one.
    Vec2 outline_between(const Vec2& within, const Vec2& beyond) const {
        double lo = 0, hi = 1;
        for (int i = 0; i < 80; ++i) (formula(within + 0.5 * (lo + hi) * (beyond - within)) < 0 ? lo : hi) = 0.5 * (lo + hi);
        return within + lo * (beyond - within);
    }
};

/// Two ellipses across each other: a lens with its tips on the x axis, pointed the more the nearer `share` is to 1.
struct EllipticLens {
    static constexpr double a = 0.6, b = 0.3;
    double share;

    double tip() const { return a * std::sqrt(1 - share * share); }
    double half_angle() const { return std::atan2(b * std::sqrt(1 - share * share), a * share); }  // between a side and the x axis
    Vec2 top(double x) const { return {x, b * std::sqrt(1 - x * x / (a * a)) - share * b}; }
    Vec2 normal(double x) const { return Vec2(x / (a * a), (top(x).y() + share * b) / (b * b)).normalized(); }
    Alone solid(double turn) const {
        return Alone([&](Scene& scene) {
            const NodeId both = add(scene, "intersection", {}, {{"turn", turn}});
            for (const double side : {1.0, -1.0}) add(scene, "ellipse", both, {{"radii", Vec2(a, b)}, {"at", Vec2(0, side * share * b)}});
        });
    }
};

Vec2 turned(double degrees, const Vec2& p) {
    const SineCosine turn = sine_cosine(radians(degrees));
    return {turn.cosine * p.x() - turn.sine * p.y(), turn.sine * p.x() + turn.cosine * p.y()};
}

}  // namespace

TEST_CASE("distances to a lens of two ellipses are right beside it and round its tips, however sharp they are") {
    for (const double share : {0.5, 0.9, 0.99, 0.999})
        for (const double turn : {0.0, 33.0}) {
            INFO("share " << share << ", turned " << turn);
            const EllipticLens lens{share};
            const Alone alone = lens.solid(turn);
            REQUIRE(alone.solid().lowered);
            const double size = 2 * EllipticLens::a, half_angle = lens.half_angle();
            CounterRng rng(1);
            for (int i = 0; i < 200; ++i) {
                const double apart = std::pow(10, rng.in(-9, -1)) * lens.tip(), x = lens.tip() * (1 - std::pow(10, rng.in(-8, 0)));
                INFO(apart << " metres away");
                CHECK(std::fabs(alone.distance(turned(turn, lens.top(x) + apart * lens.normal(x))) - apart) < 1e-9 * size);
                const double way = rng.in(-0.99, 0.99) * (0.5 * pi - half_angle);
                const Vec2 round_tip = Vec2(lens.tip(), 0) + apart * Vec2(std::cos(way), std::sin(way));
                CHECK(std::fabs(alone.distance(turned(turn, round_tip)) - apart) < 1e-9 * size);
            }
            // The sides are where they were fitted to; two lines a hair aside meet a hair aside, over the sine of their angle.
            for (int i = 0; i <= 200; ++i) {
                const Vec2 p = lens.top(lens.tip() * (1 - std::pow(10, -0.07 * i)));
                CHECK(alone.to_pieces(turned(turn, p)) < alone.solid().fit_error / std::sin(2 * half_angle));
            }
        }
}

TEST_CASE("the boundary of a blended lens follows its zero line into the tips") {
    for (const char* family : {"chamfer", "quadratic", "circular"})
        for (const double degrees : {90.0, 30.0, 5.0}) {
            INFO(family << ", two discs that meet at " << degrees << " degrees");
            const double disc = 0.5, half = radians(0.5 * degrees), thick = disc * (1 - std::cos(half));
            const Alone alone([&](Scene& scene) {
                const NodeId both = add(scene, "smooth_intersection", {}, {{"k", 0.2 * thick}, {"family", std::string(family)}});
                for (const double side : {1.0, -1.0})
                    add(scene, "circle", both, {{"radius", disc}, {"at", Vec2(0, side * disc * std::cos(half))}});
            });
            REQUIRE(alone.solid().lowered);
            const Vec2 tip = alone.outline_between({0, 0}, {1, 0});
            CHECK(alone.to_pieces(tip) < alone.solid().fit_error);
            for (int i = 0; i <= 400; ++i) {
                const double x = tip.x() * (1 - std::pow(10, -0.03 * i));
                const Vec2 p = alone.outline_between({x, 0}, {x, 1});
                INFO("at " << p.x() << ", " << p.y());
                CHECK(alone.to_pieces(p) < alone.solid().fit_error);
                CHECK(alone.to_pieces({-p.x(), -p.y()}) < alone.solid().fit_error);
            }
            for (int i = 0; i < alone.solid().piece_count; ++i) {  // and leads nowhere else
                const sdf::Piece& piece = at(alone.field().pieces, alone.solid().first_piece + i).piece;
                const Vec2 q = piece.a.cwiseAbs();
                const double x = std::min(q.x(), tip.x()), y = std::min(q.y(), 0.5 * thick);
                const Vec2 above = alone.outline_between({x, 0}, {x, 1}), beside = alone.outline_between({0, y}, {1, y});
                CHECK(std::min(length(q - above), length(q - beside)) < alone.solid().fit_error);
            }
        }
}

TEST_CASE("an ellipse a hundred times as long as wide is traced to its claim, vertices included") {
    const double a = 0.5, b = 0.005;
    const Alone alone([&](Scene& scene) { add(scene, "ellipse", {}, {{"radii", Vec2(a, b)}}); });
    REQUIRE(alone.solid().lowered);
    for (int i = 0; i <= 4000; ++i) {
        const double angle = two_pi * i / 4000;
        REQUIRE(alone.to_pieces({a * std::cos(angle), b * std::sin(angle)}) < trace_tolerance * 2 * a);
    }
}

// Newton's iteration goes to and fro between the sides of a narrow nook, and where it happened to begin was the boundary found or not.
TEST_CASE("a wall that closes on itself in a narrow nook is traced whichever way it lies") {
    double depth = 0;
    for (int turn = 0; turn < 360; turn += 15) {
        INFO("turned " << turn);
        const Alone alone([&](Scene& scene) {
            add(scene, "cubic_bezier", {},
                {{"a", Vec2(0.012007191440110535, 0.013353335353879555)}, {"b", Vec2(0.07038226640534798, -0.024935313596926755)},
                 {"c", Vec2(0.0336039211370335, 0.028593012807005783)}, {"d", Vec2(0.01723758763453054, 0.07883460996585794)},
                 {"thickness", 0.024525368190444482}, {"turn", 1.0 * turn}});
        });
        REQUIRE(alone.solid().lowered);
        const double here = alone.distance(turned(turn, {0.0348368, 0.0184968}));
        if (turn == 0) depth = here;
        CHECK(here == Approx(-0.0067072).margin(1e-6));  // of a search over 12000 points of the offset curves
        CHECK(here == Approx(depth).margin(1e-11));
    }
}

// Stirring keeps every point's distance from the middle, so that the stirred outline has a closed form.
TEST_CASE("a star that is twisted until its tips are needles is traced to their ends") {
    const double outer = 0.2, stirred = 90;
    for (const double inner : {0.1, 0.05})
        for (const double radius : {0.2, 0.25, 0.3}) {
            INFO("inner " << inner << ", stirred within " << radius);
            const Alone alone([&](Scene& scene) {
                const NodeId twist = add(scene, "twist", {}, {{"angle", stirred}, {"radius", radius}});
                add(scene, "star", twist, {{"outer", outer}, {"inner", inner}});
            });
            REQUIRE(alone.solid().lowered);
            const auto stir = [&](const Vec2& q) {
                const double left = std::max(1 - dot(q, q) / (radius * radius), 0.0);
                return turned(stirred * left * left, q);
            };
            const double needle = 8;  // one over the sine of the narrowest tip's angle, and more
            for (int arm = 0; arm < 5; ++arm)
                for (const double side : {36.0, -36.0}) {
                    const Vec2 tip = turned(72 * arm, {outer, 0}), notch = turned(72 * arm + side, {inner, 0});
                    for (int i = 0; i <= 400; ++i) {
                        const Vec2 p = stir(tip + std::pow(0.001 * i * 2.5, 4) * (notch - tip));
                        INFO("arm " << arm << ", " << i << " of the way to the notch at " << side);
                        CHECK(alone.to_pieces(p) < (i < 80 ? needle : 1) * alone.solid().fit_error);
                    }
                }
            for (int i = 0; i < alone.solid().piece_count; ++i)  // and leads nowhere else
                CHECK(std::fabs(alone.formula(at(alone.field().pieces, alone.solid().first_piece + i).piece.a)) <
                      alone.solid().fit_error);
        }
}

// Twelve traced walls that cross each other anyhow: where cutting them leaves a gap, the formula is what is left to trust.
TEST_CASE("a fitted boundary has no gap, however many traced walls cross", "[slow]") {
    for (const double turn : {-96.71, 0.0, 30.0}) {
        INFO("turned " << turn);
        const Alone alone([&](Scene& scene) {
            const NodeId mirror = add(scene, "mirror", {}, {{"at", Vec2(0.01161, -0.01243)}, {"turn", turn}});
            add(scene, "cubic_bezier", add(scene, "repeat_polar", mirror, {{"at", Vec2(-0.01823, 0.002164)}, {"count", std::int64_t{6}}}));
        });
        const Solid& solid = alone.solid();
        std::size_t open = 0;
        for (int i = 0; i < solid.piece_count; ++i) {
            const sdf::Piece& piece = at(alone.field().pieces, solid.first_piece + i).piece;
            double gap = piece.is_full_circle() ? 0 : infinity;
            for (int k = 0; k < solid.piece_count && gap > 1e-6; ++k)
                gap = std::min(gap, length(at(alone.field().pieces, solid.first_piece + k).piece.a - piece.b));
            open += gap > 1e-6;
        }
        CHECK(open == 0);
        CounterRng rng(3);
        for (int i = 0; i < 300; ++i) {  // on the zero line itself the distance is 0
            const double angle = rng.in(0, two_pi);
            Vec2 within(0, 0), beyond = 0.2 * Vec2(std::cos(angle), std::sin(angle));
            if (!(alone.formula(beyond) > 0)) continue;
            for (int step = 0; step < 200 && alone.formula(within) >= 0; ++step) within = beyond * (step / 200.0) * rng.uniform();
            if (!(alone.formula(within) < 0)) continue;
            CHECK(std::fabs(alone.distance(alone.outline_between(within, beyond))) < 1e-7);
        }
    }
}

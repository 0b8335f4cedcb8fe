#include "engine/sdf/piece.h"

#include <catch2/catch.hpp>

#include <vector>

#include "engine/core/rng.h"
#include "engine/core/trig.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {
namespace {

Vec2 random_point(CounterRng& random, double lo, double hi) {
    const double x = random.in(lo, hi);
    return {x, random.in(lo, hi)};
}

/// A segment, or an arc that runs either way by 1 to 359 degrees.
struct RandomPiece {
    Piece piece;
    double from, sweep;  // degrees, of an arc: counter-clockwise from its first end

    explicit RandomPiece(CounterRng& random) : from(random.in(-180, 180)), sweep(random.in(1, 359)) {
        const Vec2 a = random_point(random, -1, 1), b = random_point(random, -1, 1);
        const double r = random.in(0.1, 1);
        const int turn = random.uniform() < 0.5 ? 1 : -1;
        const auto on = [&](double angle) { return Vec2(a + r * Vec2(cosine_degrees(angle), sine_degrees(angle))); };
        const Vec2 first = on(from), last = on(from + sweep);
        piece = random.uniform() < 0.3 ? Piece::segment(a, b)
                                       : Piece::arc(a, r, turn > 0 ? first : last, turn > 0 ? last : first, turn, sweep > 180);
    }
    /// At a share of its way from a to b.
    Vec2 at(double share) const {
        if (!piece.is_arc()) return piece.a + share * (piece.b - piece.a);
        const double angle = from + sweep * (piece.turn > 0 ? share : 1 - share);
        return piece.centre + piece.radius * Vec2(cosine_degrees(angle), sine_degrees(angle));
    }
};

/// test(random piece) many times over.
template <class Test>
void for_pieces(const Test& test) {
    CounterRng random(8);
    for (int i = 0; i < 2000; ++i) {
        const RandomPiece drawn(random);
        INFO((drawn.piece.is_arc() ? "arc of " : "segment ") << drawn.sweep << " degrees, turn " << drawn.piece.turn);
        test(drawn, random);
    }
}

}  // namespace

TEST_CASE("a packed outline is unpacked as it was, arcs of more than half a turn in two") {
    CounterRng random(21);
    for (int i = 0; i < 200; ++i) {
        Outline outline;
        for (int k = 0; k < 5; ++k) outline.push_back(RandomPiece(random).piece);
        const Vec2 centre = random_point(random, -1, 1);
        const double radius = random.in(0.1, 1);
        outline.push_back(Piece::circle(centre, radius, i % 2 ? 1 : -1));
        const Outline back = unpacked_outline(found_outline_block(outline).data());
        std::size_t next = 0;
        for (const Piece& piece : outline) {
            const bool halves = piece.reflex && !piece.is_full_circle();
            const Piece &first = back.at(next), &last = back.at(next + (halves ? 1 : 0));
            next += halves ? 2 : 1;
            CHECK(first.a == piece.a);
            CHECK(last.b == piece.b);
            CHECK(last.turn == piece.turn);
            CHECK(last.is_full_circle() == piece.is_full_circle());
            if (piece.is_arc()) CHECK(length(last.centre - piece.centre) < 1e-12);
            if (piece.is_arc()) CHECK(last.radius == Approx(piece.radius).epsilon(1e-12));
        }
        CHECK(next == back.size());
    }
}

TEST_CASE("a piece and its reflection, its quarter turn and its reverse have the same distances bit for bit") {
    CounterRng random(6);
    for (int i = 0; i < 3000; ++i) {
        const Vec2 a = random_point(random, -1, 1), b = random_point(random, -1, 1), p = random_point(random, -2, 2),
                   c = random_point(random, -1, 1);
        const double from = random.in(-180, 180), sweep = random.in(1, 359), r = random.in(0.1, 1);
        const auto on = [&](double angle) { return Vec2(c + r * Vec2(cosine_degrees(angle), sine_degrees(angle))); };
        const Piece pieces[] = {Piece::segment(a, b),
                                     Piece::arc(c, r, on(from), on(from + sweep), 1, sweep > 180)};
        for (const Piece& piece : pieces) {
            const auto [foot, d, interior, inside, normal] = foot_on_piece(piece, p);
            const auto map = [](const Piece& q, auto&& f, bool reverses) {
                Piece out = q;
                out.a = f(reverses ? q.b : q.a);
                out.b = f(reverses ? q.a : q.b);
                out.centre = f(q.centre);
                return out;
            };
            const auto mirror = [](const Vec2& v) { return Vec2(-v.x(), v.y()); };
            const auto quarter = [](const Vec2& v) { return Vec2(-v.y(), v.x()); };
            const PieceFoot mirrored = foot_on_piece(map(piece, mirror, true), mirror(p));
            REQUIRE(mirrored.distance == d);
            REQUIRE(mirrored.foot == mirror(foot));
            const PieceFoot turned = foot_on_piece(map(piece, quarter, false), quarter(p));
            REQUIRE(turned.distance == d);
            REQUIRE(turned.foot == quarter(foot));
            REQUIRE(foot_on_piece(reversed(piece), p).distance == d);
            REQUIRE(std::fabs(squared_distance_to_piece(piece, p) - d * d) < 1e-14);
        }
    }
}

TEST_CASE("the nearest of many points along a piece is no nearer than the piece, and hardly farther") {
    for_pieces([](const RandomPiece& drawn, CounterRng& random) {
        const Vec2 p = random_point(random, -2, 2);
        double least = infinity;
        for (int k = 0; k <= 400; ++k) least = std::min(least, length(p - drawn.at(k / 400.0)));
        const double found = distance_to_piece(drawn.piece, p);
        REQUIRE(found <= least + 1e-12);
        REQUIRE(found >= least - 0.02);  // half of the widest step
        const PieceFoot foot = foot_on_piece(drawn.piece, p);
        REQUIRE(std::fabs(foot.distance - found) < 1e-12);
        REQUIRE(std::fabs(length(p - foot.foot) - found) < 1e-12);
    });
}

TEST_CASE("an arc sweeps the directions between its ends and no others") {
    for_pieces([](const RandomPiece& drawn, CounterRng& random) {
        if (!drawn.piece.is_arc()) return;
        const double share = random.in(-0.5, 1.5), beyond = (share < 0 ? -share : share - 1) * drawn.sweep;
        if (beyond > 360 - drawn.sweep - 1e-6 || std::fabs(beyond) < 1e-6) return;  // round to the other end, or on an end
        REQUIRE(in_sweep(drawn.piece, drawn.at(share) - drawn.piece.centre) == (share >= 0 && share <= 1));
    });
}

TEST_CASE("a piece's middle is halfway along, and its direction there and at its ends is that of travel") {
    for_pieces([](const RandomPiece& drawn, CounterRng&) {
        const Piece& piece = drawn.piece;
        REQUIRE(length(middle_of(piece) - drawn.at(0.5)) < 1e-12);
        for (const double share : {0.0, 0.5, 1.0}) {
            const Vec2 step = drawn.at(share + 1e-6) - drawn.at(share - 1e-6);
            REQUIRE(length(direction_at(piece, drawn.at(share)) - step / length(step)) < 1e-8);
        }
        if (piece.is_arc() && drawn.sweep < 179) REQUIRE(length(point_at_share(piece, 0.5) - drawn.at(0.5)) < 1e-9);
    });
}

TEST_CASE("positions along a piece grow from its start to its end") {
    for_pieces([](const RandomPiece& drawn, CounterRng&) {
        for (int k = 1; k < 40; ++k)
            REQUIRE(position_along(drawn.piece, drawn.at(k / 40.0)) > position_along(drawn.piece, drawn.at((k - 1) / 40.0 + 1e-9)));
    });
}

TEST_CASE("the parts of a piece lie on it, cover it and leave each other free") {
    for_pieces([](const RandomPiece& drawn, CounterRng& random) {
        const double share = random.in(0.05, 0.95);
        const Vec2 cut = drawn.at(share);
        const Piece first = part_of(drawn.piece, drawn.piece.a, cut), second = part_of(drawn.piece, cut, drawn.piece.b);
        for (int k = 0; k <= 40; ++k) {
            const Vec2 p = drawn.at(k / 40.0);
            const bool in_first = k / 40.0 < share;
            REQUIRE(distance_to_piece(in_first ? first : second, p) < 1e-9);
            if (std::fabs(k / 40.0 - share) > 0.01) REQUIRE(distance_to_piece(in_first ? second : first, p) > 1e-6);
            REQUIRE(distance_to_piece(drawn.piece, p) < 1e-9);
        }
    });
}

TEST_CASE("a piece seen in another frame is as far from a point seen there, in its scale, and keeps its sides") {
    for_pieces([](const RandomPiece& drawn, CounterRng& random) {
        const double angle = random.in(0, 360);
        const Similarity to_from{cosine_degrees(angle), sine_degrees(angle), random.in(0.5, 2), random.uniform() < 0.5,
                                 random_point(random, -1, 1)};
        const Vec2 p = random_point(random, -2, 2);
        const PieceFoot here = foot_on_piece(drawn.piece, p), there = foot_on_piece(transformed(to_from, drawn.piece), to_from * p);
        REQUIRE(std::fabs(there.distance - to_from.scale * here.distance) < 1e-11);
        if (here.distance > 1e-6 && here.interior && there.interior) REQUIRE(here.inside == there.inside);
    });
}

TEST_CASE("the box of a piece and its greatest distance from the origin are those of its points") {
    for_pieces([](const RandomPiece& drawn, CounterRng&) {
        Box2 box;
        double farthest = 0;
        for (int k = 0; k <= 2000; ++k) {
            box = box.including(drawn.at(k / 2000.0));
            farthest = std::max(farthest, length(drawn.at(k / 2000.0)));
        }
        const Box2 found = bounds_of(drawn.piece);
        REQUIRE(found.grown(1e-12).contains(box.lo));
        REQUIRE(found.grown(1e-12).contains(box.hi));
        REQUIRE(length(found.lo - box.lo) + length(found.hi - box.hi) < 1e-4);
        REQUIRE(farthest_from_origin(drawn.piece) >= farthest - 1e-12);
        REQUIRE(farthest_from_origin(drawn.piece) < farthest + 1e-4);
    });
}

TEST_CASE("the area between an arc and its chord is that between the chord and many small ones") {
    for_pieces([](const RandomPiece& drawn, CounterRng&) {
        if (!drawn.piece.is_arc()) return;
        double area = 0;
        for (int k = 0; k < 2000; ++k)
            area += 0.5 * cross(Vec2(drawn.at(k / 2000.0) - drawn.piece.a), Vec2(drawn.at((k + 1) / 2000.0) - drawn.piece.a));
        REQUIRE(std::fabs(area_beside_chord(drawn.piece) - area) < 1e-4);
    });
}

}  // namespace pinfield::sdf

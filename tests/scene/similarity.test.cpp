#include <catch2/catch.hpp>

#include "engine/core/geometry.h"
#include "engine/core/rng.h"
#include "engine/core/trig.h"

using namespace pinfield;

namespace {

Similarity some_similarity(CounterRng& rng) {
    const double angle = rng.in(-720, 720);
    return {cosine_degrees(angle), sine_degrees(angle), rng.in(0.1, 10), rng.uniform() < 0.5,
            Vec2{rng.in(-3, 3), rng.in(-3, 3)}};
}
Vec2 some_point(CounterRng& rng) { return {rng.in(-5, 5), rng.in(-5, 5)}; }

bool near(const Vec2& a, const Vec2& b, double tolerance) { return length(a - b) <= tolerance; }

}  // namespace

TEST_CASE("composing frames is applying one after the other") {
    CounterRng rng(1);
    for (int i = 0; i < 1000; ++i) {
        const Similarity world_from_a = some_similarity(rng), a_from_b = some_similarity(rng);
        const Vec2 p = some_point(rng), d = some_point(rng);
        const Similarity world_from_b = world_from_a * a_from_b;
        CHECK(near(world_from_b * p, world_from_a * (a_from_b * p), 1e-12 * 1000));
        CHECK(near(world_from_b.direction(d), world_from_a.direction(a_from_b.direction(d)), 1e-13 * 10));
    }
}

TEST_CASE("a similarity and its inverse cancel from both sides") {
    CounterRng rng(2);
    for (int i = 0; i < 1000; ++i) {
        const Similarity world_from_a = some_similarity(rng);
        const Vec2 p = some_point(rng);
        CHECK(near(world_from_a.inverse() * (world_from_a * p), p, 1e-11));
        CHECK(near(world_from_a * (world_from_a.inverse() * p), p, 1e-11));
    }
}

TEST_CASE("a similarity scales every distance by its scale and keeps or flips orientation") {
    CounterRng rng(3);
    for (int i = 0; i < 1000; ++i) {
        const Similarity s = some_similarity(rng);
        const Vec2 a = some_point(rng), b = some_point(rng), c = some_point(rng);
        CHECK(length(s * a - s * b) == Approx(s.scale * length(a - b)).epsilon(1e-12));
        CHECK(length(s.direction(a)) == Approx(length(a)).epsilon(1e-12));
        const double before = cross(b - a, c - a), after = cross(s * b - s * a, s * c - s * a);
        CHECK((after > 0) == ((before > 0) != s.mirrored));
    }
}

TEST_CASE("the image of a box holds the image of every point in it") {
    CounterRng rng(4);
    for (int i = 0; i < 300; ++i) {
        const Similarity s = some_similarity(rng);
        const Box2 box = Box2::of(some_point(rng), some_point(rng)), image = (s * box).grown(1e-12);
        for (int k = 0; k < 20; ++k)
            CHECK(image.contains(s * Vec2{rng.in(box.lo.x(), box.hi.x()), rng.in(box.lo.y(), box.hi.y())}));
    }
}

TEST_CASE("whole quarter turns are exact") {
    const Similarity quarter{cosine_degrees(90), sine_degrees(90), 1, false, {0, 0}};
    CHECK(quarter * Vec2(1, 2) == Vec2(-2, 1));
    CHECK((quarter * quarter * quarter * quarter) * Vec2(1, 2) == Vec2(1, 2));
}

#include "engine/program/pose.h"

#include <catch2/catch.hpp>

#include "engine/core/trig.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

/// A flipper and a plunger, turned, scaled and mirrored at will.
ProgramPtr movers(double turn, double scale, bool mirrored) {
    Scene scene(catalog());
    for (const char* part : {"flipper", "plunger"})
        add(scene, part, {}, {{"at", Vec2(0.3, 0.4)}, {"turn", turn}, {"scale", scale}, {"flip", std::string(mirrored ? "y" : "none")}});
    return compiled(scene);
}

Vec2 place(const Pose& pose, const Vec2& m) { return pose.to_world(m) + pose.offset; }

/// visit(mover) for every kind of frame.
template <class Visit>
void for_movers(const Visit& visit) {
    for (const double turn : {0.0, 35.0, -120.0})
        for (const double scale : {1.0, 1.5})
            for (const bool mirrored : {false, true}) {
                const ProgramPtr program = movers(turn, scale, mirrored);
                for (const Mover& mover : program->movers) {
                    INFO("turn " << turn << ", scale " << scale << (mirrored ? ", mirrored" : "") << (mover.slides ? ", slides" : ""));
                    visit(mover, program->parts[static_cast<std::size_t>(mover.part)].world_from_part);
                }
            }
}

}  // namespace

TEST_CASE("at 0 a mover stands where its part was put") {
    for_movers([](const Mover& mover, const Similarity& world_from_part) {
        for (const Vec2& p : {Vec2(0, 0), Vec2(0.07, 0), Vec2(0.01, -0.03)}) {
            const Vec2 in_mover = world_from_part.scale * Vec2(p.x(), world_from_part.mirrored ? -p.y() : p.y());
            CHECK(length(place(pose_of(mover, 0), in_mover) - world_from_part * p) < 1e-15);
        }
    });
}

TEST_CASE("a flipper turns by its coordinate, the other way where it is mirrored, and a plunger slides along its own y") {
    for_movers([](const Mover& mover, const Similarity& world_from_part) {
        const double q = 0.3;
        const Pose pose = pose_of(mover, q), start = pose_of(mover, 0);
        if (mover.slides) {
            CHECK(length(pose.offset - start.offset - q * world_from_part.direction({0, 1})) < 1e-15);
            CHECK(pose.to_world({1, 2}) == start.to_world({1, 2}));
        } else {
            const Vec2 tip(cosine(q), sine(q));  // in the part's own frame
            CHECK(length(pose.to_world({1, 0}) - world_from_part.direction(tip)) < 1e-15);
            CHECK(pose.offset == start.offset);
        }
    });
}

TEST_CASE("a mover's points move at the velocity that its pose changes with") {
    for_movers([](const Mover& mover, const Similarity&) {
        for (const double q : {-0.4, 0.0, 0.7})
            for (const double rate : {-3.0, 1.0, 20.0}) {
                const Vec2 m(0.05, 0.02);
                const double step = 1e-6;
                const auto after = [&](double time) { return place(pose_of(mover, q + rate * time), m); };
                const Vec2 difference = (after(step) - after(-step)) / (2 * step);
                CHECK(length(velocity_of(mover, rate, place(pose_of(mover, q), m)) - difference) < 1e-8);
            }
    });
}

TEST_CASE("a mover's similarity is its pose, and a pose leads back from where it leads to") {
    for_movers([](const Mover& mover, const Similarity&) {
        const Pose pose = pose_of(mover, 0.2);
        const Vec2 m(0.03, -0.01), p = place(pose, m);
        CHECK(length(world_from_mover(mover, 0.2) * m - p) < 1e-15);
        CHECK(length(pose.place_from_world(p) - m) < 1e-15);
    });
}

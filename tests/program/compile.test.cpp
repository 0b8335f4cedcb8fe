#include "engine/program/compile.h"

#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/scene/parts/flipper.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

TEST_CASE("a table without a domain is a box of its size, solid outside") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(0.5, 1.0));
    const ProgramPtr program = compiled(scene);
    CHECK(nearest(program->fixed, {0.25, 0.5}).distance == Approx(0.25));
    CHECK(nearest(program->fixed, {0.25, 1.1}).distance == Approx(-0.1));
    CHECK(program->fixed.solids[0].origin == scene.table().id);
}

TEST_CASE("a program holds the catalog that its parts' types are in") {
    ProgramPtr program;
    {
        const auto own = std::make_shared<const Catalog>(built_in_catalog());
        Scene scene(own);
        scene.add(*own->find("flipper"));
        program = compiled(scene);
        CHECK(program->catalog == own);
    }
    CHECK(program->catalog.use_count() == 1);
    CHECK(program->parts[0].type == program->catalog->find("flipper"));
    CHECK(program->parts[0].is<parts::Flipper>());
}

TEST_CASE("gravity in the plane is 9.81 times the sine of the slope, downwards") {
    Scene scene(catalog());
    set(scene.table(), "slope", 30.0);
    CHECK(compiled(scene)->physics.gravity == Vec2(0, -4.905));
}

TEST_CASE("a mirrored flipper is compiled in its own frame, with handedness") {
    Scene scene(catalog());
    scene.inputs.push_back({"left", {"Z"}, {}});
    scene.inputs.push_back({"right", {"M"}, {}});
    add(scene, "flipper", {},
        {{"at", Vec2(0.3, 0.1)}, {"flip", std::string("x")}, {"input", std::vector<std::string>{"right"}}});
    const ProgramPtr program = compiled(scene);
    REQUIRE(program->movers.size() == 1);
    const Mover& mover = program->movers[0];
    const Part& part = at(program->parts, mover.part);
    const auto flipper = part.as<parts::Flipper>();
    CHECK(part.is<parts::Flipper>());
    CHECK(part.inputs == std::vector<int>{1});
    CHECK(part.mover == 0);
    CHECK(mover.pivot == Vec2(0.3, 0.1));
    CHECK(mover.cosine == -1);  // local +x points to the left in the world
    CHECK(mover.handedness == -1);
    CHECK(mover.bounding_radius == Approx(flipper.length + flipper.radius_tip));
    CHECK(nearest_of_solid(mover.field, 0, {flipper.length + 0.1, 0}).distance == Approx(0.1 - flipper.radius_tip));
    CHECK(nearest(program->fixed, {0.28, 0.1}).distance > 0.05);  // a mover is no part of the static field
}

TEST_CASE("sensors never enter the field, and a spawn is only a place") {
    Scene scene(catalog());
    add(scene, "drain", {}, {{"at", Vec2(0.25, 0.3)}, {"size", Vec2(0.1, 0.1)}});
    add(scene, "spawn", {}, {{"at", Vec2(0.2, 0.2)}});
    const ProgramPtr program = compiled(scene);
    CHECK(program->fixed.solids.size() == 1);
    REQUIRE(program->sensors.size() == 1);
    CHECK(nearest_of_solid(program->sensors[0].field, 0, {0.25, 0.3}).distance == Approx(-0.05));
    CHECK(program->parts[1].sensor == -1);
    CHECK(program->parts[1].world_from_part.offset == Vec2(0.2, 0.2));
}

TEST_CASE("layers get bits by name, groups hand theirs down, and each layer has a domain") {
    Scene scene(catalog());
    const NodeId ramp = add(scene, "group", {}, {{"layer", std::vector<std::string>{"ramp"}}});
    add(scene, "circle", ramp, {{"radius", 0.01}, {"at", Vec2(0.2, 0.2)}});
    add(scene, "circle", {}, {{"radius", 0.01}, {"at", Vec2(0.3, 0.2)}});
    const ProgramPtr program = compiled(scene);
    CHECK(program->layers == std::vector<std::string>{"ground", "ramp"});
    CHECK(nearest(program->fixed, {0.2, 0.2}).distance > 0.08);
    CHECK(nearest(program->fixed, {0.2, 0.2}, 2).distance == Approx(-0.01));
    CHECK(nearest(program->fixed, {-0.1, 0.2}, 2).distance == Approx(-0.1));
}

TEST_CASE("what cannot be compiled is refused with its reason") {
    Scene scene(catalog());
    add(scene, "box", {}, {{"size", Vec2(0.1, 0.1)}, {"round", 0.2}});
    add(scene, "union");
    add(scene, "flipper", {}, {{"input", std::vector<std::string>{"nobody"}}});
    for (int i = 0; i < 2; ++i) add(scene, "circle", add(scene, "domain"));
    const auto program = compile(scene);
    REQUIRE_FALSE(program);
    CHECK(program.error().size() == 4);
}

TEST_CASE("no query of any compiled random scene yields a NaN, wherever it is asked") {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Scene scene(catalog());
        RandomTree(scene, seed, true).grow({}, 3);
        const NodeId blend = add(scene, "smooth_union");
        RandomTree(scene, seed + 1000, true).grow(blend, 2);
        RandomTree(scene, seed + 2000, true).grow(blend, 2);
        const ProgramPtr program = compiled(scene);
        for (int x = -20; x <= 20; ++x)
            for (int y = -20; y <= 20; ++y) {  // a grid meets vertices, centres and outlines
                const Nearest n = nearest(program->fixed, Vec2(0.05 * x, 0.05 * y));
                INFO("seed " << seed << " at " << 0.05 * x << ", " << 0.05 * y);
                REQUIRE(std::isfinite(n.distance));
                REQUIRE(n.gradient.allFinite());
                if (n.certified) REQUIRE(length(n.gradient) == Approx(1).epsilon(1e-9));
            }
    }
}

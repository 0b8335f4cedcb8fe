#include "engine/program/evaluate.h"

#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/program/tree.h"
#include "engine/scene/playfield.h"
#include "tests/program/random_construction.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

Vec2 random_point(CounterRng& random, double lo, double hi) {
    const double x = random.in(lo, hi);
    return {x, random.in(lo, hi)};
}

}  // namespace

TEST_CASE("a disc that is turned, flipped, scaled and moved is the disc that arithmetic says") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(100, 100));
    const NodeId group =
        add(scene, "group", {}, {{"at", Vec2(1, 2)}, {"turn", 90.0}, {"scale", 2.0}, {"flip", std::string("x")}});
    add(scene, "circle", group, {{"radius", 0.1}, {"at", Vec2(0.3, 0.4)}});
    const ProgramPtr program = compiled(scene);
    // flip x: (-0.3, 0.4); scale: (-0.6, 0.8); turn: (-0.8, -0.6); at: (0.2, 1.4). Radius 0.2.
    const Nearest n = nearest_of_solid(program->fixed, 0, {0.2, 2.4});
    CHECK(n.distance == Approx(0.8).epsilon(1e-14));
    CHECK(length(n.gradient - Vec2(0, 1)) < 1e-14);
    CHECK(n.certified);
}

TEST_CASE("an L of two overlapping boxes is exact inside, where the smaller of two depths is not") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(10, 10));
    const NodeId both = add(scene, "union");
    add(scene, "box", both, {{"size", Vec2(4, 2)}, {"at", Vec2(4, 3)}});  // [2, 6] x [2, 4]
    add(scene, "box", both, {{"size", Vec2(2, 4)}, {"at", Vec2(3, 4)}});  // [2, 4] x [2, 6]
    const ProgramPtr program = compiled(scene);
    const Nearest inner = nearest(program->fixed, {3.5, 3.5});  // the reflex corner is at (4, 4)
    CHECK(inner.distance == Approx(-std::sqrt(0.5)).epsilon(1e-14));
    CHECK(inner.certified);
    CHECK(tree_value(program->fixed, program->fixed.solids[0].root, {3.5, 3.5}) == Approx(-0.5));
    CHECK(length(inner.gradient - Vec2(std::sqrt(0.5), std::sqrt(0.5))) < 1e-14);
}

TEST_CASE("an intersected corner is a corner and not the mitre of max") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(10, 10));
    const NodeId cut = add(scene, "intersection");
    add(scene, "box", cut, {{"size", Vec2(2, 2)}, {"at", Vec2(4, 4)}});
    add(scene, "box", cut, {{"size", Vec2(2, 2)}, {"at", Vec2(5, 5)}});  // leaves [4, 5] x [4, 5]
    const ProgramPtr program = compiled(scene);
    const Nearest n = nearest(program->fixed, {5.3, 5.4});
    CHECK(n.distance == Approx(0.5).epsilon(1e-14));
    CHECK(length(n.gradient - Vec2(0.6, 0.8)) < 1e-14);
}

TEST_CASE("the material on a cut face is the cutter's") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(10, 10));
    for (const char* name : {"wood", "steel"}) scene.add_material(name);
    const NodeId cut = add(scene, "difference", {}, {{"material", std::string("wood")}});
    add(scene, "box", cut, {{"size", Vec2(4, 2)}, {"at", Vec2(5, 5)}});
    const NodeId hole =
        add(scene, "circle", cut, {{"radius", 0.5}, {"at", Vec2(5, 5)}, {"material", std::string("steel")}});
    const ProgramPtr program = compiled(scene);
    const auto material_at = [&](const Vec2& p) {
        const Nearest n = nearest(program->fixed, p);
        return at(program->materials, at(program->fixed.ops, n.leaf).material).name;
    };
    CHECK(material_at({5.2, 5}) == "steel");
    CHECK(material_at({5.6, 5}) == "steel");  // just inside the wood, the hole's face is nearest
    CHECK(material_at({5, 6.2}) == "wood");
    CHECK(at(program->fixed.ops, nearest(program->fixed, {5.2, 5}).leaf).origin == hole);
}

TEST_CASE("the union of a playfield is the least of its solids, and a search finds it wherever the point lies") {
    const Scene scene = playfield(catalog(), 100);
    const ProgramPtr program = compiled(scene);
    CounterRng random(4);
    int inside = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec2 p = random_point(random, -0.1, 0.8);
        double least = infinity;
        for (std::size_t s = 0; s < program->fixed.solids.size(); ++s)
            least = std::min(least,
                             tree_value(program->fixed, program->fixed.solids[s].root, p));  // all exact: lone shapes
        const Nearest n = nearest(program->fixed, p);
        INFO(p.transpose());
        REQUIRE(n.distance == Approx(least).margin(1e-14));
        REQUIRE(length(n.gradient) == Approx(1).epsilon(1e-12));
        const int first_op = n.solid == 0 ? 0 : program->fixed.solids[static_cast<std::size_t>(n.solid) - 1].root + 1;
        REQUIRE((first_op <= n.leaf && n.leaf <= at(program->fixed.solids, n.solid).root));
        REQUIRE(std::fabs(tree_value(program->fixed, n.leaf, p - n.distance * n.gradient)) < 1e-13);
        inside += least < 0;
        if (least < 0) continue;
        const Nearest outside = nearest_outside(program->fixed, p, ground_layer, 0.05);
        if (least < 0.05)
            REQUIRE(outside.distance == n.distance);
        else
            REQUIRE(outside.solid == -1);
    }
    CHECK(inside > 500);
}

TEST_CASE("inside two solids at once the distance is the greater depth and not certified") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(10, 10));
    add(scene, "circle", {}, {{"radius", 1.0}, {"at", Vec2(4, 5)}});
    add(scene, "circle", {}, {{"radius", 1.0}, {"at", Vec2(5, 5)}});
    const ProgramPtr program = compiled(scene);
    const Nearest both = nearest(program->fixed, {4.6, 5});
    CHECK(both.distance == Approx(-0.6));
    CHECK(both.solid == 1);
    CHECK_FALSE(both.certified);
    CHECK(nearest(program->fixed, {3.5, 5}).certified);  // the way out is free
    CHECK_FALSE(nearest(program->fixed, {3.99, 5}).solid == 1);
}

TEST_CASE("on the outline itself the distance is zero and the gradient points out of the solid") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(10, 10));
    add(scene, "box", {}, {{"size", Vec2(2, 2)}, {"at", Vec2(5, 5)}});
    const ProgramPtr program = compiled(scene);
    const Nearest side = nearest(program->fixed, {6, 5.25});
    CHECK(side.distance == 0);
    CHECK(side.gradient == Vec2(1, 0));
    const Nearest corner = nearest(program->fixed, {6, 6});
    CHECK(corner.distance == 0);
    CHECK(length(corner.gradient) == 1);
    CHECK(nearest(program->fixed, {0, 5}).gradient == Vec2(1, 0));  // the domain's left wall faces right
}

TEST_CASE("a blend is certified where the foot shows that its value is the distance") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(10, 10));
    const NodeId blend = add(scene, "smooth_union", {}, {{"k", 0.05}});
    add(scene, "circle", blend, {{"radius", 0.5}, {"at", Vec2(4, 5)}});
    add(scene, "circle", blend, {{"radius", 0.5}, {"at", Vec2(4.9, 5)}});
    const ProgramPtr program = compiled(scene);
    const Nearest far = nearest_of_solid(program->fixed, 0, {3.2, 5});  // left of the left disc, where nothing blends
    CHECK(far.certified);
    CHECK(far.distance == Approx(0.3));
    const Nearest between = nearest_of_solid(program->fixed, 0, {4.45, 7});
    CHECK_FALSE(between.certified);
}

TEST_CASE("a solid is never nearer than its box, however far its formula may under-estimate") {
    Scene scene(catalog());
    set(scene.table(), "size", Vec2(10, 10));
    const NodeId twist = add(scene, "twist", {}, {{"at", Vec2(5, 5)}, {"angle", 170.0}, {"radius", 1.0}});
    add(scene, "box", twist, {{"size", Vec2(1.8, 0.3)}});
    const ProgramPtr program = compiled(scene);
    const Solid& solid = program->fixed.solids[0];
    CounterRng random(4);
    int formula_falls_short = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec2 p = random_point(random, 2, 8);
        const double to_box = solid.bounds.distance(p);
        if (to_box == 0) continue;
        formula_falls_short += evaluate_tree(program->fixed, solid.root, p).value < 0.9 * to_box;
        CHECK(nearest_of_solid(program->fixed, 0, p).distance >= to_box - 1e-12);
        const Nearest n = nearest_outside(program->fixed, p, ground_layer, 1.5);
        if (n.solid == 0) CHECK(n.distance >= to_box - 1e-12);
        CHECK(nearest(program->fixed, p, ground_layer, 1.5).distance <= 1.5);
        const double h = 1e-7;  // the gradient that comes with it is its own
        const Nearest here = nearest_of_solid(program->fixed, 0, p), along = nearest_of_solid(program->fixed, 0, p + h * here.gradient);
        CHECK(along.distance - here.distance == Approx(h * here.gradient.squaredNorm()).epsilon(1e-3));
    }
    CHECK(formula_falls_short > 100);
}

TEST_CASE("where a distance is certified its gradient is a unit vector, on the surface of what is warped or blended, too") {
    int certified = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Scene scene(catalog());
        set(scene.table(), "size", Vec2(2, 2));
        const NodeId top = RandomConstruction(scene, seed, 0.02).grow({}, 1 + static_cast<int>(seed % 3));
        set(*scene.find(top), "at", Vec2(1, 1));
        const ProgramPtr program = compiled(scene);
        const Field& field = program->fixed;
        if (field.solids[0].is_domain || !field.solids[0].bounds.is_finite()) continue;
        const Box2 around = field.solids[0].bounds.grown(0.05);
        CounterRng random(seed, 5);
        for (int i = 0; i < 300; ++i) {
            const double x = random.in(around.lo.x(), around.hi.x());
            Vec2 p(x, random.in(around.lo.y(), around.hi.y()));
            for (int step = 0; step < 3; ++step) {  // nearer and nearer to the surface
                const Nearest here = nearest_of_solid(field, 0, p);
                INFO("seed " << seed << " at " << p.transpose());
                certified += here.certified;
                if (here.certified && length(here.gradient) > 0) REQUIRE(length(here.gradient) == Approx(1).epsilon(1e-6));
                p -= here.distance * here.gradient;
            }
        }
    }
    CHECK(certified > 1000);
}

TEST_CASE("on the tip of a disc stretched to twice its width the certified gradient is one, as everywhere") {
    Scene scene(catalog());
    const NodeId stretch = add(scene, "stretch", {}, {{"by", Vec2(2, 1)}});
    add(scene, "circle", stretch, {{"radius", 0.1}});
    const ProgramPtr program = compiled(scene);
    const Nearest tip = nearest_of_solid(program->fixed, 0, {0.2, 0});
    CHECK(tip.certified);
    CHECK(tip.gradient == Vec2(1, 0));
}

// The box of a solid holds all of it.
#include <catch2/catch.hpp>

#include "engine/program/evaluate.h"
#include "engine/program/tree.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

void check_box(const Field& field, int op, double around) {
    const Box2& box = at(field.ops, op).bounds;
    for (int i = 0; i <= 300; ++i)
        for (int j = 0; j <= 300; ++j) {
            const Vec2 p = around * Vec2(i / 150.0 - 1, j / 150.0 - 1);
            if (tree_value(field, op, p) >= 0) continue;
            INFO("solid at " << p.x() << ", " << p.y() << ", outside of the box by " << box.distance(p));
            REQUIRE(box.grown(1e-12).contains(p));
        }
}

/// Of each kind, bent, stretched or waved so much that the field is divided by two and more.
NodeId add_warp(Scene& scene, std::string_view key, NodeId parent) {
    const NodeId id = add(scene, key, parent);
    Node& node = *scene.find(id);
    if (key == "displace") set(node, "amplitude", 0.02), set(node, "wavelength", Vec2(0.05, 0.05));
    if (key == "stretch") set(node, "by", Vec2(3.0, 0.5));
    if (key == "twist") set(node, "angle", 200.0);
    return id;
}

}  // namespace

TEST_CASE("a blend of warps or formulas lies in its box, however far it reaches out of theirs") {
    for (const char* warp : {"displace", "stretch", "twist", "bend", "elongate", "formula"})
        for (const char* between : {"", "union", "mirror", "smooth_union"}) {
            INFO(warp << " below " << between);
            Scene scene(catalog());
            const NodeId blend = add(scene, "smooth_union", {}, {{"k", 0.04}, {"scale", 1.5}});
            for (int i = 0; i < 2; ++i) {  // two alike, so that the blend adds as much as it can
                const NodeId parent = *between ? add(scene, between, blend) : blend;
                if (warp == std::string_view("formula"))  // flat in one direction, for the sake of the other
                    add(scene, "formula", parent, {{"distance", "max(abs(x) - 10cm, 12 * (abs(y) - 5cm))"}, {"bounds", Vec2(0.8, 0.3)}, {"at", Vec2(0.05, 0.01)}});
                else add(scene, "box", add_warp(scene, warp, parent), {{"size", Vec2(0.2, 0.1)}, {"at", Vec2(0.05, 0.01)}});
            }
            const ProgramPtr program = compiled(scene);
            const Solid& solid = program->fixed.solids[static_cast<std::size_t>(first_shape(*program))];
            check_box(program->fixed, solid.root, 1.2);
        }
}

#include "engine/program/distance_quality.h"

#include <catch2/catch.hpp>

#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

constexpr Exactness outside_only{.inside = Side::bound}, inside_only{.outside = Side::bound}, neither{Side::bound, Side::bound};

/// The quarter plane right of and below the origin, or its complement's kind: half planes have no outline of lines and arcs.
NodeId wedge(Scene& scene, std::string_view operation, NodeId parent) {
    const NodeId both = add(scene, operation, parent);
    add(scene, "half_plane", both);
    add(scene, "half_plane", both, {{"turn", 90.0}});
    return both;
}

}  // namespace

TEST_CASE("a node's trust is that of its formula over its children, and its boundary's where that is known") {
    Scene scene(catalog());
    const NodeId joined = add(scene, "union");
    const NodeId disc = add(scene, "circle", joined, {{"radius", 0.02}});
    add(scene, "box", joined, {{"size", Vec2(0.02, 0.02)}, {"at", Vec2(0.02, 0)}});
    const NodeId blend = add(scene, "smooth_union", {}, {{"k", 0.01}});
    add(scene, "ellipse", blend);
    add(scene, "half_plane", blend);
    const NodeId open = wedge(scene, "intersection", {});
    const NodeId onion = add(scene, "onion");
    const NodeId cut = add(scene, "difference", onion);
    add(scene, "circle", cut, {{"radius", 0.05}});
    add(scene, "circle", cut, {{"radius", 0.05}, {"at", Vec2(0.03, 0)}});
    const NodeId bat = add(scene, "flipper");
    const ProgramPtr program = compiled(scene);

    const std::map<NodeId, DistanceQuality> all = distance_qualities_of(*program);
    const auto check = [&](NodeId node, const Exactness& formula, bool known) {
        INFO(scene.path(node));
        REQUIRE(all.count(node) == 1);
        CHECK(all.at(node).formula == formula);
        CHECK(all.at(node).boundary_known == known);
        const std::optional<DistanceQuality> one = distance_quality_of(*program, node);
        REQUIRE(one);
        CHECK(one->formula == formula);
        CHECK(one->boundary_known == known);
        CHECK(one->exactness() == (known ? Exactness{} : formula));
    };
    check(joined, outside_only, true);
    check(disc, {}, false);
    check(blend, neither, false);
    check(open, inside_only, false);
    check(cut, inside_only, true);  // for the onion's sake, although it is no solid of its own
    check(onion, outside_only, true);
    CHECK(distance_quality_of(*program, bat));
    CHECK_FALSE(distance_quality_of(*program, scene.physics().id));
}

TEST_CASE("a fitted boundary is known within its error, which makes no side of it exact") {
    Scene scene(catalog());
    const NodeId blend = add(scene, "smooth_union", {}, {{"k", 0.005}});
    add(scene, "circle", blend, {{"radius", 0.05}});
    add(scene, "circle", blend, {{"radius", 0.05}, {"at", Vec2(0.1, 0)}});
    const std::optional<DistanceQuality> quality = distance_quality_of(*compiled(scene), blend);
    REQUIRE(quality);
    CHECK(quality->boundary_known);
    CHECK(quality->fit_error == Approx(1e-7 * (0.2 + 2 * 0.005)));  // a ten millionth of the longer side of its box
    CHECK(quality->exactness() == neither);
}

TEST_CASE("an offset in a mover or a sensor is warned of like any other") {
    for (const std::string_view part : {"bumper", "drain"}) {
        INFO(part);
        Scene scene(catalog());
        const NodeId offset = add(scene, "round", add(scene, part), {{"radius", 0.01}});
        wedge(scene, "intersection", offset);
        CHECK(warnings_of(*compiled(scene), scene).size() == 1);
    }
}

TEST_CASE("an offset of a bound whose boundary cannot be found is a warning; of an exact side, or of a known boundary, it is none") {
    struct Case {
        std::string_view offset, field, below;
        const char* sides;  ///< null: no warning
    };
    const Case cases[] = {{"round", "radius", "intersection", "outside"}, {"inset", "distance", "intersection", nullptr},
                          {"onion", "thickness", "intersection", "outside"}, {"round", "radius", "union", nullptr},
                          {"inset", "distance", "union", "inside"},       {"onion", "thickness", "union", "inside"},
                          {"onion", "thickness", "smooth_union", "on both sides"}};
    for (const Case& c : cases) {
        INFO(c.offset << " of " << c.below);
        Scene scene(catalog());
        const NodeId offset = add(scene, c.offset, {}, {{c.field, 0.01}});
        scene.find(offset)->key = {main_file, {7, 12}};
        wedge(scene, c.below, offset);
        const Diagnostics found = warnings_of(*compiled(scene), scene);
        REQUIRE(found.size() == (c.sides ? 1 : 0));
        if (!c.sides) continue;
        CHECK(found[0].code == "W0503");
        CHECK(found[0].severity == Severity::warning);
        CHECK(found[0].where == Place{main_file, {7, 12}});
        CHECK_THAT(found[0].message, Catch::StartsWith(std::string(c.offset)) && Catch::Contains(std::string(": ") + c.sides + ","));
    }

    Scene scene(catalog());
    const NodeId offset = add(scene, "round", {}, {{"radius", 0.01}});
    const NodeId cut = add(scene, "intersection", offset);
    add(scene, "box", cut);
    add(scene, "box", cut, {{"turn", 30.0}});
    CHECK(warnings_of(*compiled(scene), scene).empty());
}

TEST_CASE("a layer that no ball is on is a warning, once, at the first solid there") {
    Scene scene(catalog());
    add(scene, "circle");
    const std::vector<std::string> both{"ramp", "ground"}, ramp{"ramp"}, attic{"attic"};
    add(scene, "circle", {}, {{"layer", both}});
    CHECK(warnings_of(*compiled(scene), scene).empty());
    const NodeId group = add(scene, "group", {}, {{"layer", ramp}});
    const NodeId first = add(scene, "box", group);
    add(scene, "bumper", group);
    scene.find(first)->key = {main_file, {3, 6}};
    const NodeId above = add(scene, "flipper", {}, {{"layer", attic}});
    scene.find(above)->key = {main_file, {9, 16}};
    const Diagnostics found = warnings_of(*compiled(scene), scene);
    REQUIRE(found.size() == 2);
    CHECK(found[0].code == "W0505");
    CHECK(found[0].where == Place{main_file, {3, 6}});
    CHECK_THAT(found[0].message, Catch::Contains("layer ramp") && Catch::Contains("box"));
    CHECK(found[1].where == Place{main_file, {9, 16}});
}

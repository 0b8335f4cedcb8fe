// Tables that say the same thing otherwise: what compiling, lowering, tracing and offsetting may not tell apart.
#include <catch2/catch.hpp>

#include "engine/core/trig.h"
#include "engine/program/evaluate.h"
#include "tests/conformance/nodes_in_scenes.h"

namespace pinfield::conformance {
namespace {

using test::Fields;

/// A shape in one table with what is made of it.
struct Likenesses {
    NodeId plain, moved, not_not, with_itself, shared_with_itself, without_itself, either_or, rounded_twice, rounded;
    ProgramPtr program;
    double extent = 0;
};

const Similarity world_from_local{-0.6, 0.8, 1.5, true, {0.3, -0.2}};
/// What an author writes to place a node so.
const Fields as_written{{"at", Vec2(0.3, -0.2)}, {"turn", degrees(arc_tangent(0.8, -0.6))}, {"scale", 1.5}, {"flip", std::string("y")}};

Likenesses likenesses_of(const NodeType& type, const Values& values) {
    Likenesses out;
    Scene scene(test::catalog());
    const auto shape = [&](NodeId parent) { return add_with(scene, type, values, parent); };
    const auto over = [&](std::string_view operation, int children, NodeId parent = {}, const Fields& fields = {}) {
        const NodeId id = test::add(scene, operation, parent, fields);
        for (int i = 0; i < children; ++i) shape(id);
        return id;
    };
    out.extent = Subject(type, values).extent();
    out.plain = shape({});
    out.moved = shape({});
    for (const auto& [key, value] : as_written) test::set(*scene.find(out.moved), key, value);
    out.not_not = test::add(scene, "complement");
    over("complement", 1, out.not_not);
    out.with_itself = over("union", 2);
    out.shared_with_itself = over("intersection", 2);
    out.without_itself = over("difference", 2);
    out.either_or = over("xor", 2);
    const double r = 0.1 * out.extent, s = 0.05 * out.extent;
    out.rounded_twice = test::add(scene, "round", {}, {{"radius", r}});
    over("round", 1, out.rounded_twice, {{"radius", s}});
    out.rounded = over("round", 1, {}, {{"radius", r + s}});
    out.program = test::compiled(scene);
    return out;
}

std::vector<Vec2> places_about(const Likenesses& all) {
    std::vector<Vec2> out;
    CounterRng rng(5);
    for (int i = 0; i < 60; ++i) {
        const double x = all.extent * rng.in(-1.5, 1.5);
        out.emplace_back(x, all.extent * rng.in(-1.5, 1.5));
    }
    return out;
}

/// Where both are sure of their distances these agree, elsewhere at least the sides do. A thing that was moved knows as much as before.
void compare(const Likenesses& all, const char* what, NodeId one, NodeId other) {
    const int a = solid_of(*all.program, one), b = solid_of(*all.program, other);
    const bool is_moved = other == all.moved;
    for (const Vec2& p : places_about(all)) {
        const Nearest here = nearest_of_solid(all.program->fixed, a, p);
        Nearest there = nearest_of_solid(all.program->fixed, b, is_moved ? world_from_local * p : p);
        if (is_moved) there.distance /= world_from_local.scale;
        INFO(what << " at (" << p.x() << ", " << p.y() << "): " << here.distance << " and " << there.distance);
        if (is_moved || (here.certified && there.certified))
            CHECK(std::fabs(there.distance - here.distance) <= 1e-9 * std::max(all.extent, length(p)));
        if (std::fabs(here.distance) > 1e-6 * all.extent) CHECK((here.distance < 0) == (there.distance < 0));
    }
}

/// No solid, where its emptiness was found out, or one that no place is in.
void check_nothing(const Likenesses& all, const char* what, NodeId nothing) {
    const int solid = solid_of(*all.program, nothing);
    if (solid < 0) return;
    for (const Vec2& p : places_about(all)) {
        INFO(what << " at (" << p.x() << ", " << p.y() << ")");
        CHECK(nearest_of_solid(all.program->fixed, solid, p).distance >= 0);
    }
}

void check_likenesses(const NodeType& type, const Values& values) {
    INFO(Subject(type, values).text());
    const Likenesses all = likenesses_of(type, values);
    compare(all, "moved", all.plain, all.moved);
    compare(all, "complement of the complement", all.plain, all.not_not);
    compare(all, "union with itself", all.plain, all.with_itself);
    compare(all, "intersection with itself", all.plain, all.shared_with_itself);
    compare(all, "rounded twice", all.rounded, all.rounded_twice);
    check_nothing(all, "difference with itself", all.without_itself);
    check_nothing(all, "exclusive or with itself", all.either_or);
}

}  // namespace

TEST_CASE("a shape moved, complemented twice, united with itself or rounded in two steps is that shape, and without itself it is nothing") {
    for (const NodeType& type : test::catalog()->types()) {
        if (type.meta.kind != NodeKind::shape) continue;
        for (const Values& values : some_values(type, 2)) check_likenesses(type, values);
    }
}

}  // namespace pinfield::conformance

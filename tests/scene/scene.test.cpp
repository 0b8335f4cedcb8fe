#include "engine/scene/scene.h"

#include <catch2/catch.hpp>
#include <set>

#include "engine/io/same_content.h"
#include "engine/scene/catalog.h"
#include "engine/scene/edit.h"

using namespace pinfield;

namespace {

std::shared_ptr<const Catalog> catalog() {
    static const auto shared = std::make_shared<const Catalog>(built_in_catalog());
    return shared;
}

Node& add(Scene& scene, std::string_view type, NodeId parent = {}, const std::string& id = {}) {
    Node& node = scene.add(*catalog()->find(type), parent);
    if (!id.empty()) {
        apply(scene, {node.id, *node.type->find_field("id"), id, true});
    }
    return node;
}

void set(Scene& scene, NodeId id, std::string_view key, const Value& value) {
    apply(scene, {id, *scene.find(id)->type->find_field(key), value, true});
}

}  // namespace

TEST_CASE("a node is found by its id, else by its path among siblings of its type") {
    Scene scene(catalog());
    const NodeId box = add(scene, "box").id, first = add(scene, "union").id, second = add(scene, "union").id;
    const NodeId inner = add(scene, "circle", second).id, named = add(scene, "circle", second, "pop").id;
    CHECK(scene.path(box) == "box[0]");
    CHECK(scene.path(first) == "union[0]");
    CHECK(scene.path(inner) == "union[1]/circle[0]");
    CHECK(scene.path(named) == "pop");
    CHECK(scene.path(scene.physics().id) == "physics");
    for (const NodeId id : scene.all()) {
        REQUIRE(scene.find(scene.path(id)));
        CHECK(scene.paths().at(id) == scene.path(id));
        CHECK(scene.find(scene.path(id))->id == id);
    }
    CHECK(scene.find("circle[0]") == nullptr);
    CHECK(scene.find("") == nullptr);
}

TEST_CASE("a node is within itself and all above it, and one that is gone is within nothing") {
    Scene scene(catalog());
    const NodeId outer = add(scene, "union").id, inner = add(scene, "circle", outer).id, gone = add(scene, "box", outer).id;
    apply(scene, Remove{gone});
    for (const NodeId node : {outer, inner}) CHECK(scene.is_within(node, node));
    CHECK(scene.is_within(inner, outer));
    CHECK_FALSE(scene.is_within(outer, inner));
    for (const NodeId other : {outer, inner, gone}) {
        CHECK_FALSE(scene.is_within(gone, other));
        CHECK_FALSE(scene.is_within(other, gone));
    }
}

TEST_CASE("all ids come in file order, parents before children") {
    Scene scene(catalog());
    const NodeId a = add(scene, "union").id, b = add(scene, "circle").id, c = add(scene, "box", a).id;
    const NodeId material = scene.add_material("rubber").id;
    CHECK(scene.all() == std::vector<NodeId>{scene.table().id, scene.physics().id, material, a, c, b});
}

TEST_CASE("a node without a material of its own has its nearest ancestor's, else the default") {
    Scene scene(catalog());
    scene.add_material("rubber");
    scene.add_material("steel");
    const NodeId outer = add(scene, "union").id, middle = add(scene, "union", outer).id,
                 leaf = add(scene, "circle", middle).id;
    CHECK(scene.material_name(leaf) == "default");
    set(scene, outer, "material", std::string("rubber"));
    CHECK(scene.material_name(leaf) == "rubber");
    set(scene, leaf, "material", std::string("steel"));
    CHECK(scene.material_name(leaf) == "steel");
    CHECK(scene.material_name(middle) == "rubber");
}

TEST_CASE("a re-read scene keeps the ids of nodes known by id or by path, and shares none with strangers") {
    Scene before(catalog());
    const NodeId pop = add(before, "bumper", {}, "pop").id, box = add(before, "box").id;
    Scene after(catalog());
    add(after, "circle");  // new, in front
    add(after, "box");
    add(after, "bumper", {}, "pop");
    after.keep_ids_of(before);
    CHECK(after.find("pop")->id == pop);
    CHECK(after.find("box[0]")->id == box);
    CHECK(after.table().id == before.table().id);
    std::set<NodeId> old_ids;
    for (const NodeId id : before.all()) old_ids.insert(id);
    CHECK(old_ids.count(after.find("circle[0]")->id) == 0);
    std::set<NodeId> ids;
    for (const NodeId id : after.all()) {
        CHECK(ids.insert(id).second);
        CHECK(after.find(id)->id == id);
    }
    CHECK(add(after, "box").id.value > 0);
    CHECK(ids.count(after.roots().back()) == 0);
}

TEST_CASE("a name taken by a node of another type is a new node") {
    Scene before(catalog()), after(catalog());
    const NodeId old_pop = add(before, "bumper", {}, "pop").id;
    add(after, "circle", {}, "pop");
    after.keep_ids_of(before);
    CHECK(after.find("pop")->id != old_pop);
}

TEST_CASE("scenes are the same when every bit of every value is") {
    Scene a(catalog()), b(catalog());
    set(a, add(a, "circle").id, "turn", 0.0);
    set(b, add(b, "circle").id, "turn", 0.0);
    CHECK(same_content(a, b));
    set(b, b.roots()[0], "turn", -0.0);
    CHECK_FALSE(same_content(a, b));
    set(b, b.roots()[0], "turn", 0.0);
    b.inputs.push_back({"left", {"Z"}, {}});
    CHECK_FALSE(same_content(a, b));
}

TEST_CASE("flipping x is flipping y and half a turn") {
    Scene scene(catalog());
    const NodeId id = add(scene, "box").id;
    set(scene, id, "turn", 30.0);
    set(scene, id, "at", Vec2(1, 2));
    set(scene, id, "flip", std::string("x"));
    const Similarity flipped_x = parent_from_local(*scene.find(id));
    set(scene, id, "flip", std::string("y"));
    const Similarity flipped_y = parent_from_local(*scene.find(id));
    CHECK(length(flipped_x * Vec2(-3, 4) - (flipped_y * Vec2(3, -4))) < 1e-12);
    CHECK(flipped_x.mirrored);
}

TEST_CASE("a node's frame is the product of its ancestors'") {
    Scene scene(catalog());
    const NodeId outer = add(scene, "group").id, inner = add(scene, "circle", outer).id;
    set(scene, outer, "at", Vec2(1, 0));
    set(scene, outer, "turn", 90.0);
    set(scene, outer, "scale", 2.0);
    set(scene, inner, "at", Vec2(1, 0));
    CHECK(world_from_local(scene, inner) * Vec2(0, 0) == Vec2(1, 2));
    CHECK(world_from_local(scene, inner).scale == 2);
}

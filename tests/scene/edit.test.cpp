#include "engine/scene/edit.h"

#include <catch2/catch.hpp>
#include <limits>

#include "engine/core/rng.h"
#include "engine/io/same_content.h"
#include "engine/scene/catalog.h"
#include "engine/scene/validate.h"

using namespace pinfield;

namespace {

/// One node of every type a scene may hold, each alone at the top level.
Scene one_of_each() {
    static const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
    Scene scene(catalog);
    for (const NodeType& type : catalog->types())
        if (type.meta.kind != NodeKind::record) scene.add(type);
    scene.add_material("rubber");
    return scene;
}

int field(const Node& node, std::string_view key) { return *node.type->find_field(key); }

Value some_value(const FieldType& field, CounterRng& rng) {
    switch (field.kind) {
        case FieldKind::boolean: return rng.uniform() < 0.5;
        case FieldKind::integer: return static_cast<std::int64_t>(rng.in(1, 12));
        case FieldKind::number: return rng.in(-0.1, 0.2);
        case FieldKind::vec2: return Vec2{rng.in(-0.1, 0.2), rng.in(0, 0.2)};
        case FieldKind::points: return std::vector<Vec2>{{0, 0}, {rng.in(0.1, 1), 0}, {0, rng.in(0.1, 1)}};
        case FieldKind::choice: return std::string(field.choices[rng.next_u64() % field.choices.size()]);
        case FieldKind::choices: return std::vector<std::string>(1 + rng.next_u64() % 3, std::string(field.choices.front()));
        case FieldKind::id: return "name_" + std::to_string(rng.next_u64() % 5);
        case FieldKind::names: return std::vector<std::string>{"a", "b"};
        case FieldKind::text:
        case FieldKind::color: return std::string("crimson");
    }
    return false;
}

}  // namespace

TEST_CASE("every default value is in contract") {
    const Scene scene = one_of_each();
    for (const NodeId id : scene.all()) {
        const Node& node = *scene.find(id);
        INFO(node.type->key());
        CHECK_FALSE(broken_contract(node));
        for (std::size_t i = 0; i < node.fields.size(); ++i) {
            INFO(node.type->fields[i].key);
            if (!node.type->fields[i].meta.required)
                CHECK_FALSE(why_invalid(scene, {id, static_cast<int>(i), node.fields[i].value, false}));
        }
    }
}

TEST_CASE("edits applied and taken back leave the scene bit for bit as it was") {
    const Scene original = one_of_each();
    Scene scene = original;
    CounterRng rng(5);
    std::vector<SetField> undo;
    for (int i = 0; i < 5000; ++i) {
        const auto all = scene.all();
        const Node& node = *scene.find(all[rng.next_u64() % all.size()]);
        const auto index = rng.next_u64() % node.fields.size();
        const SetField edit{node.id, static_cast<int>(index), some_value(node.type->fields[index], rng),
                        rng.uniform() < 0.8};
        if (why_invalid(scene, edit)) continue;
        const SetField inverse = apply(scene, edit);
        CHECK(identical(node.fields[index].value, edit.value));
        CHECK_FALSE(broken_contract(node));
        undo.push_back(inverse);
    }
    CHECK(undo.size() > 1000);
    CHECK_FALSE(same_content(scene, original));
    for (auto it = undo.rbegin(); it != undo.rend(); ++it) apply(scene, *it);
    CHECK(same_content(scene, original));
}

TEST_CASE("what a field cannot hold is refused with a reason") {
    Scene scene = one_of_each();
    const Node& circle = *scene.find("circle[0]");
    const int radius = field(circle, "radius");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(why_invalid(scene, {circle.id, radius, 0.0, true}) == "radius must be above 0 m");
    CHECK(why_invalid(scene, {circle.id, radius, nan, true}));
    CHECK(why_invalid(scene, {circle.id, radius, infinity, true}));
    CHECK(why_invalid(scene, {circle.id, radius, std::string("big"), true}));
    CHECK(why_invalid(scene, {circle.id, -1, 1.0, true}));
    CHECK(why_invalid(scene, {circle.id, 99, 1.0, true}));
    CHECK(why_invalid(scene, {NodeId{}, radius, 1.0, true}) == "the node no longer exists");
    CHECK(why_invalid(scene, {circle.id, field(circle, "flip"), std::string("z"), true}));
    const Node& box = *scene.find("box[0]");
    CHECK(why_invalid(scene, {box.id, field(box, "round"), 1.0, true}));
}

TEST_CASE("an id that another node has is refused, one's own is not") {
    Scene scene = one_of_each();
    const NodeId circle = scene.find("circle[0]")->id, box = scene.find("box[0]")->id;
    const int id = field(*scene.find(circle), "id");
    apply(scene, {circle, id, std::string("pop"), true});
    CHECK(scene.find("pop")->id == circle);
    CHECK(why_invalid(scene, {box, field(*scene.find(box), "id"), std::string("pop"), true}) == "the id pop is taken");
    CHECK_FALSE(why_invalid(scene, {circle, id, std::string("pop"), true}));
    const SetField back = apply(scene, {circle, id, std::string(), false});
    CHECK(scene.find("pop") == nullptr);
    apply(scene, back);
    CHECK(scene.find("pop")->id == circle);
}

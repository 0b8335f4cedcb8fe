#include "engine/io/write_table.h"

#include <catch2/catch.hpp>

#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

/// The scene as if only what differs from its default had been given. Items that make nodes are written as their author has them.
Scene without_defaults(Scene scene) {
    for (const NodeId id : scene.all()) {
        Node& node = *scene.find(id);
        if (node.origin || node.generator) continue;
        for (std::size_t i = 0; i < node.fields.size(); ++i)
            node.fields[i].is_explicit =
                node.type->fields[i].meta.required || !identical(node.fields[i].value, node.type->fields[i].initial);
    }
    return scene;
}

}  // namespace

TEST_CASE("the canonical form reads back as the same scene and is its own canonical form") {
    for (const auto& [name, text] : good_tables()) {
        const Reading original = read(text);
        const std::string canonical = write_table(original.scene);
        const Reading again = read(canonical);
        INFO(name << "\n" << canonical << told(again));
        REQUIRE(again.ok());
        CHECK(same_content(again.scene, without_defaults(original.scene)));
        CHECK(write_table(again.scene) == canonical);
    }
}

TEST_CASE("scenes after random edits survive the canonical form") {
    CounterRng rng(11);
    for (const auto& [name, text] : good_tables()) {
        Scene scene = read(text).scene;
        for (int i = 0; i < 100; ++i)
            if (const auto edit = some_edit(scene, rng); edit && !scene.find(edit->node)->generator) apply(scene, *edit);  // see without_defaults
        scene.tests.clear();  // they may expect something of a node that has another id now
        const std::string canonical = write_table(scene);
        const Reading again = read(canonical);
        INFO(name << "\n" << canonical << told(again));
        REQUIRE(again.ok());
        CHECK(same_content(again.scene, without_defaults(scene)));
    }
}

TEST_CASE("the canonical form leaves defaults out and writes bare SI numbers") {
    const Reading result = read(
        "pinfield: 1\nscene:\n  - circle: {turn: 0, radius: 24mm, id: a}\n  - union: {children: [box: {size: [1cm, "
        "1m]}]}\n");
    CHECK(write_table(result.scene) ==
          "pinfield: 1\nscene:\n  - circle: {id: a, radius: 0.024}\n  - union:\n      children:\n        - box: {size: "
          "[0.01, 1]}\n");
}

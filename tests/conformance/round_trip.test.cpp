#include <catch2/catch.hpp>

#include <memory>

#include "engine/io/table_reader.h"
#include "engine/io/write_table.h"
#include "engine/scene/catalog.h"
#include "tests/conformance/parameters.h"

namespace pinfield::conformance {
namespace {

void fill(Node& node, const Values& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        node.fields[i].value = values[i];
        node.fields[i].is_explicit = true;
    }
}

/// A scene with one node of this type, with as many discs as it needs.
Scene scene_with(const std::shared_ptr<const Catalog>& catalog, const NodeType& type, const Values& values) {
    Scene scene(catalog);
    Node& node = scene.add(type);
    fill(node, values);
    const NodeId parent = node.id;
    for (int i = 0; i < type.meta.children.min; ++i) scene.add(*catalog->find("circle"), parent);
    return scene;
}

void check_round_trip(const std::shared_ptr<const Catalog>& catalog, const NodeType& type, const Values& values) {
    const std::string written = write_table(scene_with(catalog, type, values));
    INFO(written);
    const auto source = std::make_shared<const SourceText>("written.yaml", written);
    const Reading read = read_table(source, catalog);
    for (const Diagnostic& diagnostic : read.diagnostics)
        if (diagnostic.severity == Severity::error) FAIL_CHECK(format(diagnostic, read.scene.sources));
    REQUIRE(read.scene.roots().size() == 1);
    const Node& node = *read.scene.find(read.scene.roots()[0]);
    CHECK(node.type == &type);
    for (std::size_t i = 0; i < values.size(); ++i) {
        INFO(type.fields[i].key);
        CHECK(identical(node.fields[i].value, values[i]));
    }
    CHECK(write_table(read.scene) == written);
}

}  // namespace

TEST_CASE("every node with any parameters comes back from its text bit for bit") {
    const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
    for (const NodeType& type : catalog->types()) {
        if (!type.kernels) continue;
        CounterRng rng(5);
        check_round_trip(catalog, type, defaults_of(type));
        if (type.own_fields == 0) continue;
        for (int i = 0; i < 20; ++i) check_round_trip(catalog, type, random_values(type, rng));
        for (const Values& values : degenerate_values(type)) check_round_trip(catalog, type, values);
    }
}

TEST_CASE("every node refuses a key that it has no field for, where it stands") {
    const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
    for (const NodeType& type : catalog->types()) {
        if (type.meta.kind == NodeKind::record) continue;
        const std::string text = "pinfield: 1\nscene:\n  - " + std::string(type.key()) + ": {no_field: 1}\n";
        INFO(text);
        bool refused = false;  // some nodes miss their children, too
        for (const Diagnostic& found : read_table(std::make_shared<const SourceText>("wrong.yaml", text), catalog).diagnostics)
            refused = refused || (found.severity == Severity::error && text.substr(found.where.span.begin, 8) == "no_field");
        CHECK(refused);
    }
}

}  // namespace pinfield::conformance

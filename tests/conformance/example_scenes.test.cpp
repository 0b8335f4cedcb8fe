#include <catch2/catch.hpp>

#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "engine/io/load_table.h"
#include "engine/program/compile.h"
#include "engine/scene/catalog.h"
#include "tests/places.h"

namespace pinfield::conformance {
namespace {

std::string folder() { return test::source_dir() + "/scenes/nodes/"; }

}  // namespace

TEST_CASE("every node has an example scene that uses it, reads without complaint and compiles") {
    const auto catalog = std::make_shared<const Catalog>(built_in_catalog());
    std::set<std::string> expected;
    for (const NodeType& type : catalog->types()) {
        if (type.meta.kind == NodeKind::record) continue;
        const std::string path = folder() + std::string(type.key()) + ".yaml";
        expected.insert(std::string(type.key()) + ".yaml");
        INFO(path);
        const Result<Reading> loaded = load_table(path, catalog);
        REQUIRE(loaded.has_value());
        for (const Diagnostic& diagnostic : loaded->diagnostics) FAIL_CHECK(format(diagnostic, loaded->scene.sources));
        bool used = false;
        for (const NodeId id : loaded->scene.all()) used = used || loaded->scene.find(id)->type == &type;
        CHECK(used);
        const auto program = compile(loaded->scene);
        CHECK(program.has_value());
    }
    for (const auto& file : std::filesystem::directory_iterator(folder())) {
        INFO(file.path());
        CHECK(expected.count(file.path().filename().string()) == 1);
    }
}

}  // namespace pinfield::conformance

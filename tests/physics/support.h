// Tables from strings, for the tests of the physics.
#pragma once
#include <catch2/catch.hpp>
#include <string>

#include "engine/core/source_text.h"
#include "engine/io/load_table.h"
#include "engine/physics/world.h"
#include "engine/program/compile.h"
#include "engine/scene/catalog.h"
#include "tests/places.h"

namespace pinfield::physics_test {

inline const std::shared_ptr<const Catalog>& catalog() {
    static const auto all = std::make_shared<const Catalog>(built_in_catalog());
    return all;
}

inline ProgramPtr compiled(const Reading& read) {
    for (const Diagnostic& d : read.diagnostics) UNSCOPED_INFO(d.message);
    REQUIRE(read.ok());
    const auto program = compile(read.scene);
    if (!program)
        for (const Diagnostic& d : program.error()) UNSCOPED_INFO(d.message);
    REQUIRE(program);
    return *program;
}

inline ProgramPtr program_of(const std::string& text) {
    return compiled(read_table(std::make_shared<const SourceText>("test.yaml", text), catalog()));
}

inline ProgramPtr first_table() {
    const auto loaded = load_table(test::source_dir() + "/scenes/tables/first_table.yaml", catalog());
    REQUIRE(loaded);
    return compiled(*loaded);
}

/// A room of this size with its corner at the origin, no slope unless the rest of the text says so.
inline std::string room(double width, double height, const std::string& table, const std::string& physics, const std::string& nodes) {
    return "pinfield: 1\ntable: {size: [" + std::to_string(width) + ", " + std::to_string(height) + "]" + table + "}\n" + physics +
           "scene:\n  - domain: {id: air, children: [box: {size: [" + std::to_string(width) + ", " + std::to_string(height) + "], at: [" +
           std::to_string(width / 2) + ", " + std::to_string(height / 2) + "]}]}\n" + nodes;
}

inline double relative_error(double measured, double expected) { return std::fabs(measured - expected) / std::fabs(expected); }

}  // namespace pinfield::physics_test

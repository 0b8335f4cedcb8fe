#include <catch2/catch.hpp>

#include "engine/sdf/register.h"
#include "tests/conformance/check.h"
#include "tests/conformance/faulty_nodes.h"

namespace pinfield::conformance {

TEST_CASE("every shape and operation of the catalog obeys every law") {
    Catalog catalog;
    sdf::add_built_in(catalog);
    for (const NodeType& type : catalog.types()) {
        INFO(type.key());
        CHECK(check(catalog, type, 40));
    }
}

TEST_CASE("a report names each broken law once, with the parameters, the place and the numbers of its first violations") {
    Catalog catalog;
    sdf::add_built_in(catalog);
    CHECK(Catch::Detail::stringify(check(catalog, *catalog.find("circle"), 1)) == "circle obeys every law");

    const Report report = check<sdf::faulty::OverEstimate>(0);
    REQUIRE_FALSE(report);
    CHECK(report.breaks("no side over-estimates"));
    CHECK_FALSE(report.breaks("everything is finite"));
    const std::string shown = Catch::Detail::stringify(report), law = "\n  no side over-estimates\n    over_estimate {}\n      at (";
    INFO(shown);
    CHECK(shown.starts_with("over_estimate breaks "));
    const std::size_t place = shown.find(law);
    REQUIRE(place != shown.npos);
    CHECK(shown.find(law, place + 1) == shown.npos);
    CHECK(shown.find(", brute force ", place) != shown.npos);
}

}  // namespace pinfield::conformance

#include <catch2/catch.hpp>

#include "engine/sdf/register.h"
#include "tests/conformance/laws.h"

namespace pinfield::conformance {

TEST_CASE("every shape and operation of the catalogue obeys every law") {
    Catalogue catalogue;
    sdf::add_built_in(catalogue);
    for (const NodeType& type : catalogue.types()) {
        INFO(type.key());
        const std::vector<Violation> violations = check(catalogue, type, 40);
        CHECK_THAT(violations.empty() ? "" : text(violations), Catch::Matchers::Equals(""));
    }
}

}  // namespace pinfield::conformance

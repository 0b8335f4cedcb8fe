#include <catch2/catch.hpp>

#include "engine/sdf/register.h"
#include "tests/conformance/check.h"

namespace pinfield::conformance {

TEST_CASE("every shape and operation of the catalogue obeys every law") {
    Catalogue catalogue;
    sdf::add_built_in(catalogue);
    for (const NodeType& type : catalogue.types()) {
        INFO(type.key());
        CHECK(check(catalogue, type, 40));
    }
}

}  // namespace pinfield::conformance

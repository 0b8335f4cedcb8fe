#define CATCH_CONFIG_MAIN
#include "shield.h"

#include <catch2/catch.hpp>

#include "tests/conformance/check.h"

TEST_CASE("the shield obeys every law") { CHECK(pinfield::conformance::check<my::Shield>()); }

#include "engine/reflect/value.h"

#include <catch2/catch.hpp>

#include <limits>

namespace pinfield {

TEST_CASE("values are identical when every bit is") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(identical(1.5, 1.5));
    CHECK_FALSE(identical(0.0, -0.0));
    CHECK(identical(nan, nan));
    CHECK_FALSE(identical(1.0, std::int64_t{1}));
    CHECK(identical(Vec2(1, nan), Vec2(1, nan)));
    CHECK_FALSE(identical(Vec2(0.0, 1), Vec2(-0.0, 1)));
    CHECK(identical(std::vector<Vec2>{{1, 2}}, std::vector<Vec2>{{1, 2}}));
    CHECK_FALSE(identical(std::vector<Vec2>{{1, 2}}, std::vector<Vec2>{{1, 2}, {3, 4}}));
    CHECK(identical(std::string("a"), std::string("a")));
    CHECK_FALSE(identical(std::string("a"), std::string("b")));
    CHECK(identical(true, true));
}

}  // namespace pinfield

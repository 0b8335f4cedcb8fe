#include "engine/reflect/node_type.h"

#include <catch2/catch.hpp>

#include <limits>

#include "engine/core/at.h"
#include "engine/reflect/erase.h"
#include "tests/reflect/sample_node.h"

namespace pinfield {

TEST_CASE("a value outside a field's range is refused with the limit and its unit, an open limit itself too") {
    const NodeType type = node_type<Basket<double>>();
    const FieldType& weight = at(type.fields, *type.find_field("weight"));
    CHECK_FALSE(why_invalid(weight, 4.999));
    CHECK(why_invalid(weight, 0.0) == "must be above 0 kg");
    CHECK(why_invalid(weight, 5.0) == "must be below 5 kg");
    CHECK(why_invalid(weight, std::numeric_limits<double>::quiet_NaN()) == "must be a finite number");
    CHECK(why_invalid(weight, infinity) == "must be a finite number");
    const FieldType& count = at(type.fields, *type.find_field("count"));
    CHECK_FALSE(why_invalid(count, std::int64_t{0}));
    CHECK_FALSE(why_invalid(count, std::int64_t{10}));
    CHECK(why_invalid(count, std::int64_t{11}) == "must be at most 10");
    CHECK(why_invalid(count, std::int64_t{-1}) == "must be at least 0");
}

TEST_CASE("a range holds for both components of a vector and for words only those of the choice stand") {
    const NodeType type = node_type<Basket<double>>();
    const FieldType& place = at(type.fields, *type.find_field("at"));
    CHECK_FALSE(why_invalid(place, Vec2(-1, 5)));
    CHECK(why_invalid(place, Vec2(0, -1.5)) == "must be at least -1 m");
    const FieldType& fruit = at(type.fields, *type.find_field("fruit"));
    CHECK_FALSE(why_invalid(fruit, std::string("apple")));
    CHECK(why_invalid(fruit, std::string("nut")) == "must be one of apple, pear, plum");
}

TEST_CASE("a field is found by its key or not at all") {
    const NodeType type = node_type<Basket<double>>();
    CHECK(type.find_field("handles") == 5);
    CHECK_FALSE(type.find_field("handle"));
}

}  // namespace pinfield

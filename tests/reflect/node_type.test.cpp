#include "engine/reflect/node_type.h"

#include <catch2/catch.hpp>

#include <limits>

#include "engine/reflect/erase.h"
#include "tests/reflect/sample_node.h"

namespace pinfield {

TEST_CASE("a value outside a field's range is refused with the limit and its unit, an open limit itself too") {
    const NodeType type = node_type<Basket<double>>();
    const FieldType& weight = type.fields[static_cast<std::size_t>(*type.find_field("weight"))];
    CHECK_FALSE(refuse(weight, 4.999));
    CHECK(refuse(weight, 0.0) == "must be above 0 kg");
    CHECK(refuse(weight, 5.0) == "must be below 5 kg");
    CHECK(refuse(weight, std::numeric_limits<double>::quiet_NaN()) == "must be a finite number");
    CHECK(refuse(weight, infinity) == "must be a finite number");
    const FieldType& count = type.fields[static_cast<std::size_t>(*type.find_field("count"))];
    CHECK_FALSE(refuse(count, std::int64_t{0}));
    CHECK_FALSE(refuse(count, std::int64_t{10}));
    CHECK(refuse(count, std::int64_t{11}) == "must be at most 10");
    CHECK(refuse(count, std::int64_t{-1}) == "must be at least 0");
}

TEST_CASE("a range holds for both components of a vector and for words only those of the choice stand") {
    const NodeType type = node_type<Basket<double>>();
    const FieldType& at = type.fields[static_cast<std::size_t>(*type.find_field("at"))];
    CHECK_FALSE(refuse(at, Vec2(-1, 5)));
    CHECK(refuse(at, Vec2(0, -1.5)) == "must be at least -1 m");
    const FieldType& fruit = type.fields[static_cast<std::size_t>(*type.find_field("fruit"))];
    CHECK_FALSE(refuse(fruit, std::string("apple")));
    CHECK(refuse(fruit, std::string("nut")) == "must be one of apple, pear, plum");
}

TEST_CASE("a field is found by its key or not at all") {
    const NodeType type = node_type<Basket<double>>();
    CHECK(type.find_field("handles") == 5);
    CHECK_FALSE(type.find_field("handle"));
}

}  // namespace pinfield

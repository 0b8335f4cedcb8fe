#include "engine/reflect/erase.h"

#include <catch2/catch.hpp>

#include "tests/reflect/sample_node.h"

namespace pinfield {
namespace {

std::vector<Value> defaults_of(const NodeType& type) {
    std::vector<Value> out;
    for (const FieldType& field : type.fields) out.push_back(field.initial);
    return out;
}

}  // namespace

TEST_CASE("an erased description says of each field what the struct says") {
    const NodeType type = node_type<Basket<double>>();
    CHECK(type.key() == "basket");
    CHECK(type.meta.kind == NodeKind::record);
    CHECK(type.own_fields == 9);
    const FieldKind kinds[] = {FieldKind::boolean, FieldKind::integer, FieldKind::number, FieldKind::vec2,
                               FieldKind::choice,  FieldKind::points,  FieldKind::id,     FieldKind::names,
                               FieldKind::choices};
    for (std::size_t i = 0; i < 9; ++i) CHECK(type.fields[i].kind == kinds[i]);
    CHECK(identical(type.fields[1].initial, std::int64_t{3}));
    CHECK(identical(type.fields[3].initial, Vec2(0.25, -0.5)));
    CHECK(identical(type.fields[4].initial, std::string("pear")));
    CHECK(identical(type.fields[5].initial, std::vector<Vec2>{{1, 2}, {3, 4}, {5, 6}}));
    CHECK(identical(type.fields[8].initial, std::vector<std::string>{"plum", "apple"}));
    for (const std::size_t i : {std::size_t{4}, std::size_t{8}})
        CHECK(type.fields[i].choices == std::vector<std::string_view>{"apple", "pear", "plum"});
    CHECK(type.fields[2].meta.unit == Unit::kilogram);
    CHECK(type.contracts.size() == 2);
}

TEST_CASE("what is packed is loaded again, into any scalar") {
    const NodeType type = node_type<Basket<double>>();
    std::vector<Value> values = defaults_of(type);
    values[0] = false;
    values[2] = 1.75;
    values[4] = std::string("plum");
    values[5] = std::vector<Vec2>{{7, 8}};
    values[8] = std::vector<std::string>{"pear", "plum", "pear"};
    std::vector<double> block = pack(type, values, derived_count<Basket<double>>());
    derive_in_place<Basket<double>>(block.data());

    const auto basket = load<Basket<double>>(block.data());
    CHECK_FALSE(basket.open);
    CHECK(basket.count == 3);
    CHECK(basket.weight == 1.75);
    CHECK(basket.at.x == 0.25);
    CHECK(basket.at.y == -0.5);
    CHECK(basket.fruit == Fruit::plum);
    REQUIRE(basket.handles.count == 1);
    CHECK(basket.handles[0].y == 8);
    REQUIRE(basket.layers.count == 3);
    CHECK(basket.layers[0] == Fruit::pear);
    CHECK(basket.layers[1] == Fruit::plum);
    CHECK(basket.total == 3 * 1.75);

    const auto rough = load<Basket<float>>(block.data());
    CHECK(rough.weight == 1.75f);
    CHECK(rough.handles[0].x == 7.0f);
    CHECK(rough.total == 3 * 1.75);
}

TEST_CASE("deriving again after a change of a field gives what deriving afresh gives") {
    const NodeType type = node_type<Basket<double>>();
    std::vector<Value> values = defaults_of(type);
    std::vector<double> patched = pack(type, values, 1);
    derive_in_place<Basket<double>>(patched.data());
    values[1] = std::int64_t{2};
    std::vector<double> fresh = pack(type, values, 1);
    derive_in_place<Basket<double>>(fresh.data());
    patched[1] = 2;
    derive_in_place<Basket<double>>(patched.data());
    CHECK(patched == fresh);
}

TEST_CASE("the first broken contract is named") {
    const NodeType type = node_type<Basket<double>>();
    std::vector<Value> values = defaults_of(type);
    CHECK_FALSE(broken_contract(type, pack(type, values, 1).data()));
    values[1] = std::int64_t{5};
    CHECK(broken_contract(type, pack(type, values, 1).data()) == "no more than 12 kg");
    values[1] = std::int64_t{1};
    values[5] = std::vector<Vec2>{};
    CHECK(broken_contract(type, pack(type, values, 1).data()) == "at least one handle");
}

}  // namespace pinfield

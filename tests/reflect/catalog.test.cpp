#include "engine/reflect/catalog.h"

#include <catch2/catch.hpp>

#include "engine/reflect/erase.h"
#include "tests/reflect/sample_node.h"

namespace pinfield {

TEST_CASE("a catalog keeps its types in order, at addresses that further additions and moves leave alone") {
    Catalog catalog;
    const NodeType* first = &catalog.add(node_type<Basket<double>>());
    for (int i = 0; i < 100; ++i) {
        static constexpr std::string_view letters =
            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMN";
        NodeType type = node_type<Basket<double>>();
        type.meta.key = letters.substr(static_cast<std::size_t>(i), 2);
        if (!catalog.find(type.meta.key)) catalog.add(std::move(type));
    }
    CHECK(catalog.find("basket") == first);
    CHECK(catalog.keys().front() == "basket");
    CHECK(catalog.keys()[1] == "ab");
    CHECK(catalog.find("nothing") == nullptr);
    const Catalog moved = std::move(catalog);
    CHECK(moved.find("basket") == first);
}

}  // namespace pinfield

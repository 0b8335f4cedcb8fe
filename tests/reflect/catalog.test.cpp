#include "engine/reflect/catalogue.h"

#include <catch2/catch.hpp>

#include "engine/reflect/erase.h"
#include "tests/reflect/sample_node.h"

namespace pinfield {

TEST_CASE("a catalogue keeps its types in order, at addresses that further additions and moves leave alone") {
    Catalogue catalogue;
    const NodeType* first = &catalogue.add(node_type<Basket<double>>());
    for (int i = 0; i < 100; ++i) {
        static constexpr std::string_view letters =
            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMN";
        NodeType type = node_type<Basket<double>>();
        type.meta.key = letters.substr(static_cast<std::size_t>(i), 2);
        if (!catalogue.find(type.meta.key)) catalogue.add(std::move(type));
    }
    CHECK(catalogue.find("basket") == first);
    CHECK(catalogue.keys().front() == "basket");
    CHECK(catalogue.keys()[1] == "ab");
    CHECK(catalogue.find("nothing") == nullptr);
    const Catalogue moved = std::move(catalogue);
    CHECK(moved.find("basket") == first);
}

}  // namespace pinfield

#include "engine/sdf/simple_chain.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace pinfield::sdf {
namespace {

bool simple(const std::vector<double>& xy) { return is_simple_chain(xy.data(), static_cast<int>(xy.size() / 2)); }

}  // namespace

TEST_CASE("squares, stars and chains with coincident corners are simple") {
    CHECK(simple({0, 0, 1, 0, 1, 1, 0, 1}));
    CHECK(simple({0, 0, 0, 1, 1, 1, 1, 0}));
    CHECK(simple({0, 0, 1, 0, 1, 1, 1, 1, 0, 1, 0, 0}));
    CHECK(simple({0, 0, 0.5, 0, 1, 0, 1, 1}));          // a straight corner
    CHECK(simple({0, 0, 2, 0, 2, 1, 1, 0, 0, 1}));      // a corner that touches an edge
}

TEST_CASE("a bow tie, a spike and an edge run twice are not") {
    CHECK_FALSE(simple({0, 0, 1, 1, 1, 0, 0, 1}));
    CHECK_FALSE(simple({0, 0, 1, 0, 2, 0, 1, 0, 1, 1}));
    CHECK_FALSE(simple({0, 0, 1, 0, 2, 0}));
    CHECK_FALSE(simple({0, 0, 2, 0, 2, 2, 1, 0, 0.5, 0, 0, 2}));
}

TEST_CASE("the largest polygon allowed is judged quickly") {
    std::vector<double> ring;
    for (int i = 0; i < 4096; ++i) {
        const double t = 6.283185307179586 * i / 4096;
        ring.insert(ring.end(), {std::cos(t), std::sin(t)});
    }
    CHECK(simple(ring));
    std::swap(ring[0], ring[4]);
    std::swap(ring[1], ring[5]);
    CHECK_FALSE(simple(ring));
}

}  // namespace pinfield::sdf

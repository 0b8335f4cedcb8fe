#include "engine/core/hash.h"

#include <catch2/catch.hpp>
#include <set>

using namespace pinfield;

TEST_CASE("hex16 writes all sixteen digits") {
    CHECK(hex16(0) == "0000000000000000");
    CHECK(hex16(0xfedcba9876543210u) == "fedcba9876543210");
}

TEST_CASE("a hash depends on order, count, sign of zero and the cuts between strings") {
    std::set<std::uint64_t> seen;
    seen.insert(Hash64().value());
    seen.insert(Hash64().feed(1).value());
    seen.insert(Hash64().feed(2).feed(1).value());
    seen.insert(Hash64().feed(1).feed(2).value());
    seen.insert(Hash64().feed(0).value());
    seen.insert(Hash64().feed(0).feed(0).value());
    seen.insert(Hash64().feed(1.0).value());
    seen.insert(Hash64().feed(-0.0).value());
    seen.insert(Hash64().feed("ab").feed("c").value());
    seen.insert(Hash64().feed("a").feed("bc").value());
    seen.insert(Hash64().feed("abc").value());
    CHECK(seen.size() == 11);
}

TEST_CASE("integers of every width count alike, and 0.0 is all zero bits") {
    CHECK(Hash64().feed(7).value() == Hash64().feed(std::uint64_t{7}).value());
    CHECK(Hash64().feed(-1).value() == Hash64().feed(~std::uint64_t{0}).value());
    CHECK(Hash64().feed(0.0).value() == Hash64().feed(0).value());
}

TEST_CASE("every single bit of the input changes about half of the hash") {
    for (int bit = 0; bit < 64; ++bit) {
        int flipped = 0;
        for (std::uint64_t i = 0; i < 256; ++i)
            flipped += std::popcount(Hash64().feed(i).value() ^ Hash64().feed(i ^ (std::uint64_t{1} << bit)).value());
        REQUIRE(flipped / 256.0 == Approx(32).margin(1.5));
    }
}

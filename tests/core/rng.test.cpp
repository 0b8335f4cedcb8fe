#include "engine/core/rng.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "engine/core/at.h"

using namespace pinfield;

TEST_CASE("equal seeds and streams give equal numbers, others do not") {
    CounterRng a(1, 2), same(1, 2), other_seed(2, 2), other_stream(1, 3), swapped(2, 1);
    const std::uint64_t first = a.next_u64();
    CHECK(first == same.next_u64());
    CHECK(first != other_seed.next_u64());
    CHECK(first != other_stream.next_u64());
    CHECK(first != swapped.next_u64());
}

TEST_CASE("setting the counter back replays the numbers") {
    CounterRng rng(9);
    for (int i = 0; i < 5; ++i) rng.next_u64();
    const std::uint64_t counter = rng.counter();
    const std::uint64_t sixth = rng.next_u64();
    rng.next_u64();
    rng.set_counter(counter);
    CHECK(rng.next_u64() == sixth);
}

TEST_CASE("the first numbers of neighbouring seeds and streams are all different") {
    std::set<std::uint64_t> seen;
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        for (std::uint64_t stream = 0; stream < 100; ++stream) seen.insert(CounterRng(seed, stream).next_u64());
    CHECK(seen.size() == 10000);
}

TEST_CASE("uniform numbers fill the unit interval evenly, also across streams") {
    constexpr int bins = 100, count = 1000000;
    for (const bool across : {false, true}) {
        std::array<int, bins> histogram{};
        CounterRng rng(3);
        for (int i = 0; i < count; ++i) {
            const double u = across ? CounterRng(3, static_cast<std::uint64_t>(i)).uniform() : rng.uniform();
            REQUIRE((u >= 0 && u < 1));
            ++at(histogram, u * bins);
        }
        double chi_squared = 0;
        for (const int n : histogram) chi_squared += std::pow(n - count / bins, 2) / (count / bins);
        CHECK(chi_squared < 160);  // 99 degrees of freedom: 1 in 10^4
        CHECK(chi_squared > 50);
    }
}

TEST_CASE("numbers in a range stay in it") {
    CounterRng rng(4);
    double lowest = 9, highest = -9;
    for (int i = 0; i < 10000; ++i) {
        const double x = rng.in(-2, 5);
        lowest = std::fmin(lowest, x);
        highest = std::fmax(highest, x);
    }
    CHECK(lowest >= -2);
    CHECK(lowest < -1.99);
    CHECK(highest < 5);
    CHECK(highest > 4.99);
}

TEST_CASE("the first numbers are those an independent program computed") {
    CounterRng rng(42, 7);
    CHECK(rng.next_u64() == 0x714b7856c46b65deu);
    CHECK(rng.next_u64() == 0xf170efaf47aac4d4u);
}

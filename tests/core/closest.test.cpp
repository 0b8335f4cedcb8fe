#include "engine/core/closest.h"

#include <catch2/catch.hpp>
#include <vector>

#include "engine/core/rng.h"

using namespace pinfield;

TEST_CASE("edit distances known by hand") {
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("circle", "circle") == 0);
    CHECK(edit_distance("cirlce", "circle") == 1);  // neighbours swapped
    CHECK(edit_distance("circl", "circle") == 1);
    CHECK(edit_distance("circcle", "circle") == 1);
    CHECK(edit_distance("kitten", "sitting") == 3);
    CHECK(edit_distance("ca", "abc") == 3);  // no letter is edited twice
}

TEST_CASE("the edit distance is symmetric and between the difference and the larger of the lengths") {
    CounterRng rng(1);
    const auto random_word = [&] {
        std::string word(rng.next_u64() % 8, ' ');
        for (char& letter : word) letter = static_cast<char>('a' + rng.next_u64() % 3);
        return word;
    };
    for (int i = 0; i < 20000; ++i) {
        const std::string a = random_word(), b = random_word();
        const std::size_t d = edit_distance(a, b);
        const std::size_t longer = std::max(a.size(), b.size()), shorter = std::min(a.size(), b.size());
        if (d != edit_distance(b, a) || d < longer - shorter || d > longer || (d == 0) != (a == b)) FAIL(a << ' ' << b);
    }
}

TEST_CASE("a misspelt word finds the one that was meant, a strange one finds none") {
    const std::vector<std::string> shapes{"circle",          "box", "capsule", "uneven_capsule", "polygon",
                                          "regular_polygon", "star"};
    CHECK(closest_match("cirlce", shapes) == "circle");
    CHECK(closest_match("capsul", shapes) == "capsule");
    CHECK(closest_match("regular_poligon", shapes) == "regular_polygon");
    CHECK(closest_match("bx", shapes) == "box");
    CHECK(closest_match("boxes", shapes) == std::nullopt);
    CHECK(closest_match("rectangle", shapes) == std::nullopt);
    CHECK(closest_match("x", shapes) == std::nullopt);
    CHECK(closest_match("", shapes) == std::nullopt);
    CHECK(closest_match(std::string(1000, 'a'), shapes) == std::nullopt);
    const std::vector<std::string> none;
    CHECK(closest_match("circle", none) == std::nullopt);
}

TEST_CASE("of equally close words the first is proposed") {
    const std::vector<std::string_view> words{"left", "lift"};
    CHECK(closest_match("lft", words) == "left");
}

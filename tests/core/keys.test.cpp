#include "engine/core/keys.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>

using namespace pinfield;

TEST_CASE("every key has one name and one code, and each leads to the other") {
    std::set<std::string_view> names;
    std::set<int> codes;
    for (const KeyboardKey& key : keyboard_keys()) {
        INFO(key.name);
        CHECK(names.insert(key.name).second);
        CHECK(codes.insert(key.code).second);
        CHECK(key_code(key.name) == key.code);
        CHECK(key_name(key.code) == key.name);
    }
    CHECK(names.size() == 120);
}

TEST_CASE("what stands on a key names it too, and what is on no keyboard names nothing") {
    CHECK(key_code(".") == key_code("Period"));
    CHECK(key_code("7") == key_code("Key7"));
    CHECK(key_code("Esc") == key_code("Escape"));
    for (const char* word : {"", "z", "F0", "F26", "F99", "Key10", "Keypad0", "Kp10", "Shift", "space"}) {
        INFO(word);
        CHECK(key_code(word) == -1);
    }
    CHECK(key_name(-1).empty());
    CHECK(key_name(0).empty());
}

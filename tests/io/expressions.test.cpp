// Numbers that are written as expressions: read as what they come to, kept as what they say.
#include <catch2/catch.hpp>

#include "engine/io/text_patch.h"
#include "engine/io/write_table.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

const std::string table =
    "pinfield: 1\n"
    "materials: {rubber: {restitution: 1 - 0.2}}\n"
    "scene:\n"
    "  - circle: {id: petal, at: [1cm + 2mm, \"max(1cm, 25mm)\"], radius: 18mm * 1.6, turn: 360 / 8}  # one of eight\n"
    "  - regular_polygon: {sides: 2 * 4, radius: 1in}\n"
    "  - polygon: {points: [[0, 0], [2 * 12mm, 0], [0, 3cm / 2]]}\n";

Value value_of(const Scene& scene, std::string_view path, std::string_view key) {
    const Node& node = *scene.find(path);
    return node.fields[static_cast<std::size_t>(*node.type->find_field(key))].value;
}

SetField setting(const Scene& scene, std::string_view path, std::string_view key, const Value& value) {
    const Node& node = *scene.find(path);
    return {node.id, *node.type->find_field(key), value, true};
}

}  // namespace

TEST_CASE("an expression is read as what it comes to, wherever a number is due") {
    const Reading reading = read(table);
    INFO(told(reading));
    REQUIRE(reading.ok());
    CHECK(std::get<double>(value_of(reading.scene, "petal", "radius")) == 0.018 * 1.6);
    CHECK(std::get<double>(value_of(reading.scene, "petal", "turn")) == 45);
    CHECK(std::get<Vec2>(value_of(reading.scene, "petal", "at")) == Vec2(0.01 + 0.002, 0.025));
    CHECK(std::get<std::int64_t>(value_of(reading.scene, "regular_polygon[0]", "sides")) == 8);
    CHECK(std::get<std::vector<Vec2>>(value_of(reading.scene, "polygon[0]", "points"))[1] == Vec2(2 * 0.012, 0));
}

TEST_CASE("a table that is written anew keeps its expressions, and reads as the same table") {
    const Reading first = read(table);
    const std::string written = write_table(first.scene);
    INFO(written);
    for (const char* kept : {"1 - 0.2", "1cm + 2mm", "max(1cm, 25mm)", "18mm * 1.6", "360 / 8", "2 * 4", "2 * 12mm", "3cm / 2"})
        CHECK(written.find(kept) != std::string::npos);
    const Reading again = read(written);
    INFO(told(again));
    REQUIRE(again.ok());
    CHECK(write_table(again.scene) == written);
    CHECK(value_of(again.scene, "petal", "at") == value_of(first.scene, "petal", "at"));
}

TEST_CASE("an edit does not flatten an expression: it is refused with its words and line, and the fields beside it are edited as ever") {
    const Reading before = read(table);
    const auto why = why_invalid(before.scene, setting(before.scene, "petal", "radius", 0.03));
    REQUIRE(why);
    CHECK(why->find("18mm * 1.6") != std::string::npos);
    CHECK(why->find("line 4") != std::string::npos);

    const std::string plain = "pinfield: 1\nscene:\n  - circle: {turn: 360 / 8, radius: 18mm}  # one\n";
    const Reading beside = read(plain);
    const Edit edit = setting(beside.scene, "circle[0]", "radius", 0.03);
    const auto patched = patch_for(beside, std::span(&edit, 1));
    REQUIRE(patched);
    CHECK(patched->reading.source().text() == "pinfield: 1\nscene:\n  - circle: {turn: 360 / 8, radius: 30mm}  # one\n");
}

TEST_CASE("a node with expressions is moved, removed and put back with every byte of them") {
    const Reading before = read(table);
    const Node& petal = *before.scene.find("petal");
    const Edit move = Move{petal.id, petal.parent, 2};
    const auto moved = patch_for(before, std::span(&move, 1));
    REQUIRE(moved);
    CHECK(moved->reading.source().text().find("radius: 18mm * 1.6, turn: 360 / 8}  # one of eight\n") != std::string::npos);
    CHECK(value_of(moved->reading.scene, "petal", "radius") == value_of(before.scene, "petal", "radius"));

    Scene scene = before.scene;
    const Edit back = apply(scene, Remove{petal.id});
    const Edit remove = Remove{petal.id};
    const auto removed = patch_for(before, std::span(&remove, 1));
    REQUIRE(removed);
    CHECK(removed->reading.source().text().find("petal") == std::string::npos);
    const auto restored = patch_for(removed->reading, std::span(&back, 1));
    REQUIRE(restored);
    CHECK(value_of(restored->reading.scene, "petal", "at") == value_of(before.scene, "petal", "at"));
    CHECK(restored->reading.source().text().find("18mm * 1.6") != std::string::npos);
}

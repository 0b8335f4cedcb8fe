// The text of a formula: read with names in it, kept as it was written, edited like any text.
#include <catch2/catch.hpp>

#include "engine/io/text_patch.h"
#include "engine/io/write_table.h"
#include "engine/scene/validate.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

const std::string table =
    "pinfield: 1\n"
    "params: {petal: 4mm, count: 5, share: petal * 20mm}\n"
    "templates:\n"
    "  star:\n"
    "    args: {r: 2cm}\n"
    "    nodes:\n"
    "      - formula: {id: ring, distance: \"length(x, y) - r\"}\n"
    "scene:\n"
    "  - formula: {id: flower, distance: \"length(x, y) - 2cm - petal * sin(count * atan2(y, x))\", bounds: [6cm, 6cm]}  # kept\n"
    "  - formula: {id: bump, distance: x * y / 1cm - share / 1cm + i * 1mm, copies: {count: 2, step: [10cm, 0]}}\n"
    "  - formula: {id: plain, distance: abs(x) - 1cm}\n"
    "  - use: {template: star, id: a, with: {r: 3cm}}\n";

std::string replaced(std::string text, std::string_view what, std::string_view by) { return text.replace(text.find(what), what.size(), by); }

const FieldSlot& slot(const Scene& scene, std::string_view path) {
    const Node& node = *scene.find(path);
    return node.fields[static_cast<std::size_t>(*node.type->find_field("distance"))];
}
std::string formula(const Scene& scene, std::string_view path) { return std::get<std::string>(slot(scene, path).value); }

}  // namespace

TEST_CASE("a formula keeps x and y, and takes params, arguments and the number of its copy for what they are") {
    const Reading reading = read(table);
    INFO(told(reading));
    REQUIRE(reading.ok());
    CHECK(formula(reading.scene, "flower") == "length(x, y) - 2cm - (0.004 * 1m) * sin((5) * atan2(y, x))");
    CHECK(formula(reading.scene, "bump.2") == "x * y / 1cm - (8e-05 * 1m ^ 2) / 1cm + (2) * 1mm");
    CHECK(formula(reading.scene, "plain") == "abs(x) - 1cm");
    CHECK(formula(reading.scene, "a.ring") == "length(x, y) - (0.03 * 1m)");
    CHECK(slot(reading.scene, "plain").written == nullptr);
    CHECK(slot(reading.scene, "flower").written->front().text == "length(x, y) - 2cm - petal * sin(count * atan2(y, x))");
}

TEST_CASE("a table that is written anew keeps the names in its formulas, and reads as the same table") {
    const Reading first = read(table);
    const std::string written = write_table(first.scene);
    INFO(written);
    CHECK(written.find("\"length(x, y) - 2cm - petal * sin(count * atan2(y, x))\"") != std::string::npos);
    const Reading again = read(written);
    INFO(told(again));
    REQUIRE(again.ok());
    CHECK(write_table(again.scene) == written);
    CHECK(formula(again.scene, "flower") == formula(first.scene, "flower"));
}

TEST_CASE("a formula is edited as a text, and one that no distance can be made of is found wrong where it stands") {
    const auto source = std::make_shared<const SourceText>("test.yaml", table);
    const Reading before = read(table);
    const Node& node = *before.scene.find("plain");
    const auto set = [&](std::string_view text) { return SetField{node.id, *node.type->find_field("distance"), std::string(text), true}; };
    CHECK_FALSE(why_invalid(before.scene, set("abs(x) - 2cm")));
    CHECK(why_invalid(before.scene, set("abs(x) - ")).has_value());
    CHECK(why_invalid(before.scene, set("abs(x) * y")).has_value());

    const Reading wrong = read(replaced(table, "abs(x) - 1cm", "abs(x) - sign(y) * 1cm"));
    CHECK(codes_and_places(wrong) == std::vector<std::string>{"E0233 11:45"});
    const Reading quoted = read(replaced(table, "abs(x) - 1cm", "\"abs(x) - sign(y) * 1cm\""));
    CHECK(codes_and_places(quoted) == std::vector<std::string>{"E0233 11:46"});
    const Reading with_params = read(replaced(table, "abs(x) - 1cm", "abs(x) - sign(y) * petal"));
    CHECK(codes_and_places(with_params) == std::vector<std::string>{"E0233 11:36"});
}

TEST_CASE("what a formula's names are not is told at their place") {
    const auto found = [](std::string_view text) {
        return codes_and_places(read("pinfield: 1\nparams: {z: 3cm}\nscene:\n  - formula: {distance: \"" + std::string(text) + "\"}\n"));
    };
    using Codes = std::vector<std::string>;
    CHECK(found("x - z").empty());
    CHECK(found("x - w") == Codes{"E0305 4:30"});
    CHECK(found("x - z * y") == Codes{"E0213 4:30"});
    CHECK(found("x -") == Codes{"E0225 4:29"});
    CHECK(found("x * y") == Codes{"E0213 4:26"});
    CHECK(found("x < z") == Codes{"E0206 4:26"});
}

// What authors write who know another program is answered with what to write here.
#include <algorithm>
#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "engine/io/node_reference.h"
#include "engine/io/other_words.h"
#include "engine/io/quantity.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

/// Code, message and hint of the only thing that is wrong with a node in a scene.
std::string told_of(const std::string& node) {
    const Reading result = read("pinfield: 1\nscene:\n  - " + node + "\n");
    if (result.diagnostics.size() != 1) return told(result);
    const Diagnostic& d = result.diagnostics[0];
    return d.code + ": " + d.message + ": " + d.hint;
}

}  // namespace

TEST_CASE("a field that a node has not is answered with those it has, unless one is near") {
    CHECK(told_of("bumper: {score: 100}") ==
          "E0202: bumper has no score: it has radius, kick, threshold, id, at, turn, scale, flip, material, layer, visible, locked, note, children");
    CHECK(told_of("bumper: {radios: 1cm}") == "E0202: bumper has no radios: did you mean radius?");
    CHECK(told_of("circle: {position: [1, 1]}") == "E0202: circle has no position: write at: [x, y]");
    CHECK(told_of("box: {rotation: 30}") == "E0202: box has no rotation: write turn: degrees, counter-clockwise");
}

TEST_CASE("what other programs call a node gets a hint that names what there is, and none of these words is a node or field of ours") {
    for (const std::string word : {"target", "gate", "rotate", "line", "rect", "disc", "ball", "slingshot"}) {
        const std::string found = told_of(word + ": {}");
        INFO(found);
        CHECK(found.starts_with("E0203: no node is called " + word + ": "));
        CHECK(found.size() > found.rfind(": ") + 3);
    }
    for (const NodeType& type : catalog()->types()) {
        CHECK((other_word_for_node(type.key()).empty() || type.meta.kind == NodeKind::record));
        for (const FieldType& field : type.fields) CHECK((other_word_for_field(field.key).empty() || !field.common));
    }
}

TEST_CASE("signs and words for units are answered with the number as it is to be written") {
    const auto hint = [](const std::string& text, Unit unit) { return read_quantity(text, unit).error().hint; };
    CHECK(hint("30\u00b0", Unit::degree) == "write 30deg");
    CHECK(hint("30 degrees", Unit::degree) == "write 30deg");
    CHECK(hint("1.0625\"", Unit::metre) == "write 1.0625in");
    CHECK(hint("5'", Unit::metre) == "write 5ft");
    CHECK(hint("-2.5 millimetres", Unit::metre) == "write -2.5mm");
    CHECK(hint("3km", Unit::metre) == "units here: um, mm, cm, m, in, ft");
    CHECK(read_quantity("30\u00b0", Unit::metre).error().code == Code::wrong_dimension);
    // Whatever is to be written is read.
    for (const std::string word : {"\u00b0", "degrees", "radians"})
        CHECK(read_quantity(hint("3" + word, Unit::degree).substr(6), Unit::degree));
}

TEST_CASE("a section that is refused is not offered") {
    const Reading result = read("pinfield: 1\nscene: []\ngmae: {}\n");
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics[0].hint.find("game") == std::string::npos);
}

TEST_CASE("a part's field of its customary shape does nothing beside children, and is shown without them only") {
    for (const auto& [part, field] : {std::pair{"bumper", "radius"}, {"drain", "size"}, {"plunger", "size"}, {"flipper", "radius_pivot"}}) {
        const std::string value = std::string(field) == "size" ? "[1cm, 1cm]" : "1cm";
        const std::string body = std::string(part) + ": {" + field + ": " + value;
        INFO(body);
        CHECK(told_of(body + "}").empty());
        CHECK(told_of(body + ", children: [circle: {}]}") ==
              "W0504: " + std::string(field) + " does nothing beside children: they are the shape of the " + part + ": ");
    }
}

TEST_CASE("the reference tells every unit with all its spellings") {
    const std::string text = units_text(), markdown = units_markdown();
    for (const UnitSuffix& suffix : unit_suffixes()) {
        CHECK(text.find(suffix.text) != std::string::npos);
        CHECK(markdown.find("| " + suffixes_of(suffix.dimension) + " |") != std::string::npos);
    }
    CHECK(std::count(text.begin(), text.end(), '\n') == 10);  // a line a unit
}

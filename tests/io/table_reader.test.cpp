#include "engine/io/table_reader.h"

#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "engine/io/load_table.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

TEST_CASE("a small table reads into typed nodes with places") {
    const std::string text =
        "pinfield: 1\n"
        "table: {name: Moon, size: [52cm, 1.06]}\n"
        "materials: {rubber: {restitution: 0.8, color: crimson}}\n"
        "scene:\n"
        "  - bumper: {id: pop, at: [0.26, 80cm], radius: 24mm, material: rubber}\n"
        "  - flipper: {input: [left, right], turn: 0.5rad}\n"
        "  - union:\n"
        "      layer: upper\n"
        "      children: [circle: {radius: 3cm}, {box: {size: [1cm, 2cm]}}]\n"
        "inputs: {left: [Z, LeftShift], right: Slash}\n"
        "tests: [{launch: {at: [0.1, 40cm], velocity: [0, 3]}, run: 300ms, expect: [escaped == 0, pop.hits >= 1]}]\n";
    const Reading result = read(text);
    INFO(told(result));
    REQUIRE(result.ok());
    CHECK(result.diagnostics.empty());
    const Scene& scene = result.scene;
    CHECK(scene.table().get<std::string>("name") == "Moon");
    CHECK(scene.table().get<Vec2>("size") == Vec2(0.52, 1.06));
    const Node& pop = *scene.find("pop");
    CHECK(pop.get<double>("radius") == 0.024);
    const FieldSlot& radius = at(pop.fields, *pop.type->find_field("radius"));
    CHECK(radius.is_explicit);
    CHECK(result.scene.sources.slice(radius.where) == "24mm");
    CHECK(result.scene.sources.slice(pop.key) == "bumper");
    CHECK(result.scene.sources.slice(pop.where) == "bumper: {id: pop, at: [0.26, 80cm], radius: 24mm, material: rubber}");
    CHECK_FALSE(at(pop.fields, *pop.type->find_field("turn")).is_explicit);
    CHECK(scene.find("flipper[0]")->get<double>("turn") == Approx(28.6478897565));
    CHECK(scene.find("flipper[0]")->get<std::vector<std::string>>("input") ==
          std::vector<std::string>{"left", "right"});
    CHECK(scene.find("union[0]")->get<std::vector<std::string>>("layer") == std::vector<std::string>{"upper"});
    CHECK(scene.find("union[0]/box[0]")->get<Vec2>("size") == Vec2(0.01, 0.02));
    REQUIRE(scene.inputs.size() == 2);
    CHECK(scene.inputs[0].keys == std::vector<std::string>{"Z", "LeftShift"});
    REQUIRE(scene.tests.size() == 1);
    CHECK(scene.tests[0].launches.size() == 1);
    CHECK(scene.tests[0].launches[0].at == Vec2(0.1, 0.4));
    CHECK(scene.tests[0].run == 0.3);
    REQUIRE(scene.tests[0].expectations.size() == 2);
    CHECK(scene.tests[0].expectations[1].quantity == "pop.hits");
    CHECK(scene.tests[0].expectations[1].comparison == ">=");
    CHECK(scene.tests[0].expectations[1].value == 1);
}

TEST_CASE("every good table reads without a word") {
    for (const auto& [name, text] : good_tables()) {
        const Reading result = read(text);
        INFO(name << "\n" << told(result));
        CHECK(result.diagnostics.empty());
    }
}

TEST_CASE("scalars mean nothing special before a field gives them a type") {
    const Reading result =
        read("pinfield: 1\ntable: {name: 010, author: yes}\nscene: [group: {note: 2024-01-01}, group: {note: null}]\n");
    INFO(told(result));
    REQUIRE(result.ok());
    CHECK(result.scene.table().get<std::string>("name") == "010");
    CHECK(result.scene.table().get<std::string>("author") == "yes");
    CHECK(result.scene.find("group[0]")->get<std::string>("note") == "2024-01-01");
    CHECK(result.scene.find("group[1]")->get<std::string>("note") == "null");
}

TEST_CASE("plain anchors and aliases work, and an error in what they share is told where it stands") {
    const Reading good =
        read("pinfield: 1\nscene:\n  - circle: &c {radius: &r 3cm}\n  - circle: *c\n  - bumper: {radius: *r}\n");
    INFO(told(good));
    REQUIRE(good.ok());
    CHECK(good.scene.find("circle[1]")->get<double>("radius") == 0.03);
    CHECK(good.scene.find("bumper[0]")->get<double>("radius") == 0.03);
    CHECK(codes_and_places(read("pinfield: 1\nscene:\n  - circle: &c {radius: -3cm}\n")) ==
          std::vector<std::string>{"E0208 3:25"});
}

TEST_CASE("an alias whose anchor stands before a key is told at the alias, with what to write") {
    const Reading result =
        read("pinfield: 1\nscene:\n  - &whole union:\n      children: [circle: {}]\n  - *whole\n");
    CHECK(codes_and_places(result) == std::vector<std::string>{"E0201 5:5"});
    CHECK(result.diagnostics[0].message == "*whole is only the word union: in line 3 its anchor stands before a key");
    CHECK(read("pinfield: 1\nscene:\n  - &whole\n    union:\n      children: [circle: {}]\n  - *whole\n").ok());
    CHECK(read("pinfield: 1\nscene:\n  - &whole {union: {children: [circle: {}]}}\n  - *whole\n").ok());
}

TEST_CASE("children that are no list are one error, not also too few") {
    const Reading result = read("pinfield: 1\nscene:\n  - union: {children: {circle: {}}}\n");
    CHECK(codes_and_places(result) == std::vector<std::string>{"E0201 3:23"});
}

TEST_CASE("a file in UTF-32 is called that") {
    CHECK(read(std::string("\xFF\xFE\0\0p\0\0\0", 8)).diagnostics[0].message == "the file is UTF-32");
    CHECK(read(std::string("\0\0\xFE\xFF\0\0\0p", 8)).diagnostics[0].message == "the file is UTF-32");
    CHECK(read(std::string("\xFF\xFEp\0", 4)).diagnostics[0].message == "the file is UTF-16");
}

TEST_CASE("all errors of a file are told in one run, in the order of the text") {
    const Reading result = read(
        "pinfield: 1\ntable: {sise: [1, 2]}\nscene:\n  - circel: {}\n  - circle: {radius: -1, turn: 3mm}\n  - bumper: "
        "{material: none}\n");
    CHECK(codes_and_places(result) ==
          std::vector<std::string>{"E0202 2:9", "E0203 4:5", "E0208 5:22", "E0213 5:32", "E0301 6:24"});
}

TEST_CASE("a diagnostic shows its line with a caret, and how to mend it") {
    const Reading result = read("pinfield: 1\nscene:\n  - circle: {note: é, radious: 3}\n");
    CHECK(told(result) ==
          "test.yaml:3:23: error: circle has no radious [E0202]\n"
          "    - circle: {note: é, radious: 3}\n"
          "                        ^\n"
          "  hint: did you mean radius?\n");
}

TEST_CASE("limits are counted and can be raised") {
    Limits tight;
    tight.nodes = 3;
    const std::string four = "pinfield: 1\nscene: [circle: {}, circle: {}, circle: {}, circle: {}]\n";
    CHECK(codes_and_places(read(four, tight)) == std::vector<std::string>{"E0110 2:45"});
    CHECK(read(four).ok());
    tight = {};
    tight.points = 3;
    CHECK(codes_and_places(read("pinfield: 1\nscene: [polygon: {points: [[0, 0], [1, 0], [1, 1], [0, 1]]}]\n",
                                tight)) == std::vector<std::string>{"E0111 2:27"});
    tight = {};
    tight.events = 10;
    CHECK(read(four, tight).diagnostics.front().code == "E0108");
    tight = {};
    tight.file_bytes = 10;
    CHECK(codes_and_places(read(four, tight)) == std::vector<std::string>{"E0106 1:1"});
    tight = {};
    tight.scalar_bytes = 4;
    CHECK(read("pinfield: 1\nscene: [group: {note: 'four '}]\n", tight).diagnostics.front().code == "E0109");
    tight = {};
    tight.errors = 2;
    const Reading many = read("pinfield: 1\nscene: [a: {}, b: {}, c: {}, d: {}]\n", tight);
    CHECK(codes_and_places(many) == std::vector<std::string>{"E0203 2:9", "E0203 2:16", "E0122 2:23"});
}

TEST_CASE("a file above the limit is refused, one that is not there is a failure") {
    CHECK_FALSE(load_table("/nonexistent/table.yaml", catalog()));
    CHECK_FALSE(load_table("/", catalog()));
}

TEST_CASE("a type that only this program knows reads like the built-in ones") {
    Catalog extended = built_in_catalog();
    NodeType type = *extended.find("circle");
    type.meta.key = "blob";
    extended.add(type);
    const auto shared = std::make_shared<const Catalog>(std::move(extended));
    const auto source =
        std::make_shared<const SourceText>("t", "pinfield: 1\nscene: [blob: {radius: 3cm, at: [1, 2]}]\n");
    const Reading result = read_table(source, shared);
    INFO(told(result));
    REQUIRE(result.ok());
    CHECK(result.scene.find("blob[0]")->get<double>("radius") == 0.03);
}

TEST_CASE("a blank left out after a dash or a colon is told of as that") {
    const auto hint_of = [](const std::string& scene) {
        const Reading result = read("pinfield: 1\nscene:\n" + scene);
        REQUIRE(result.diagnostics.size() == 1);
        return result.diagnostics[0].hint;
    };
    CHECK(hint_of("  -circle: {radius: 30mm}\n") == "a blank belongs after the dash: - circle");
    CHECK(hint_of("  - circle: {radius:30mm}\n") == "a blank belongs after the colon: radius: 30mm");
    CHECK(hint_of("  - circle:\n      radius:30mm\n") == "a blank belongs after the colon: radius: 30mm");
    CHECK(hint_of("  - circle:30mm\n") == "a blank belongs after the colon: circle: 30mm");
}

TEST_CASE("a list of words is read from a list or from a word alone, and each word must be one of them") {
    const auto pieces_of = [](const std::string& written) {
        const Reading result =
            read("pinfield: 1\nscene:\n  - path: {points: [[0, 0], [1cm, 0], [1cm, 1cm]], pieces: " + written + "}\n");
        REQUIRE(result.ok());
        return result.scene.find("path[0]")->get<std::vector<std::string>>("pieces");
    };
    CHECK(pieces_of("line") == std::vector<std::string>{"line"});
    CHECK(pieces_of("[line, line, arc]") == std::vector<std::string>{"line", "line", "arc"});
    const Reading wrong = read("pinfield: 1\nscene:\n  - path: {points: [[0, 0], [1cm, 0]], pieces: [line, lime]}\n");
    REQUIRE(wrong.diagnostics.size() == 1);
    CHECK(wrong.diagnostics[0].code == "E0214");
    CHECK(wrong.diagnostics[0].hint == "did you mean line?");
    CHECK(wrong.scene.sources.slice(wrong.diagnostics[0].where) == "lime");
}

TEST_CASE("a field that does nothing beside the others is a warning") {
    const Reading result = read("pinfield: 1\nscene:\n  - smooth_union: {steps: 3, children: [circle: {}, box: {}]}\n");
    REQUIRE(result.ok());
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics[0].code == "W0504");
    CHECK(read("pinfield: 1\nscene:\n  - smooth_union: {steps: 3, family: stairs, children: [circle: {}, box: {}]}\n").diagnostics.empty());
}

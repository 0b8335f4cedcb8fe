// Templates, copies and pairs: one item of the text, many nodes of the scene.
#include <catch2/catch.hpp>

#include <fmt/format.h>

#include "engine/io/text_patch.h"
#include "engine/io/write_table.h"
#include "engine/scene/expanded.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

const std::string garden =
    "pinfield: 1\n"
    "params: {gap: 46mm}\n"
    "materials: {rubber: {}, gold: {}}\n"
    "templates:\n"
    "  lamp:\n"
    "    args: {r: 9mm, tint: gold}\n"
    "    nodes:\n"
    "      - circle: {id: bulb, radius: r, material: $tint}  # the glass\n"
    "      - box: {size: [2 * r, gap], at: [0, -gap]}\n"
    "scene:\n"
    "  - use: {template: lamp, id: lane, at: [0.1, 0.9], copies: {count: 3, step: [gap, 0]}}\n"
    "  - use: {template: lamp, id: big, at: [0.3, 0.5], with: {r: 2cm, tint: rubber}}  # the large one\n"
    "  - bumper: {id: pop, at: [0.2, 0.3], radius: i * 1cm, copies: {count: 4, around: [0.2, 0.2]}}\n"
    "  - flipper: {id: flip, at: [0.17, 0.12], turn: 5, input: [left, right], pair: 0.26}\n"
    "inputs: {left: Z, right: Slash}\n"
    "tests:\n"
    "  - {run: 1s, expect: [lane.2.bulb.hits == 0, flip.left.hits == 0]}\n";

const Node& node(const Reading& reading, std::string_view id) {
    const Node* found = reading.scene.find(id);
    INFO(id);
    REQUIRE(found);
    return *found;
}

std::string error_of(const Reading& now, const Edit& edit) {
    const auto patched = patch_for(now, std::span(&edit, 1));
    return patched ? "" : patched.error().message;
}

SetField setting(const Reading& reading, std::string_view id, std::string_view key, const Value& value) {
    const Node& it = node(reading, id);
    return {it.id, *it.type->find_field(key), value, true};
}

}  // namespace

TEST_CASE("a template's nodes stand in a group of the use's own, with its arguments and below its id") {
    const Reading reading = read(garden);
    INFO(told(reading));
    REQUIRE(reading.diagnostics.empty());
    CHECK(node(reading, "big").type->key() == "group");
    CHECK(node(reading, "big").get<Vec2>("at") == Vec2(0.3, 0.5));
    CHECK(node(reading, "big.bulb").get<double>("radius") == 0.02);
    CHECK(node(reading, "big.bulb").get<std::string>("material") == "rubber");
    CHECK(node(reading, "lane.2.bulb").get<double>("radius") == 0.009);
    CHECK(node(reading, "lane.2.bulb").get<std::string>("material") == "gold");
    const Node& box = *reading.scene.find(node(reading, "big").children[1]);
    CHECK(box.get<Vec2>("size") == Vec2(0.04, 0.046));
}

TEST_CASE("copies stand a step from each other, or round a point, and count in i") {
    const Reading reading = read(garden);
    for (int i = 1; i <= 3; ++i)
        CHECK(node(reading, fmt::format("lane.{}", i)).get<Vec2>("at") == Vec2(0.1 + 0.046 * (i - 1), 0.9));
    const Vec2 centre(0.2, 0.2);
    for (int i = 1; i <= 4; ++i) {
        const Node& pop = node(reading, fmt::format("pop.{}", i));
        CHECK(pop.get<double>("radius") == i * 0.01);
        CHECK((pop.get<Vec2>("at") - centre).norm() == Approx(0.1).epsilon(1e-14));
        CHECK(pop.get<double>("turn") == 90 * (i - 1));
    }
    CHECK(node(reading, "pop.3").get<Vec2>("at").y() == Approx(0.1));
}

TEST_CASE("a pair is reflected in its line: each point of the one is a point of the other") {
    for (const char* flip : {"none", "x", "y"})
        for (const char* shape : {"circle: {radius: 1cm}", "repeat: {count: [2, 1], step: [1cm, 0], children: [circle: {}]}"}) {
            const Reading reading = read(fmt::format(
                "pinfield: 1\nscene:\n  - group: {{id: g, at: [0.1, 0.3], turn: 33, scale: 1.5, flip: {}, pair: 0.26, children: [{}]}}\n", flip, shape));
            INFO(told(reading));
            REQUIRE(reading.ok());
            const Similarity left = world_from_local(reading.scene, node(reading, "g.left").id),
                             right = world_from_local(reading.scene, node(reading, "g.right").id);
            for (const Vec2& p : {Vec2(0, 0), Vec2(0.1, 0.02), Vec2(-0.3, 0.7)}) {
                const Vec2 a = left * p, b = right * p;
                CHECK(a.x() + b.x() == Approx(2 * 0.26).epsilon(1e-14));
                CHECK(a.y() == Approx(b.y()).epsilon(1e-14));
            }
        }
}

TEST_CASE("the one on the left is called so whichever of the two the author wrote, and the inputs are shared out") {
    const Reading reading = read(garden);
    CHECK(node(reading, "flip.left").get<Vec2>("at") == Vec2(0.17, 0.12));
    CHECK(node(reading, "flip.right").get<Vec2>("at").x() == Approx(0.35));
    CHECK(node(reading, "flip.left").get<std::vector<std::string>>("input") == std::vector<std::string>{"left"});
    CHECK(node(reading, "flip.right").get<std::vector<std::string>>("input") == std::vector<std::string>{"right"});
    const Reading mirrored = read("pinfield: 1\nscene: [circle: {id: c, at: [0.4, 0], radius: 1cm, pair: 0.26}]\n");
    CHECK(node(mirrored, "c.right").get<Vec2>("at").x() == 0.4);
    CHECK(node(mirrored, "c.left").get<Vec2>("at").x() == Approx(0.12));
}

TEST_CASE("a row of copies with a pair is reflected as a whole") {
    const Reading reading = read("pinfield: 1\nscene: [circle: {id: c, at: [0.1, 0.5], radius: 1cm, copies: {count: 3, step: [4cm, 1cm]}, pair: 0.26}]\n");
    INFO(told(reading));
    REQUIRE(reading.ok());
    for (int i = 1; i <= 3; ++i) {
        const auto place = [&](const char* side) {
            return Vec2(world_from_local(reading.scene, node(reading, fmt::format("c.{}.{}", side, i)).id) * Vec2(0, 0));
        };
        CHECK(place("left").x() == Approx(0.1 + 0.04 * (i - 1)));
        CHECK(place("right").x() == Approx(0.52 - place("left").x()));
        CHECK(place("right").y() == Approx(place("left").y()));
    }
}

TEST_CASE("templates use templates, and what is wrong inside tells every step out to the author's item") {
    const Reading reading = read(
        "pinfield: 1\n"
        "templates:\n"
        "  inner: {args: {r: }, nodes: [circle: {id: c, radius: r - 3cm}]}\n"
        "  outer: {args: {n: 2}, nodes: [use: {template: inner, id: x, with: {r: 1cm * n}, copies: {count: n, step: [1, 0]}}]}\n"
        "scene:\n"
        "  - use: {template: outer, id: good, with: {n: 4}}\n"
        "  - use: {template: outer, id: bad}\n"
        "  - use: {template: outer, id: worse}\n");
    CHECK(node(reading, "good.x.3.c").get<double>("radius") == Approx(0.01));
    REQUIRE(reading.diagnostics.size() == 1);
    const Diagnostic& found = reading.diagnostics.front();
    CHECK(found.code == "E0208");
    CHECK(reading.scene.sources.line_column(found.where).line == 3);
    REQUIRE(found.via.size() == 3);
    CHECK(found.via[0].what == "the template inner");
    CHECK(found.via[1].what == "copy 1 of x");
    CHECK(found.via[2].what == "the template outer");
    CHECK(reading.scene.sources.line_column(found.via[2].where).line == 7);
    CHECK(told(reading).find("in the template outer, asked for at test.yaml:7:5") != std::string::npos);
}

TEST_CASE("names mean what they mean where the template stands, not where it is used") {
    const Reading reading = read(
        "pinfield: 1\ntemplates: {t: {nodes: [circle: {radius: i * 1cm}]}}\n"
        "scene: [use: {template: t, copies: {count: 2}}]\n");
    CHECK(codes_and_places(reading) == std::vector<std::string>{"E0305 2:42"});
}

TEST_CASE("a table that multiplies itself is refused at the limit of nodes, however it does so") {
    std::string text = "pinfield: 1\ntemplates:\n  t0: {nodes: [circle: {radius: 1cm}]}\n";
    for (int i = 1; i < 30; ++i)
        text += fmt::format("  t{0}: {{nodes: [use: {{template: t{1}}}, use: {{template: t{1}}}]}}\n", i, i - 1);
    const Reading twice = read(text + "scene: [use: {template: t29}]\n");
    CHECK(twice.diagnostics.size() == 1);
    CHECK(twice.diagnostics.front().code == "E0110");
    Limits few;
    few.nodes = 12;
    const std::string copies = "pinfield: 1\nscene: [circle: {radius: 1cm, copies: {count: ";
    CHECK(read(copies + "11}}]\n", few).ok());
    CHECK(read(copies + "12}}]\n", few).diagnostics.front().code == "E0110");
    std::string chain = "pinfield: 1\ntemplates:\n  t0: {nodes: [circle: {radius: 1cm}]}\n";
    for (int i = 1; i < 100; ++i) chain += fmt::format("  t{}: {{nodes: [use: {{template: t{}}}]}}\n", i, i - 1);
    CHECK(read(chain + "scene: [use: {template: t60}]\n").ok());
    CHECK(read(chain + "scene: [use: {template: t99}]\n").diagnostics.front().code == "E0107");
}

TEST_CASE("the canonical form keeps params, templates, copies and pairs, and is its own canonical form") {
    const Reading reading = read(garden);
    const std::string canonical = write_table(reading.scene);
    const Reading again = read(canonical);
    INFO(canonical << told(again));
    REQUIRE(again.ok());
    CHECK(same_content(again.scene, reading.scene));
    CHECK(write_table(again.scene) == canonical);
}

TEST_CASE("what is expanded reads as plain nodes, and its tests still mean the same ones") {
    const Reading reading = read(garden);
    const std::string text = write_table(expanded(reading.scene));
    INFO(text);
    const Reading plain = read(text);
    INFO(told(plain));
    REQUIRE(plain.diagnostics.empty());
    CHECK(plain.scene.params.empty());
    CHECK(plain.scene.all().size() == reading.scene.all().size());
    CHECK(plain.scene.find("lane_2_bulb")->get<double>("radius") == 0.009);
    CHECK(plain.scene.tests[0].expectations[0].quantity == "lane_2_bulb.hits");
    CHECK(text.find("# copy 2 of lane") != std::string::npos);
    CHECK(write_table(expanded(plain.scene)) == write_table(plain.scene));
}

TEST_CASE("no edit changes one node of a template by itself: it says where the node is made") {
    const Reading reading = read(garden);
    const NodeId bulb = node(reading, "lane.2.bulb").id, lane = node(reading, "lane").id, big = node(reading, "big").id;
    CHECK(error_of(reading, setting(reading, "lane.2.bulb", "radius", 0.02)).find("lane.2.bulb is made by the template lamp (line 11)") == 0);
    for (const Edit& edit : {Edit(Remove{bulb}), Edit(Move{bulb, {}, 0}), Edit(Rename{bulb, "lane.2.bulb", "x"}), Edit(Unwrap{lane}), Edit(Unwrap{big}),
                             Edit(setting(reading, "lane", "at", Vec2(0, 0))), Edit(setting(reading, "lane.2", "at", Vec2(0, 0)))})
        CHECK_FALSE(error_of(reading, edit).empty());
}

TEST_CASE("a use is placed, renamed, moved and removed like any node, and nothing else of the text changes") {
    const Reading reading = read(garden);
    const auto edited = [&](const Edit& edit) {
        const auto patched = patch_for(reading, std::span(&edit, 1));
        INFO((patched ? "" : patched.error().message));
        REQUIRE(patched);
        CHECK(patched->reading.ok());
        return patched->reading.source().text();
    };
    const auto replaced = [&](const std::string& from, const std::string& to) {
        std::string text = garden;
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
        return text;
    };
    CHECK(edited(setting(reading, "big", "at", Vec2(0.31, 0.5))) == replaced("[0.3, 0.5]", "[0.31, 0.5]"));
    CHECK(edited(Rename{node(reading, "big").id, "big", "sun"}) == replaced("id: big", "id: sun"));
    CHECK(edited(Rename{node(reading, "lane").id, "lane", "row"}) == replaced("lane.2", "row.2").replace(garden.find("id: lane") + 4, 4, "row"));
    const std::string line = "  - use: {template: lamp, id: big, at: [0.3, 0.5], with: {r: 2cm, tint: rubber}}  # the large one\n";
    CHECK(edited(Remove{node(reading, "big").id}) == replaced(line, ""));
    std::string moved = replaced(line, "");
    moved.insert(moved.find("  - use: {template: lamp, id: lane"), line);
    CHECK(edited(Move{node(reading, "big").id, {}, 0}) == moved);
}

TEST_CASE("an argument's default may be made of the arguments before it, as the use gives them, and of no later ones") {
    const std::string text =
        "pinfield: 1\nparams: {gap: 1cm}\nmaterials: {rubber: {}, gold: {}}\n"
        "templates:\n  gear:\n    args: {r: 4cm, hub: r / 4 + gap, skin: gold, rim: $skin}\n"
        "    nodes: [circle: {id: wheel, radius: r, material: $rim}, circle: {id: axle, radius: hub}]\n"
        "scene:\n  - use: {template: gear, id: a}\n  - use: {template: gear, id: b, with: {r: 2cm, skin: rubber}}\n"
        "  - use: {template: gear, id: c, with: {hub: 5mm, rim: gold}}\n";
    const Reading reading = read(text);
    INFO(told(reading));
    REQUIRE(reading.ok());
    CHECK(node(reading, "a.axle").get<double>("radius") == 0.02);
    CHECK(node(reading, "b.axle").get<double>("radius") == 0.015);
    CHECK(node(reading, "c.axle").get<double>("radius") == 0.005);
    CHECK(node(reading, "b.wheel").get<std::string>("material") == "rubber");
    CHECK(codes_and_places(read("pinfield: 1\ntemplates: {t: {args: {hub: r / 4, r: 4cm}, nodes: [circle: {radius: hub + r}]}}\nscene: [use: {template: t}]\n")) ==
          std::vector<std::string>{"E0305 2:29"});
}

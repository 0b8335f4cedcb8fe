// Edits of the author's text: minimal, proven, and taken back byte for byte.
#include "engine/io/text_patch.h"

#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

/// Takes the patches back, from the last to the first, given the text before them.
std::string taken_back(const std::vector<TextPatch>& patches, const std::string& before) {
    std::vector<std::string> texts{before};
    for (const TextPatch& patch : patches) texts.push_back(pinfield::apply(patch, texts.back()));
    std::string text = texts.back();
    for (std::size_t i = patches.size(); i-- > 0;) {
        const Span replaced = patches[i].replaced.span;
        text.replace(replaced.begin, patches[i].text.size(), texts[i].substr(replaced.begin, replaced.end - replaced.begin));
    }
    return text;
}

int field_index(const Node& node, std::string_view key) { return *node.type->find_field(key); }

/// The text after an edit of one field of the node at a path.
std::string edited(const std::string& text, std::string_view path, std::string_view key, const Value& value,
                   bool is_explicit = true) {
    const Reading before = read(text);
    INFO(told(before));
    REQUIRE(before.ok());
    const Node* node = path == "physics" ? &before.scene.physics()
                       : path == "table" ? &before.scene.table()
                                         : before.scene.find(path);
    if (!node)
        for (const NodeId id : before.scene.materials())
            if (before.scene.find(id)->name == path) node = before.scene.find(id);
    REQUIRE(node);
    const Edit edit = SetField{node->id, field_index(*node, key), value, is_explicit};
    const auto patched = patch_for(before, std::span(&edit, 1));
    if (!patched) return "refused: " + patched.error().message;
    CHECK(patched->readings <= 1);
    CHECK(taken_back(patched->patches, text) == text);
    return patched->reading.source().text();
}

std::string in_scene(const std::string& lines) { return "pinfield: 1\nscene:\n" + lines; }

std::string edited_node(const std::string& lines, std::string_view path, std::string_view key, const Value& value,
                        bool is_explicit = true) {
    const std::string after = edited(in_scene(lines), path, key, value, is_explicit), head = in_scene("");
    return after.starts_with(head) ? after.substr(head.size()) : after;
}

}  // namespace

TEST_CASE("a number keeps the author's unit, decimals and quotes") {
    CHECK(edited_node("- circle: {radius: 24mm}  # c\n", "circle[0]", "radius", 0.03) ==
          "- circle: {radius: 30mm}  # c\n");
    CHECK(edited_node("- circle: {radius: 2.40cm}\n", "circle[0]", "radius", 0.03) == "- circle: {radius: 3.00cm}\n");
    CHECK(edited_node("- circle: {radius: 0.50}\n", "circle[0]", "radius", 0.525) == "- circle: {radius: 0.525}\n");
    CHECK(edited_node("- circle: {radius: '24mm'}\n", "circle[0]", "radius", 0.0305) ==
          "- circle: {radius: '30.5mm'}\n");
    CHECK(edited_node("- circle: {radius: 1in}\n", "circle[0]", "radius", 2.5 * 0.0254) ==
          "- circle: {radius: 2.5in}\n");
    CHECK(edited_node("- circle: {radius: 1in}\n", "circle[0]", "radius", 0.1 + 0.2) != "");
}

TEST_CASE("of a pair only the component that changed is replaced") {
    CHECK(edited_node("- circle: {at: [ 0.50 , 3cm ]}\n", "circle[0]", "at", Vec2(0.5, 0.04)) ==
          "- circle: {at: [ 0.50 , 4cm ]}\n");
    CHECK(edited_node("- circle: {at: [ 0.50 , 3cm ]}\n", "circle[0]", "at", Vec2(0.25, 0.03)) ==
          "- circle: {at: [ 0.25 , 3cm ]}\n");
    CHECK(edited_node("- circle:\n    at:\n      - 1mm   # x\n      - 2\n", "circle[0]", "at", Vec2(0.002, 3)) ==
          "- circle:\n    at:\n      - 2mm   # x\n      - 3\n");
}

TEST_CASE("a point is changed, added and taken out where it stands") {
    const std::string text = "- polygon: {points: [[0, 0], [24mm, 0], [0, 1cm]]}\n";
    using Points = std::vector<Vec2>;
    CHECK(edited_node(text, "polygon[0]", "points", Points{{0, 0}, {0.025, 0}, {0, 0.01}}) ==
          "- polygon: {points: [[0, 0], [25mm, 0], [0, 1cm]]}\n");
    CHECK(edited_node(text, "polygon[0]", "points", Points{{0, 0}, {0.024, 0}, {0.5, 1}, {0, 0.01}}) ==
          "- polygon: {points: [[0, 0], [24mm, 0], [0.5, 1], [0, 1cm]]}\n");
    const std::string four =
        "- polygon:\n    points:\n      - [0, 0]\n      - [1, 0]\n      - [1, 1]\n      - [0, 1]\n";
    CHECK(edited_node(four, "polygon[0]", "points", Points{{0, 0}, {1, 0}, {0, 1}}) ==
          "- polygon:\n    points:\n      - [0, 0]\n      - [1, 0]\n      - [0, 1]\n");
}

TEST_CASE("a new field takes the style of its neighbours") {
    CHECK(edited_node("- circle: {at: [0, 1]} # c\n", "circle[0]", "radius", 0.03) ==
          "- circle: {at: [0, 1], radius: 0.03} # c\n");
    CHECK(edited_node("- circle: {}\n", "circle[0]", "radius", 0.03) == "- circle: {radius: 0.03}\n");
    CHECK(edited_node("- circle:   # c\n", "circle[0]", "radius", 0.03) == "- circle: {radius: 0.03}   # c\n");
    CHECK(edited_node("- circle: ~\n", "circle[0]", "radius", 0.03) == "- circle: {radius: 0.03}\n");
    CHECK(edited_node("- circle: {at: [0, 1],}\n", "circle[0]", "radius", 0.03) ==
          "- circle: {at: [0, 1], radius: 0.03,}\n");
    CHECK(edited_node("- circle:\n    at: [0, 1]  # here\n- half_plane: {}\n", "circle[0]", "radius", 0.03) ==
          "- circle:\n    at: [0, 1]  # here\n    radius: 0.03\n- half_plane: {}\n");
    CHECK(edited_node("- circle:\n    at: [0, 1]", "circle[0]", "radius", 0.03) ==
          "- circle:\n    at: [0, 1]\n    radius: 0.03");
    CHECK(edited_node("- circle: {\n    at: [0, 1],  # here\n    turn: 3  # there\n  }\n", "circle[0]", "radius",
                      0.03) == "- circle: {\n    at: [0, 1],  # here\n    turn: 3,  # there\n    radius: 0.03\n  }\n");
    CHECK(edited_node("- circle: {\n    at: [0, 1],\n    turn: 3, # there\n  }\n", "circle[0]", "radius", 0.03) ==
          "- circle: {\n    at: [0, 1],\n    turn: 3, # there\n    radius: 0.03,\n  }\n");
}

TEST_CASE("a new field is written in the unit of its neighbours, else of the file, so that it reads back the same") {
    CHECK(edited_node("- circle: {at: [5mm, 0]}\n", "circle[0]", "radius", 0.03) ==
          "- circle: {at: [5mm, 0], radius: 30mm}\n");
    CHECK(edited_node("- circle: {radius: 1cm}\n", "circle[0]", "at", Vec2(0.012, 0)) ==
          "- circle: {at: [1.2cm, 0cm], radius: 1cm}\n");
    CHECK(edited_node("- circle: {at: [0.1, 0.2]}\n- circle: {radius: 3mm}\n", "circle[0]", "radius", 0.03) ==
          "- circle: {at: [0.1, 0.2], radius: 0.03}\n- circle: {radius: 3mm}\n");
    CHECK(edited_node("- circle: {}\n- circle: {radius: 3mm}\n- box: {round: 1mm, at: [0.1, 0]}\n", "circle[0]",
                      "radius", 0.0305) ==
          "- circle: {radius: 30.5mm}\n- circle: {radius: 3mm}\n- box: {round: 1mm, at: [0.1, 0]}\n");
    CHECK(edited_node("- circle: {radius: 3mm}\n", "circle[0]", "turn", 3.0) == "- circle: {radius: 3mm, turn: 3}\n");
    // A length that inches cannot say to the last bit is written without them.
    CHECK(edited_node("- circle: {at: [1in, 0]}\n", "circle[0]", "radius", 0.1 + 0.2).find("refused") ==
          std::string::npos);
}

TEST_CASE("a new field stands before the children") {
    CHECK(edited_node("- union:\n    # two\n    children:\n    - circle: {}\n", "union[0]", "turn", 3.0) ==
          "- union:\n    # two\n    turn: 3\n    children:\n    - circle: {}\n");
    CHECK(edited_node("- union:\n    id: u\n    children: [circle: {}]\n", "u", "turn", 3.0) ==
          "- union:\n    id: u\n    turn: 3\n    children: [circle: {}]\n");
    CHECK(edited_node("- union: {id: u, children: [circle: {}]}\n", "u", "turn", 3.0) ==
          "- union: {id: u, turn: 3, children: [circle: {}]}\n");
    CHECK(edited_node("- union: {children: [circle: {}]}\n", "union[0]", "turn", 3.0) ==
          "- union: {turn: 3, children: [circle: {}]}\n");
}

TEST_CASE("a field that is no longer given leaves no trace") {
    CHECK(edited_node("- circle: {turn: 0, radius: 3cm}\n", "circle[0]", "turn", 0.0, false) ==
          "- circle: {radius: 3cm}\n");
    CHECK(edited_node("- circle: {radius: 3cm, turn: 0}\n", "circle[0]", "turn", 0.0, false) ==
          "- circle: {radius: 3cm}\n");
    CHECK(edited_node("- circle: {turn: 0}\n", "circle[0]", "turn", 0.0, false) == "- circle: {}\n");
    CHECK(edited_node("- circle:\n    radius: 3cm\n    turn: 0  # gone\n", "circle[0]", "turn", 0.0, false) ==
          "- circle:\n    radius: 3cm\n");
    CHECK(edited_node("- circle:\n    turn: 0\n    radius: 3cm\n", "circle[0]", "turn", 0.0, false) ==
          "- circle:\n    radius: 3cm\n");
    CHECK(edited_node("- circle: {\n    radius: 3cm,  # kept\n    turn: 0\n  }\n", "circle[0]", "turn", 0.0, false) ==
          "- circle: {\n    radius: 3cm,  # kept\n  }\n");
    CHECK(edited_node("- circle: {turn: 3}\n", "circle[0]", "turn", 0.0, false) == "- circle: {}\n");
    CHECK(edited_node("- circle: {turn: 3}\n", "circle[0]", "turn", 1.0, false).starts_with("refused"));
}

TEST_CASE("texts are quoted only where YAML would misread them") {
    CHECK(edited("pinfield: 1\ntable: {name: Moon}\nscene: []\n", "table", "name", std::string("Moon rise")) ==
          "pinfield: 1\ntable: {name: Moon rise}\nscene: []\n");
    CHECK(edited("pinfield: 1\ntable: {name: Moon}\nscene: []\n", "table", "name", std::string("a, b")) ==
          "pinfield: 1\ntable: {name: \"a, b\"}\nscene: []\n");
    CHECK(edited("pinfield: 1\ntable: {name: 'Moon'}\nscene: []\n", "table", "name", std::string("it's")) ==
          "pinfield: 1\ntable: {name: 'it''s'}\nscene: []\n");
}

TEST_CASE("a record that the text does not mention gets a section of its own") {
    CHECK(edited("pinfield: 1\nscene: []\n", "physics", "step", 0.002) ==
          "pinfield: 1\nphysics: {step: 0.002}\nscene: []\n");
    CHECK(edited("pinfield: 1\r\ntable: {name: x} # t\r\nscene: []\r\n", "physics", "step", 0.002) ==
          "pinfield: 1\r\ntable: {name: x} # t\r\nphysics: {step: 0.002}\r\nscene: []\r\n");
}

TEST_CASE("what several places share is not changed behind the author's back") {
    const std::string text =
        in_scene("- circle: &c {radius: 3cm}\n- circle: *c\n- box: {at: &p [0, 1]}\n- box: {at: *p, turn: &t 3}\n");
    CHECK(edited(text, "circle[0]", "radius", 0.05).starts_with("refused: the value is shared by 2 places"));
    CHECK(edited(text, "circle[1]", "radius", 0.05).starts_with("refused: the value "));
    CHECK(edited(text, "box[0]", "at", Vec2(0, 2)).starts_with("refused: the value is shared"));
    CHECK(edited(text, "box[1]", "at", Vec2(0, 2)).starts_with("refused: the value stands for"));
    CHECK(edited(text, "box[1]", "turn", 4.0).find("turn: &t 4}") != std::string::npos);
}

TEST_CASE("an edit that the scene refuses makes no patch") {
    CHECK(edited_node("- circle: {radius: 3cm}\n", "circle[0]", "radius", -1.0).starts_with("refused"));
    CHECK(edited_node("- circle: {id: a}\n- circle: {id: b}\n", "a", "id", std::string("b")).starts_with("refused"));
    CHECK(edited_node("- circle: {id: a}\n", "a", "material", std::string("nosuch")).starts_with("refused"));
}

TEST_CASE("edits of many nodes cost one reading, and change what each of them alone would") {
    std::string lines, moved;
    for (int i = 0; i < 40; ++i) {
        lines += "- circle: {at: [" + std::to_string(i) + "mm, 2cm], radius: 3mm}  # " + std::to_string(i) + "\n";
        moved += "- circle: {at: [" + std::to_string(i + 5) + "mm, 3cm], radius: 3mm}  # " + std::to_string(i) + "\n";
    }
    Reading before = read(in_scene(lines));
    REQUIRE(before.ok());
    Scene older(catalog());
    for (int i = 0; i < 7; ++i) older.add(*catalog()->find("bumper"));
    before.scene.keep_ids_of(older);  // ids that no fresh reading would give
    std::vector<Edit> edits;
    for (int i = 0; i < 40; ++i) {
        const Node& node = *before.scene.find(at(before.scene.roots(), i));
        edits.emplace_back(SetField{node.id, field_index(node, "at"), Vec2((i + 5) / 1000.0, 0.03), true});
    }
    const auto patched = patch_for(before, edits);
    REQUIRE(patched);
    CHECK(patched->reading.source().text() == in_scene(moved));
    CHECK(patched->readings == 1);
    CHECK(patched->reading.scene.roots() == before.scene.roots());
}

TEST_CASE("edits that touch the same bytes are written one after the other") {
    const Reading before = read(in_scene("- circle: {}\n- box: {turn: 0, scale: 1}\n"));
    REQUIRE(before.ok());
    const Node &circle = *before.scene.find("circle[0]"), &box = *before.scene.find("box[0]");
    std::vector<Edit> edits;
    const auto set = [&](const Node& node, std::string_view key, const Value& value, bool is_explicit = true) {
        edits.emplace_back(SetField{node.id, field_index(node, key), value, is_explicit});
    };
    set(circle, "radius", 0.03);
    set(circle, "turn", 4.0);
    set(box, "turn", 0.0, false);
    set(box, "scale", 1.0, false);
    set(circle, "radius", 0.04);
    set(before.scene.physics(), "step", 0.002);
    set(box, "id", std::string("b"));
    set(circle, "id", std::string("c"));
    const auto patched = patch_for(before, edits);
    REQUIRE(patched);
    CHECK(patched->reading.source().text() ==
          "pinfield: 1\nphysics: {step: 0.002}\nscene:\n- circle: {id: c, radius: 0.04, turn: 4}\n- box: {id: b}\n");
    CHECK(patched->readings > 1);
    CHECK(taken_back(patched->patches, before.source().text()) == before.source().text());
    CHECK(patched->reading.scene.find("c")->id == circle.id);
}

TEST_CASE("an edit that is valid only after one that waits waits with it") {
    const Reading before = read(in_scene("- box: {round: 1mm}\n"));
    const Node& box = *before.scene.find("box[0]");
    std::vector<Edit> edits;
    const auto set = [&](std::string_view key, const Value& value) { edits.emplace_back(SetField{box.id, field_index(box, key), value, true}); };
    set("turn", 4.0);
    set("size", Vec2(3, 3));
    set("round", 1.0);  // too round for the box as it was
    REQUIRE(why_invalid(before.scene, edits.back()));
    const auto patched = patch_for(before, edits);
    REQUIRE(patched);
    CHECK(patched->reading.source().text() == in_scene("- box: {round: 1000mm, turn: 4, size: [3000mm, 3000mm]}\n"));
}

TEST_CASE("of edits one of which is refused none is written") {
    const Reading before = read(in_scene("- circle: {id: a, radius: 3cm}\n- circle: {id: b, radius: 3cm}\n"));
    const NodeId a = before.scene.find("a")->id, b = before.scene.find("b")->id;
    const int radius = field_index(*before.scene.find(a), "radius");
    std::vector<Edit> edits;
    edits.emplace_back(SetField{a, radius, 0.04, true});
    edits.emplace_back(SetField{b, radius, -0.04, true});
    const auto patched = patch_for(before, edits);
    REQUIRE_FALSE(patched);
    CHECK(patched.error().message == "radius must be above 0 m");
}

TEST_CASE("any fields of any nodes of every good table can be patched at once, and undoing it all restores every byte") {
    for (const auto& [name, original] : good_tables()) {
        INFO(name);
        CounterRng rng(7);
        Reading now = read(original);
        std::vector<std::pair<std::vector<TextPatch>, std::string>> done;  // patches and the text before them
        int patched = 0, refused = 0;
        std::string reasons;
        for (int i = 0; i < 60; ++i) {
            INFO(told(now));
            REQUIRE(now.ok());
            std::vector<Edit> edits;
            Scene expected = now.scene;
            for (int k = 0; k < 1 + i % 3; ++k)
                if (auto edit = some_edit(expected, rng)) {
                    pinfield::apply(expected, *edit);
                    edits.emplace_back(std::move(*edit));
                }
            auto result = patch_for(now, edits);
            if (!result) {
                ++refused;
                for (const Edit& edit : edits) {
                    const auto& field = std::get<SetField>(edit);
                    reasons += now.scene.path(field.node) + "." + std::string(at(now.scene.find(field.node)->type->fields, field.field).key) + " ";
                }
                reasons += ": " + result.error().message + "\n";
                continue;
            }
            ++patched;
            CHECK(same_content(result->reading.scene, expected));
            for (const NodeId id : expected.all()) CHECK(result->reading.scene.path(id) == expected.path(id));
            done.emplace_back(std::move(result->patches), now.source().text());
            now = std::move(result->reading);
        }
        INFO(reasons << now.source().text());
        CHECK(patched > 0);
        CHECK(refused <= patched / 10);
        for (auto it = done.rbegin(); it != done.rend(); ++it) REQUIRE(taken_back(it->first, it->second) == it->second);
    }
}

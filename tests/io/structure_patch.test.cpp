// Structural edits of the author's text: whole items move, with the comments that belong to them, and nothing else changes.
#include "engine/io/structure_patch.h"

#include <catch2/catch.hpp>
#include <map>

#include "engine/core/at.h"
#include "engine/io/fragment.h"
#include "engine/io/text_patch.h"
#include "engine/io/yaml_items.h"
#include "tests/io/random_table.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

std::string in_scene(const std::string& lines) { return "pinfield: 1\nscene:\n" + lines; }

NodeId id_of(const Reading& now, std::string_view path) {
    const Node* node = path.empty() ? nullptr : now.scene.find(path);
    INFO(path);
    REQUIRE((path.empty() || node));
    return node ? node->id : NodeId{};
}

/// The text after an edit, which must read back as the scene that the edit makes, and can be taken back.
std::string after(const Reading& now, const Edit& edit) {
    const auto patched = patch_for(now, std::span(&edit, 1));
    if (!patched) return "refused: " + patched.error().message;
    return patched->reading.source().text();
}

std::string removed(const std::string& text, std::string_view path) {
    const Reading now = read(text);
    INFO(told(now));
    REQUIRE(now.ok());
    return after(now, Remove{id_of(now, path)});
}

std::string moved(const std::string& text, std::string_view path, std::string_view parent, int index) {
    const Reading now = read(text);
    INFO(told(now));
    REQUIRE(now.ok());
    return after(now, Move{id_of(now, path), id_of(now, parent), index});
}

std::string inserted(const std::string& text, std::string_view parent, int index, const std::string& what) {
    const Reading now = read(text);
    INFO(told(now));
    REQUIRE(now.ok());
    const auto fragments = read_fragments(what, now);
    if (!fragments) return "unread: " + fragments.error().message;
    return after(now, Insert{id_of(now, parent), index, now.scene.with_new_ids(fragments->front().nodes), fragments->front().text});
}

Node new_node(const Scene& scene, std::string_view type) {
    Scene other(catalog());
    const NodeId id = other.add(*catalog()->find(type)).id;
    return scene.with_new_ids(other.copy(id)).front();
}

std::string wrapped(const std::string& text, std::string_view parent, int first, int count, std::string_view type) {
    const Reading now = read(text);
    INFO(told(now));
    REQUIRE(now.ok());
    return after(now, Wrap{id_of(now, parent), first, count, new_node(now.scene, type)});
}

std::string unwrapped(const std::string& text, std::string_view path) {
    const Reading now = read(text);
    REQUIRE(now.ok());
    return after(now, Unwrap{id_of(now, path)});
}

std::string renamed(const std::string& text, std::string_view path, const std::string& to) {
    const Reading now = read(text);
    INFO(told(now));
    REQUIRE(now.ok());
    const NodeId id = id_of(now, path);
    return after(now, Rename{id, now.scene.find(id)->name, to, true});
}

std::string became(const std::string& text, std::string_view path, std::string_view type) {
    const Reading now = read(text);
    REQUIRE(now.ok());
    return after(now, retyped(now.scene, id_of(now, path), *catalog()->find(type)));
}

}  // namespace

TEST_CASE("a node is taken out with its lines and the comments that belong to it") {
    const std::string text = in_scene("  # walls\n\n  # the first\n  - circle: {id: a}  # behind a\n  # of b\n  - circle:\n      id: b\n    # in b\n  - circle: {id: c}\n");
    CHECK(removed(text, "a") == in_scene("  # walls\n\n  # of b\n  - circle:\n      id: b\n    # in b\n  - circle: {id: c}\n"));
    CHECK(removed(text, "b") == in_scene("  # walls\n\n  # the first\n  - circle: {id: a}  # behind a\n  - circle: {id: c}\n"));
    CHECK(removed(text, "c") == in_scene("  # walls\n\n  # the first\n  - circle: {id: a}  # behind a\n  # of b\n  - circle:\n      id: b\n    # in b\n"));
    CHECK(removed(in_scene("- circle: {id: a}\n- circle: {id: b}"), "b") == in_scene("- circle: {id: a}"));
    CHECK(removed("pinfield: 1\nscene: [circle: {id: a}, {circle: {id: b}}, circle: {id: c}]\n", "b") ==
          "pinfield: 1\nscene: [circle: {id: a}, circle: {id: c}]\n");
}

TEST_CASE("a list that nothing is left in stays one") {
    CHECK(removed(in_scene("- group:\n    id: g\n    children:  # none yet\n      # first\n      - circle: {id: a}\n- circle: {id: z}\n"), "a") ==
          in_scene("- group:\n    id: g\n    children: []  # none yet\n- circle: {id: z}\n"));
    CHECK(removed(in_scene("- group: {children: [circle: {id: a}]}\n- circle: {}\n"), "a") == in_scene("- group: {children: []}\n- circle: {}\n"));
    CHECK(removed(in_scene("- union:\n    children:\n    - circle: {id: a}\n"), "a").starts_with("refused: union takes"));
}

TEST_CASE("what tests count is not taken out") {
    const std::string text = in_scene("- circle: {id: a}\n") + "tests:\n  - {run: 1s, expect: [a.hits == 0]}\n";
    CHECK(removed(text, "a") == "refused: a test of the table expects a.hits == 0: take that out first");
}

TEST_CASE("a node moves with its comments, between styles of lists, and keeps its own text") {
    const std::string text = in_scene("- circle: {id: a}  # behind a\n# of b\n- circle: {id: b}\n- group:\n    id: g\n    children:\n      - box: {id: in}\n");
    CHECK(moved(text, "b", "", 0) == in_scene("# of b\n- circle: {id: b}\n- circle: {id: a}  # behind a\n- group:\n    id: g\n    children:\n      - box: {id: in}\n"));
    CHECK(moved(text, "a", "", 2) == in_scene("# of b\n- circle: {id: b}\n- group:\n    id: g\n    children:\n      - box: {id: in}\n- circle: {id: a}  # behind a\n"));
    CHECK(moved(text, "a", "g", 0) == in_scene("# of b\n- circle: {id: b}\n- group:\n    id: g\n    children:\n      - circle: {id: a}  # behind a\n      - box: {id: in}\n"));
    CHECK(moved(text, "in", "", 0) == in_scene("- box: {id: in}\n- circle: {id: a}  # behind a\n# of b\n- circle: {id: b}\n- group:\n    id: g\n    children: []\n"));
    const std::string flow = in_scene("- circle: {id: a, radius: 3.0cm}\n- group: {id: g, children: [box: {id: in}]}\n");
    CHECK(moved(flow, "a", "g", 1) == in_scene("- group: {id: g, children: [box: {id: in}, circle: {id: a, radius: 3.0cm}]}\n"));
    CHECK(moved(flow, "in", "", 2) == in_scene("- circle: {id: a, radius: 3.0cm}\n- group: {id: g, children: []}\n- box: {id: in}\n"));
    CHECK(moved(text, "g", "g", 0).starts_with("refused: a node cannot be put into itself"));
    CHECK(moved(in_scene("- circle: {id: a}\n- circle: {id: b}"), "a", "", 1) == in_scene("- circle: {id: b}\n- circle: {id: a}"));
}

TEST_CASE("a node goes into a group that is empty or held none before") {
    const std::string head = "- circle: {id: a}  # of a\n";
    CHECK(moved(in_scene(head + "- group: {id: g}  # of g\n"), "a", "g", 0) ==
          in_scene("- group:  # of g\n    id: g\n    children:\n    - circle: {id: a}  # of a\n"));
    CHECK(moved(in_scene(head + "- group: {id: g, children: []}\n"), "a", "g", 0) ==
          in_scene("- group:\n    id: g\n    children:\n    - circle: {id: a}  # of a\n"));
    CHECK(moved(in_scene(head + "- group:\n    id: g\n    turn: 3  # t\n- box: {}\n"), "a", "g", 0) ==
          in_scene("- group:\n    id: g\n    turn: 3  # t\n    children:\n    - circle: {id: a}  # of a\n- box: {}\n"));
    CHECK(moved(in_scene(head + "- group:\n"), "a", "group[0]", 0) == in_scene("- group:\n    children:\n    - circle: {id: a}  # of a\n"));
    CHECK(inserted("pinfield: 1\nscene: []\n", "", 0, "- circle: {}") == "pinfield: 1\nscene:\n  - circle: {}\n");
    CHECK(inserted("pinfield: 1\r\nscene:\r\n", "", 0, "- circle: {}\n") == "pinfield: 1\r\nscene:\r\n  - circle: {}\r\n");
}

TEST_CASE("a pasted node keeps its comments and takes the place's indentation and line breaks") {
    const std::string text = "pinfield: 1\r\nscene:\r\n    - circle: {id: a}\r\n    - circle: {id: b}\r\n";
    CHECK(inserted(text, "", 1, "# new\n- group:\n    children:\n    - box: {}  # b\n") ==
          "pinfield: 1\r\nscene:\r\n    - circle: {id: a}\r\n    # new\r\n    - group:\r\n        children:\r\n        - box: {}  # b\r\n    - circle: {id: b}\r\n");
    CHECK(inserted(text, "", 2, "circle: {id: c}") == text + "    - circle: {id: c}\r\n");
    CHECK(inserted(text, "", 0, "- circle: {id: a}") == "refused: the id a is taken");
    CHECK(inserted(text, "", 0, "- circle: {material: rubbr}").starts_with("refused: no material is called rubbr"));
    CHECK(inserted(text, "", 0, "- circle: {radius: -1}") == "unread: line 1, column 20: -1 must be above 0 m");
    CHECK(inserted(text, "", 0, "hello").starts_with("unread: line 1, column 1"));
    CHECK(inserted(text, "a", 0, "- circle: {}") == "refused: circle takes no children");
}

TEST_CASE("a new node is written in the units and the style of its neighbours") {
    const Reading now = read(in_scene("- group:\n   id: g\n   children:\n   - circle: {radius: 3cm}\n"));
    REQUIRE(now.ok());
    Node node = new_node(now.scene, "circle");
    const auto set = [&](std::string_view key, const Value& value) { at(node.fields, *node.type->find_field(key)) = {value, true, {}}; };
    set("radius", 0.025);
    set("at", Vec2(0.1, 0));
    CHECK(after(now, Insert{id_of(now, "g"), 1, {node}}) ==
          in_scene("- group:\n   id: g\n   children:\n   - circle: {radius: 3cm}\n   - circle: {at: [10cm, 0cm], radius: 2.5cm}\n"));
}

TEST_CASE("neighbours are put into an operator, and taken out of it, with all their comments") {
    const std::string text = in_scene("- circle: {id: a}\n# of b\n- circle: {id: b}  # behind\n- circle:\n    id: c\n- box: {}\n");
    const std::string in_union =
        in_scene("- circle: {id: a}\n- union:\n    children:\n    # of b\n    - circle: {id: b}  # behind\n    - circle:\n        id: c\n- box: {}\n");
    CHECK(wrapped(text, "", 1, 2, "union") == in_union);
    CHECK(unwrapped(in_union, "union[0]") == text);
    CHECK(wrapped("pinfield: 1\nscene: [circle: {}, box: {}]\n", "", 0, 2, "difference") ==
          "pinfield: 1\nscene: [difference: {children: [circle: {}, box: {}]}]\n");
    CHECK(unwrapped(in_scene("# the pair\n- group:  # head\n    id: g  # name\n    # kids\n    children:\n    - circle: {}\n    - box: {}\n"), "g") ==
          in_scene("# the pair\n# head\n# name\n# kids\n- circle: {}\n- box: {}\n"));
    CHECK(wrapped(text, "", 0, 1, "circle").starts_with("refused: circle takes no children"));
}

TEST_CASE("a name is changed together with all that refers to it, and nothing else is") {
    const std::string text = "pinfield: 1\nmaterials:\n  rubber: {restitution: 0.8}  # rubber\nscene:\n- circle: {id: pop, material: 'rubber'}  # pop\n"
                             "- box: {id: popper, at: [1, 1]}\ninputs: {left: Z}\ntests:\n  - {run: 1s, expect: [pop.hits == 0, 'popper.hits == 0']}\n";
    std::string pop = text;
    pop.replace(pop.find("pop,"), 3, "thumper");
    pop.replace(pop.find("[pop"), 4, "[thumper");
    CHECK(renamed(text, "pop", "thumper") == pop);
    std::string gum = text;
    gum.replace(gum.find("rubber:"), 6, "gum");
    gum.replace(gum.find("'rubber'"), 8, "'gum'");
    const Reading now = read(text);
    CHECK(after(now, Rename{now.scene.materials().front(), "rubber", "gum", true}) == gum);
    CHECK(renamed(text, "pop", "popper") == "refused: the id popper is taken");
    CHECK(renamed(text, "pop", "left") == "refused: the id left is taken");
    CHECK(renamed(text, "pop", "").starts_with("refused: a test of the table expects"));
    const Reading bats = read("pinfield: 1\nscene:\n- flipper: {input: [left]}\n- flipper: {at: [1, 1], input: [left]}\ninputs:\n  left: Z  # left\n"
                              "tests:\n- {inputs: {left: 1s}, expect: [escaped == 0]}\n");
    INFO(told(bats));
    REQUIRE(bats.ok());
    CHECK(after(bats, Rename{{}, "left", "links", true}) ==
          "pinfield: 1\nscene:\n- flipper: {input: [links]}\n- flipper: {at: [1, 1], input: [links]}\ninputs:\n  links: Z  # left\n"
          "tests:\n- {inputs: {links: 1s}, expect: [escaped == 0]}\n");
}

TEST_CASE("a node becomes one of another type and keeps what both have") {
    CHECK(became(in_scene("- union: {id: u, children: [circle: {}, box: {}]}  # c\n"), "u", "difference") ==
          in_scene("- difference: {id: u, children: [circle: {}, box: {}]}  # c\n"));
    CHECK(became(in_scene("- smooth_union:\n    id: u\n    k: 3mm  # soft\n    children: [circle: {}, box: {}]\n"), "u", "union") ==
          in_scene("- union:\n    id: u\n    children: [circle: {}, box: {}]\n"));
    CHECK(became(in_scene("- circle: {id: c, radius: 3mm, at: [1, 2]}\n"), "c", "bumper") == in_scene("- bumper: {id: c, radius: 3mm, at: [1, 2]}\n"));
    CHECK(became(in_scene("- circle: {id: c, radius: 3mm}\n"), "c", "polygon") == "refused: polygon needs points");
    CHECK(became(in_scene("- circle: {id: c}\n"), "c", "union").starts_with("refused: union takes"));
}

TEST_CASE("materials come and go as their lines") {
    const Reading now = read("pinfield: 1\nmaterials:\n  rubber: {restitution: 0.8}  # r\nscene:\n- circle: {material: rubber}\n");
    REQUIRE(now.ok());
    Scene other(catalog());
    Node& steel = other.add_material("steel");
    at(steel.fields, *steel.type->find_field("restitution")) = {0.5, true, {}};
    const Insert add{{}, 1, now.scene.with_new_ids(other.copy(steel.id))};
    CHECK(after(now, add) == "pinfield: 1\nmaterials:\n  rubber: {restitution: 0.8}  # r\n  steel: {restitution: 0.5}\nscene:\n- circle: {material: rubber}\n");
    CHECK(after(now, Remove{now.scene.materials().front()}).starts_with("refused: no material is called rubber"));
    const Reading none = read("pinfield: 1\nscene:\n- circle: {}\n");
    CHECK(after(none, Insert{{}, 0, none.scene.with_new_ids(other.copy(steel.id))}) ==
          "pinfield: 1\nmaterials:\n  steel: {restitution: 0.5}\nscene:\n- circle: {}\n");
}

namespace {

/// Every comment of a text, as often as it stands there.
std::map<std::string, int> comments_of(const Reading& now) {
    std::map<std::string, int> out;
    const std::string& text = now.source().text();
    if (now.tree->root)
        for (const Span span : comments_in(text, {0, text.size()}, *now.tree->root)) ++out[text.substr(span.begin, span.end - span.begin)];
    return out;
}

}  // namespace

TEST_CASE("structural edits of every good table keep the comments of what stays, and can be taken back") {
    for (const auto& [name, original] : good_tables()) {
        INFO(name);
        CounterRng rng(11);
        Reading now = read(original);
        int done = 0, refused = 0;
        std::string reasons;
        for (int i = 0; i < 40; ++i) {
            INFO(told(now) << now.source().text());
            REQUIRE(now.ok());
            const std::optional<Edit> edit = some_structural_edit(now.scene, rng);
            if (!edit) break;
            Scene expected = now.scene;
            const Edit inverse = pinfield::apply(expected, *edit);
            auto patched = patch_for(now, std::span(&*edit, 1));
            if (!patched) {
                ++refused;
                reasons += std::to_string(edit->index()) + ": " + patched.error().message + "\n";
                continue;
            }
            ++done;
            CHECK(same_content(patched->reading.scene, expected));
            CHECK(patched->reading.scene.all() == expected.all());
            Scene back = expected;
            pinfield::apply(back, inverse);
            CHECK(same_content(back, now.scene));
            CHECK(back.all() == now.scene.all());
            const auto before = comments_of(now), later = comments_of(patched->reading);
            const bool takes_away = std::holds_alternative<Remove>(*edit) || std::holds_alternative<Retype>(*edit);
            INFO(patched->reading.source().text());
            if (!takes_away) CHECK(later == before);
            for (const auto& [comment, count] : later) CHECK(count <= before.at(comment));
            now = std::move(patched->reading);
        }
        INFO(reasons << now.source().text());
        CHECK(done > 0);
        CHECK(refused <= done / 5);
    }
}

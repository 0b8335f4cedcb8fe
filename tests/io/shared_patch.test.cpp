// What an anchor lends to several places: changed for all of them, or for one.
#include "engine/io/shared_patch.h"

#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "engine/io/same_content.h"
#include "engine/io/yaml_items.h"
#include "tests/io/random_table.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

std::string with(std::string text, const std::string& from, const std::string& to) {
    INFO(from);
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
}

const std::string values = R"(pinfield: 1
scene:
  - circle: {id: a, radius: &r 24mm}   # the first
  - circle: {id: b, radius: *r}
  - circle: {id: c, radius: *r, at: [0.1, 0.2]}   # the last
)";

const std::string bodies = R"(pinfield: 1
scene:
  - circle: &common   # what all have
      radius: 24mm
      at: [0.1, 0.2]
  - circle: *common
  - circle: *common
)";

SetField change(const Reading& now, std::string_view node, std::string_view field, Value value, bool is_explicit = true) {
    const Node& found = *now.scene.find(node);
    return {found.id, *found.type->find_field(field), std::move(value), is_explicit};
}

std::string text_of(const Result<PatchedText>& patched) {
    if (!patched) FAIL_CHECK(patched.error().message);
    return patched ? patched->reading.source().text() : std::string();
}

}  // namespace

TEST_CASE("how many places share a field's text is told, with the anchor's name") {
    const Reading now = read(values);
    for (const char* node : {"a", "b", "c"}) {
        const auto shared = shared_text(now, change(now, node, "radius", 0.03));
        REQUIRE(shared);
        CHECK(shared->anchor == "r");
        CHECK(shared->places == 3);
        CHECK_FALSE(shared_text(now, change(now, node, "turn", 3.0)));
    }
    const Reading other = read(bodies);
    CHECK(shared_text(other, change(other, "circle[1]", "turn", 3.0))->places == 3);
}

TEST_CASE("everywhere: the anchor's text changes and no other byte") {
    const Reading now = read(values);
    for (const char* node : {"a", "b", "c"})
        CHECK(text_of(patch_everywhere(now, change(now, node, "radius", 0.03))) == with(values, "24mm", "30mm"));
    const Reading other = read(bodies);
    for (const char* node : {"circle[0]", "circle[2]"}) {
        CHECK(text_of(patch_everywhere(other, change(other, node, "radius", 0.03))) == with(bodies, "24mm", "30mm"));
        CHECK(text_of(patch_everywhere(other, change(other, node, "turn", 30.0))) ==
              with(bodies, "[0.1, 0.2]\n", "[0.1, 0.2]\n      turn: 30\n"));
        CHECK(text_of(patch_everywhere(other, change(other, node, "at", Vec2(0, 0), false))) == with(bodies, "      at: [0.1, 0.2]\n", ""));
    }
}

TEST_CASE("everywhere is refused where another place cannot take the value, or means something else by it") {
    const Reading now = read("pinfield: 1\nscene:\n  - circle: {id: a, radius: &r 2}\n  - bumper: {id: b, kick: *r}\n");
    REQUIRE(now.ok());
    CHECK_THAT(patch_everywhere(now, change(now, "a", "radius", 3.0)).error().message, Catch::Contains("kick of b"));
}

TEST_CASE("here only: an alias becomes a value of its own") {
    const Reading now = read(values);
    CHECK(text_of(patch_here(now, change(now, "b", "radius", 0.03))) == with(values, "radius: *r}\n", "radius: 30mm}\n"));
    CHECK(text_of(patch_here(now, change(now, "c", "radius", 0.03))) == with(values, "*r, at", "30mm, at"));
}

TEST_CASE("here only: an anchor that stands here goes to the next place that names it, and away where there is but one") {
    const Reading now = read(values);
    CHECK(text_of(patch_here(now, change(now, "a", "radius", 0.03))) ==
          with(with(values, "&r 24mm", "30mm"), "radius: *r}\n", "radius: &r 24mm}\n"));
    const std::string two = with(values, "*r, at", "1mm, at");
    const Reading pair = read(two);
    CHECK(text_of(patch_here(pair, change(pair, "a", "radius", 0.03))) == with(with(two, "&r 24mm", "30mm"), "*r", "24mm"));
}

TEST_CASE("here only: of shared fields the place gets a copy in one line, and the comments stay where they are") {
    const Reading now = read(bodies);
    CHECK(text_of(patch_here(now, change(now, "circle[2]", "radius", 0.03))) ==
          bodies.substr(0, bodies.rfind("*common")) + "{radius: 30mm, at: [0.1, 0.2]}\n");
    CHECK(text_of(patch_here(now, change(now, "circle[0]", "radius", 0.03))) ==
          with(with(with(bodies, "circle: &common   #", "circle:   #"), "24mm", "30mm"), "*common",
               "&common {radius: 24mm, at: [0.1, 0.2]}"));
}

TEST_CASE("here only: whole nodes and lists that are shared are written out down to the field") {
    const std::string items =
        "pinfield: 1\nscene:\n  - &one\n    circle: {radius: 24mm}\n  - *one\n  - group: {children: &list [*one, box: {size: [1, 1]}]}\n  "
        "- group: {children: *list}\n";
    const Reading now = read(items);
    INFO(told(now));
    REQUIRE(now.ok());
    for (const char* node : {"circle[0]", "circle[1]", "group[0]/circle[0]", "group[1]/circle[0]", "group[1]/box[0]"}) {
        INFO(node);
        const bool box = std::string_view(node).ends_with("box[0]");
        const SetField edit = box ? change(now, node, "size", Vec2(2, 1)) : change(now, node, "radius", 0.03);
        Scene expected = now.scene;
        apply(expected, edit);
        const Result<PatchedText> patched = patch_here(now, edit);
        INFO(text_of(patched));
        REQUIRE(patched);
        CHECK(same_content(patched->reading.scene, expected));
        CHECK(patched->reading.scene.all() == now.scene.all());
    }
}

namespace {

/// Another value for each field whose text is shared.
std::vector<SetField> shared_fields(const Reading& now, CounterRng& rng) {
    std::vector<SetField> out;
    for (const NodeId id : now.scene.all())
        for (int i = 0; i < static_cast<int>(now.scene.find(id)->fields.size()); ++i) {
            const FieldSlot& slot = at(now.scene.find(id)->fields, i);
            SetField edit{id, i, slot.value, true};
            if (!slot.is_explicit || !shared_text(now, edit)) continue;
            edit.value = another_value(at(now.scene.find(id)->type->fields, i), slot.value, rng);
            if (!why_invalid(now.scene, edit)) out.push_back(std::move(edit));
        }
    return out;
}

}  // namespace

TEST_CASE(
    "any field of random tables is changed here or everywhere: here the tree changes by it alone, no comment is lost, and others' lines "
    "stay") {
    int here = 0, everywhere = 0, refused = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        INFO(seed);
        CounterRng rng(seed);
        const Reading now = read(random_table(rng));
        for (const SetField& field : shared_fields(now, rng)) {
            const SetField* const edit = &field;
            Scene expected = now.scene;
            apply(expected, *edit);
            const std::string& before = now.source().text();
            const auto count = [](const Reading& reading) {
                const std::string& text = reading.source().text();
                return comments_in(text, {0, text.size()}, *reading.tree->root).size();
            };
            if (const auto patched = patch_here(now, *edit)) {
                ++here;
                INFO(before << "\n--- after\n" << patched->reading.source().text());
                REQUIRE(same_content(patched->reading.scene, expected));
                REQUIRE(count(patched->reading) == count(now));
            } else {
                ++refused;
            }
            if (const auto patched = patch_everywhere(now, *edit)) {
                ++everywhere;
                const Node& node = *patched->reading.scene.find(edit->node);
                REQUIRE(identical(at(node.fields, edit->field).value, edit->value));
                REQUIRE(count(patched->reading) == count(now));
            }
        }
    }
    CHECK(here > 20);
    CHECK(everywhere > 5);
    CHECK(refused <= here / 10);
}

// A number made a param, nodes made a template, a param written out: the table stays what it was.
#include "engine/io/said_once.h"

#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "engine/io/yaml_items.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

const std::string table = R"(pinfield: 1
scene:
  - circle: {id: a, radius: 24mm, at: [10cm, 0.2]}   # the first
  # above the second
  - bumper:
      id: pop
      at: [0.3, 0.5]   # where it stands
  - group: {id: held, children: [circle: {radius: 1cm}, box: {}]}
tests:
  - {name: t, run: 1s, expect: [pop.hits == 0]}
)";

std::string text_of(const Result<PatchedText>& patched) {
    if (!patched) FAIL_CHECK(patched.error().message);
    return patched ? patched->reading.source().text() : std::string();
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    INFO(from);
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
}

Result<PatchedText> to_param(const Reading& now, std::string_view node, std::string_view field, int part, const std::string& name) {
    const Node* found = now.scene.find(node);
    REQUIRE(found);
    return patch_to_param(now, found->id, *found->type->find_field(field), part, name);
}

Result<PatchedText> to_template(const Reading& now, const std::vector<std::string>& names, const std::string& name) {
    std::vector<NodeId> nodes;
    for (const std::string& node : names) nodes.push_back(now.scene.find(node)->id);
    return patch_to_template(now, nodes, name);
}

std::vector<std::string> comments_of(const Reading& reading) {
    const std::string& text = reading.source().text();
    std::vector<std::string> out;
    for (const Span& span : comments_in(text, {0, text.size()}, *reading.tree->root)) out.push_back(text.substr(span.begin, span.end - span.begin));
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace

TEST_CASE("a number becomes a param, and its place calls it") {
    const Reading now = read(table);
    const std::string first = text_of(to_param(now, "a", "radius", 0, "large"));
    CHECK(first == with(with(table, "radius: 24mm", "radius: large"), "pinfield: 1\n", "pinfield: 1\nparams:\n  large: 24mm\n"));
    CHECK(text_of(to_param(read(first), "a", "at", 0, "left")) == with(with(first, "at: [10cm,", "at: [left,"), "  large: 24mm\n", "  large: 24mm\n  left: 10cm\n"));
    CHECK(to_param(now, "a", "radius", 0, "pop").error().message == "pop is taken");
    CHECK(to_param(now, "a", "radius", 0, "pi").error().message == "pi means something in every expression");
    CHECK(to_param(now, "a", "radius", 0, "Large").error().message.starts_with("Large is no name"));
    CHECK(to_param(read(first), "a", "radius", 0, "other").error().message == "large is no plain number");
    CHECK_FALSE(to_param(now, "a", "turn", 0, "tilt"));
    CHECK(free_name_for(now, "Pop") == "pop_2");
    CHECK(free_name_for(now, "2nd row") == "n2nd_row");
    CHECK(free_name_for(now, "pop") == "pop_2");
}

TEST_CASE("a param is written out wherever it is called, with brackets where it needs them, and words stay words") {
    const std::string once = R"yaml(pinfield: 1
params: {gap: 5cm, wide: gap + 1cm, other: {value: 2, min: 1}}   # three
scene:
  - circle: {id: a, note: gap, radius: wide / other, at: [gap, "max(gap, wide)"]}
  - box: {size: [wide * 2, wide]}
)yaml";
    CHECK(text_of(patch_inlined(read(once), "wide")) ==
          with(with(with(with(with(once, "wide: gap + 1cm, ", ""), "wide / other", "(gap + 1cm) / other"), "max(gap, wide)", "max(gap, (gap + 1cm))"),
                    "[wide * 2,", "[(gap + 1cm) * 2,"),
               ", wide]", ", gap + 1cm]"));
    CHECK_THAT(text_of(patch_inlined(read(once), "gap")), Catch::Contains("note: gap,") && Catch::Contains("at: [5cm, \"max(5cm, wide)\"]"));
    CHECK(patch_inlined(read(once), "none").error().message == "no param is called none");
}

TEST_CASE("neighbours become a template, with their ids and comments") {
    const Reading now = read(table);
    const std::string once = text_of(to_template(now, {"a", "pop"}, "pair_of"));
    CHECK(once == R"(pinfield: 1
templates:
  pair_of:
    nodes:
      - circle: {id: a, radius: 24mm, at: [10cm, 0.2]}   # the first
      # above the second
      - bumper:
          id: pop
          at: [0.3, 0.5]   # where it stands
scene:
  - use: {template: pair_of}
  - group: {id: held, children: [circle: {radius: 1cm}, box: {}]}
tests:
  - {name: t, run: 1s, expect: [pop.hits == 0]}
)");
    const std::string twice = text_of(to_template(read(once), {"held"}, "other"));
    CHECK_THAT(twice, Catch::Contains("  other:\n    nodes:\n      - group: {id: held, children: [circle: {radius: 1cm}, box: {}]}\nscene:"));
    CHECK(to_template(read(once), {"a"}, "third").error().message == "only nodes with lines of their own become a template");
    CHECK(to_template(now, {"a", "held"}, "t").error().message == "only neighbours become a template");
    CHECK(to_template(now, {"a"}, "pop").error().message == "pop is taken");
}

// Of every good table: any plain number becomes a param, which is written out again; any node of the top level becomes a template.
TEST_CASE("whatever is said once, every value stays, comments stay, and ids stay") {
    CounterRng rng(41);
    int params = 0, templates = 0, refused = 0;
    for (const auto& [name, text] : good_tables()) {
        const Reading now = read(text);
        for (const NodeId id : now.scene.all()) {
            const Node& node = *now.scene.find(id);
            INFO(name << ": " << now.scene.path(id));
            const auto field = static_cast<int>(rng.next_u64() % node.fields.size());
            if (const auto param = patch_to_param(now, id, field, 0, free_name_for(now, "turned"))) {
                INFO(param->reading.source().text());
                ++params;
                CHECK(comments_of(param->reading) == comments_of(now));
                CHECK(param->reading.scene.all() == now.scene.all());
                CHECK(identical(at(param->reading.scene.find(id)->fields, field).value, at(node.fields, field).value));
                const auto back = patch_inlined(param->reading, param->reading.scene.params.back().name);
                REQUIRE(back);
                CHECK(same_content(back->reading.scene, now.scene));
                CHECK(comments_of(back->reading) == comments_of(now));
            }
            if (node.parent || node.is_record() || node.origin) continue;
            const auto once = patch_to_template(now, std::span(&id, 1), free_name_for(now, "once"));
            if (!once) {
                ++refused;
                CHECK_FALSE(once.error().message.empty());
                continue;
            }
            ++templates;
            INFO(once->reading.source().text());
            CHECK(comments_of(once->reading) == comments_of(now));
            for (const NodeId kept : now.scene.all()) CHECK(once->reading.scene.find(kept));
        }
    }
    INFO(params << " params, " << templates << " templates, " << refused << " refused");
    CHECK(params > 50);
    CHECK(templates > 50);
    CHECK(refused < templates / 2);
}

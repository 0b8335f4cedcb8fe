// Two authors, one table: what each has changed is there, in his own words, and nobody is asked without need.
#include "engine/io/merge_text.h"

#include <rapidcheck.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "engine/core/at.h"
#include "engine/io/merge_lines.h"
#include "engine/io/same_content.h"
#include "engine/io/text_patch.h"
#include "engine/io/yaml_items.h"
#include "engine/scene/match.h"
#include "tests/io/random_table.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

const std::string table = R"(pinfield: 1          # the format
materials:
  rubber: {restitution: 0.8}   # bouncy
scene:
  # the middle one
  - bumper: {id: pop, at: [0.25, 0.70], radius: 24mm, kick: 0.8, material: rubber}
  - box: {id: shelf, at: [0.25, 300mm], size: [200mm, 0.02]}   # a shelf
  - circle: {at: [0.1, 0.1], radius: 10mm}
  - circle: {at: [0.2, 0.1], radius: 10mm}
  - group:
      id: corner
      children:
        - circle: {id: post, at: [0.01, 0.02], radius: 10mm}   # inside
  - flipper: {id: bat, at: [0.30, 0.15], input: [left]}
inputs: {left: [Z]}
)";

std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

/// As an editor has it: the nodes of both are known to be the same.
Reading edited(const Reading& base, const std::string& text) {
    Reading out = read(text);
    INFO(told(out));
    REQUIRE(out.ok());
    out.scene.take_ids(match(base.scene, out.scene), base.scene);
    return out;
}

MergedText merged(const std::string& base, const std::string& mine, const std::string& theirs, const Choices& choices = {}) {
    const Reading before = read(base);
    REQUIRE(before.ok());
    return merge_text(before, edited(before, mine), read(theirs), choices);
}

const std::string& text_of(const MergedText& merged) { return merged.reading.source().text(); }

std::vector<std::string> told_of(const MergedText& merged) {
    std::vector<std::string> out;
    for (const ToldConflict& c : merged.conflicts) out.push_back(c.what + ": " + c.base + " | " + c.mine + " | " + c.theirs);
    return out;
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("where one side has changed nothing the merged text is the other's, byte for byte") {
    const std::string changed = with(table, "kick: 0.8", "kick: 0.9") + "# mine, with no table in it\n";
    CHECK(text_of(merged(table, changed, table)) == changed);
    CHECK(text_of(merged(table, table, changed)) == changed);
    CHECK(text_of(merged(table, changed, changed)) == changed);
    CHECK(text_of(merged(table, table + "# a\n", table)) == table + "# a\n");
}

TEST_CASE("changes of different lines stay as each side wrote them, comments too") {
    const std::string mine =
        with(with(table, "size: [200mm, 0.02]", "size: [210mm, 0.02]"), "# the middle one", "# the middle one, my pride");
    const std::string theirs = with(table, "# inside\n", "# inside\n        - circle: {id: nail, radius: 1cm}  # new\n");
    const MergedText result = merged(table, mine, theirs);
    CHECK(result.refusal.empty());
    CHECK(told_of(result).empty());
    CHECK(text_of(result) ==
          with(with(theirs, "size: [200mm, 0.02]", "size: [210mm, 0.02]"), "# the middle one", "# the middle one, my pride"));
    CHECK(result.comments_left_out == 0);
}

TEST_CASE("different values on one line are both taken, each in its author's spelling") {
    const std::string mine = with(table, "kick: 0.8", "kick: 0.9"), theirs = with(table, "radius: 24mm", "radius: 2.6cm");
    const MergedText result = merged(table, mine, theirs);
    CHECK(told_of(result).empty());
    CHECK(text_of(result) == with(with(table, "kick: 0.8", "kick: 0.9"), "radius: 24mm", "radius: 2.6cm"));
}

TEST_CASE("a value that both changed is asked about with all three, and each choice is made") {
    const std::string mine = with(table, "kick: 0.8", "kick: 0.9"), theirs = with(table, "kick: 0.8", "kick: 1.2");
    const MergedText asked = merged(table, mine, theirs);
    REQUIRE(told_of(asked) == Lines{"pop: kick: 0.8 | 0.9 | 1.2"});
    CHECK(text_of(asked) == theirs);
    CHECK(text_of(merged(table, mine, theirs, {{asked.conflicts[0].conflict, Whose::mine}})) == mine);
    CHECK(text_of(merged(table, mine, theirs, {{asked.conflicts[0].conflict, Whose::theirs}})) == theirs);
    CHECK(told_of(merged(table, mine, with(table, "kick: 0.8", "kick: 0.90"))).empty());
}

TEST_CASE("what one took out and the other changed is asked about, and comes back whole") {
    const std::string shelf = "  - box: {id: shelf, at: [0.25, 300mm], size: [200mm, 0.02]}   # a shelf\n";
    const std::string gone = with(table, shelf, ""), changed = with(table, "[200mm, 0.02]", "[0.3, 0.02]");
    SECTION("taken out by me") {
        const MergedText asked = merged(table, gone, changed);
        REQUIRE(told_of(asked) == Lines{"shelf: there | taken out | changed"});
        CHECK(text_of(asked) == changed);
        CHECK(text_of(merged(table, gone, changed, {{asked.conflicts[0].conflict, Whose::mine}})) == gone);
    }
    SECTION("taken out by the other") {
        const MergedText asked = merged(table, changed, gone);
        REQUIRE(told_of(asked) == Lines{"shelf: there | changed | taken out"});
        CHECK(text_of(asked) == gone);
        CHECK(text_of(merged(table, changed, gone, {{asked.conflicts[0].conflict, Whose::mine}})) == changed);
    }
    SECTION("and not where it was not changed") {
        CHECK(told_of(merged(table, gone, with(table, "kick: 0.8", "kick: 1"))).empty());
        CHECK(text_of(merged(table, gone, with(table, "kick: 0.8", "kick: 1"))) == with(gone, "kick: 0.8", "kick: 1"));
    }
}

TEST_CASE("a group that was taken out while something was put into it is asked about") {
    const std::string gone = with(
        table, "  - group:\n      id: corner\n      children:\n        - circle: {id: post, at: [0.01, 0.02], radius: 10mm}   # inside\n",
        "");
    const std::string grown = with(table, "# inside\n", "# inside\n        - circle: {id: nail, radius: 1cm}\n");
    const MergedText asked = merged(table, gone, grown);
    REQUIRE(told_of(asked) == Lines{"corner: there | taken out | changed"});
    CHECK(asked.reading.scene.find("nail"));
    CHECK(text_of(merged(table, gone, grown, {{asked.conflicts[0].conflict, Whose::mine}})) == gone);
}

TEST_CASE("nodes without ids are known by what they say and by their order") {
    const std::string theirs = with(table, "  - circle: {at: [0.1, 0.1], radius: 10mm}\n",
                                    "  - circle: {at: [0.3, 0.3], radius: 3mm}\n  - circle: {at: [0.1, 0.1], radius: 10mm}\n");
    const std::string mine = with(table, "{at: [0.2, 0.1], radius: 10mm}", "{at: [0.2, 0.1], radius: 12mm}");
    const MergedText result = merged(table, mine, theirs);
    CHECK(told_of(result).empty());
    CHECK(text_of(result) == with(theirs, "{at: [0.2, 0.1], radius: 10mm}", "{at: [0.2, 0.1], radius: 12mm}"));
}

TEST_CASE("a name that one side changed is followed by what the other says") {
    const std::string mine = with(with(table, "rubber: {", "gum: {"), "material: rubber", "material: gum");
    const std::string theirs = with(table, "[200mm, 0.02]}", "[200mm, 0.02], material: rubber}");
    const MergedText result = merged(table, mine, theirs);
    CHECK(told_of(result).empty());
    CHECK(result.reading.scene.find("shelf")->get<std::string>("material") == "gum");
    CHECK(result.reading.scene.find("pop")->get<std::string>("material") == "gum");
}

TEST_CASE("a node that both moved elsewhere is asked about; one that one side wrapped takes the other's values along") {
    const std::string shelf = "  - box: {id: shelf, at: [0.25, 300mm], size: [200mm, 0.02]}   # a shelf\n";
    const std::string wrapped =
        with(table, shelf, "  - union:\n      children:\n        - box: {id: shelf, at: [0.25, 300mm], size: [200mm, 0.02]}   # a shelf\n");
    const MergedText result = merged(table, wrapped, with(table, "[200mm, 0.02]", "[205mm, 0.02]"));
    CHECK(told_of(result).empty());
    CHECK(text_of(result) == with(wrapped, "[200mm, 0.02]", "[205mm, 0.02]"));
    const std::string in_corner = with(with(table, shelf, ""), "# inside\n",
                                       "# inside\n        - box: {id: shelf, at: [0.25, 300mm], size: [200mm, 0.02]}   # a shelf\n");
    const MergedText asked = merged(table, wrapped, in_corner);
    REQUIRE(asked.conflicts.size() == 1);
    CHECK(asked.conflicts[0].what == "shelf: place");
    CHECK(asked.reading.scene.path(asked.reading.scene.find("shelf")->parent) == "corner");
}

TEST_CASE("keys of inputs and tests are merged by their names") {
    const std::string mine = with(table, "{left: [Z]}", "{left: [Z], right: [Slash]}"),
                      theirs = with(table, "{left: [Z]}", "{left: [Z, X]}");
    const MergedText result = merged(table, mine, theirs);
    CHECK(told_of(result).empty());
    CHECK_THAT(text_of(result), Catch::Contains("inputs: {left: [Z, X], right: [Slash]}"));
    const MergedText asked = merged(table, with(table, "{left: [Z]}", "{left: [A]}"), theirs);
    CHECK(told_of(asked) == Lines{"input left: [Z] | [A] | [Z, X]"});
    const std::string tests = "tests:\n  - {name: a, expect: [drained == 0]}\n";
    const MergedText tested =
        merged(table + tests, table + with(tests, "== 0", "< 2"), table + tests + "  - {name: b, expect: [escaped == 0]}\n");
    CHECK(told_of(tested).empty());
    CHECK(text_of(tested) == table + with(tests, "== 0", "< 2") + "  - {name: b, expect: [escaped == 0]}\n");
}

TEST_CASE("changes that do not go together are refused with the reason, and nothing is made up") {
    // Each side is sound: one takes the material out with its last user, the other uses it.
    const std::string bare = with(table, ", material: rubber", "");
    const std::string mine = with(bare, "materials:\n  rubber: {restitution: 0.8}   # bouncy\n", "");
    const MergedText result = merged(bare, mine, with(bare, "[200mm, 0.02]}", "[200mm, 0.02], material: rubber}"));
    CHECK_THAT(result.refusal, Catch::Contains("rubber"));
}

TEST_CASE("comments that only one side put on lines that the other rewrote are counted when they are left out") {
    const std::string mine = with(table, "material: rubber}\n", "material: rubber}  # mine\n");
    const MergedText result = merged(table, mine, with(table, "radius: 24mm, kick: 0.8", "radius: 25mm, kick: 0.8"));
    CHECK(result.comments_left_out == 1);
}

TEST_CASE("texts that differ in other lines are merged line by line") {
    CHECK(merge_lines("a\nb\nc\n", "A\nb\nc\n", "a\nb\nC\n") == "A\nb\nC\n");
    CHECK(merge_lines("a\nb\nc\n", "a\nb\nx\nc\n", "b\nc\n") == "b\nx\nc\n");
    CHECK(merge_lines("a\nb\n", "x\nb\n", "y\nb\n") == "y\nb\n");
    CHECK(merge_lines("a\nb\n", "x\nb\n", "a\ny\n") == "x\ny\n");
    CHECK(merge_lines("", "a\n", "") == "a\n");
    CHECK(merge_lines("a\n", "x\n", "a\nb\n") == "x\nb\n");
    CHECK(merge_lines("a\nb\nc\nd\n", "a\nB\nc\nD\n", "a\nx\ny\nz\n") == "a\nx\ny\nz\n");
    CHECK(merge_lines("a\nb\n", "a\nm\nb\n", "a\nt\nb\n") == "a\nt\nb\n");
    CHECK(merge_lines("a\r\nb", "a\r\nb\r\nc", "a\r\nb") == "a\r\nb\r\nc");
}

namespace {

/// What an edit touches: its node with all in it, and the lists it is taken from and put into.
std::set<NodeId> touched(const Scene& scene, const Edit& edit) {
    std::set<NodeId> out;
    const auto whole = [&](NodeId id) {
        for (const Node& node : scene.copy(id)) out.insert(node.id);
        out.insert(scene.find(id)->parent ? scene.find(id)->parent : NodeId{scene.find(id)->is_record() ? 999'999U : 999'998U});
    };
    const auto list = [&](NodeId parent) { out.insert(parent ? parent : NodeId{999'998U}); };
    if (const auto* e = std::get_if<SetField>(&edit)) out.insert(e->node);
    if (const auto* e = std::get_if<Insert>(&edit))
        e->nodes.front().is_record() ? static_cast<void>(out.insert(NodeId{999'999U})) : list(e->parent);
    if (const auto* e = std::get_if<Remove>(&edit)) whole(e->node);
    if (const auto* e = std::get_if<Move>(&edit)) whole(e->node), list(e->parent);
    if (const auto* e = std::get_if<Unwrap>(&edit)) whole(e->node);
    if (const auto* e = std::get_if<Retype>(&edit)) out.insert(e->node);
    if (const auto* e = std::get_if<Wrap>(&edit)) {
        list(e->parent);
        for (int i = 0; i < e->count; ++i) whole(at(scene.children_of(e->parent), e->first + i));
    }
    return out;
}

/// The same edit of a scene in which others have been put in meanwhile.
Edit with_free_ids(const Scene& scene, Edit edit) {
    if (auto* insert = std::get_if<Insert>(&edit)) insert->nodes = scene.with_new_ids(insert->nodes);
    if (auto* wrap = std::get_if<Wrap>(&edit)) wrap->wrapper = scene.with_new_ids({wrap->wrapper}).front();
    return edit;
}

bool is_about_names(const Scene& scene, const Edit& edit) {
    if (std::holds_alternative<Rename>(edit)) return true;
    const auto* field = std::get_if<SetField>(&edit);
    return field && at(scene.find(field->node)->type->fields, field->field).meta.meaning == Meaning::id;
}

/// A random table, every node of which has an id: only then do texts alone say which node is which.
Reading random_base(CounterRng& rng) {
    Reading base = read(random_table(rng));
    RC_ASSERT(base.ok());
    std::vector<Edit> names;
    for (const NodeId id : base.scene.all())
        if (const Node& node = *base.scene.find(id); !node.is_record() && node.name.empty())
            names.emplace_back(Rename{id, "", "given_" + std::to_string(id.value), true});
    Result<PatchedText> named = patch_for(base, names);
    return named ? std::move(named->reading) : std::move(base);
}

bool all_named(const Scene& scene) {
    const auto all = scene.all();
    return std::all_of(all.begin(), all.end(), [&](NodeId id) { return scene.find(id)->is_record() || !scene.find(id)->name.empty(); });
}

struct Sides {
    Reading mine, theirs;
    Scene expected;
    int edits = 0;
};

/// Edits of a table that touch different nodes, each given to one side, and what they make together.
Sides apart(const Reading& base, CounterRng& rng, int edits) {
    Sides out{base, base, base.scene};
    std::set<NodeId> taken;
    for (int i = 0; i < edits; ++i) {
        std::optional<Edit> edit;
        if (rng.next_u64() % 2)
            edit = some_structural_edit(base.scene, rng);
        else if (auto field = some_edit(base.scene, rng))
            edit = *field;
        if (!edit || is_about_names(base.scene, *edit)) continue;
        const std::set<NodeId> here = touched(base.scene, *edit);
        if (here.empty() || std::any_of(here.begin(), here.end(), [&](NodeId id) { return taken.contains(id); })) continue;
        Reading& side = rng.next_u64() % 2 ? out.mine : out.theirs;
        const Edit for_side = with_free_ids(side.scene, *edit), for_both = with_free_ids(out.expected, *edit);
        if (why_invalid(side.scene, for_side) || why_invalid(out.expected, for_both)) continue;
        Result<PatchedText> patched = patch_for(side, std::span(&for_side, 1));
        if (!patched) continue;
        side = std::move(patched->reading);
        pinfield::apply(out.expected, for_both);
        taken.insert(here.begin(), here.end());
        ++out.edits;
    }
    return out;
}

std::map<std::string, int> comments_in_text(const Reading& now) {
    std::map<std::string, int> out;
    const std::string& text = now.source().text();
    for (const Span span : comments_in(text, {0, text.size()}, *now.tree->root)) ++out[text.substr(span.begin, span.end - span.begin)];
    return out;
}

void require(bool law, const std::string& broken) {
    if (!law) throw std::runtime_error(broken);
}

/// How many of them were merged without a word.
struct Count {
    int merged = 0, refused = 0, edits = 0;
};

void judge(std::uint64_t seed, Count& count) {
    CounterRng rng(seed);
    const Reading base = random_base(rng);
    if (!all_named(base.scene)) return;
    const Sides sides = apart(base, rng, 8);
    const MergedText merged = merge_text(base, sides.mine, read(sides.theirs.source().text()));
    const MergedText mirrored = merge_text(base, sides.theirs, read(sides.mine.source().text()));
    const auto told = [&](const std::string& what) {
        std::string conflicts;
        for (const ToldConflict& c : merged.conflicts) conflicts += c.what + "; ";
        return what + " " + merged.refusal + " [" + conflicts + "]\n--- base\n" + base.source().text() + "\n--- mine\n" +
               sides.mine.source().text() + "\n--- theirs\n" + sides.theirs.source().text() + "\n--- merged\n" +
               merged.reading.source().text();
    };
    require(merged.conflicts.empty() && mirrored.conflicts.empty(), told("asked about what only one side touched"));
    count.edits += sides.edits;
    if (!merged.refusal.empty() || !mirrored.refusal.empty()) {
        ++count.refused;
        return;
    }
    ++count.merged;
    require(same_content(merged.reading.scene, sides.expected), told("is not both"));
    require(same_content(mirrored.reading.scene, sides.expected), told("is not both the other way round"));
    require(read(merged.reading.source().text()).ok() && same_content(read(merged.reading.source().text()).scene, sides.expected),
            told("is not what it says"));
    const auto before = comments_in_text(base), here = comments_in_text(sides.mine), there = comments_in_text(sides.theirs),
               now = comments_in_text(merged.reading);
    for (const auto& [comment, times] : before)
        if (here.contains(comment) && there.contains(comment)) require(now.contains(comment), told("lost " + comment));
    for (const auto& [comment, times] : now) require(times == 1 && before.contains(comment), told("made up " + comment));
}

}  // namespace

TEST_CASE("edits of different nodes by two sides are all made, whichever side is whose, and no comment is lost") {
    Count count;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        INFO(seed);
        judge(seed, count);
    }
    CHECK(count.edits > 100);
    CHECK(count.refused <= count.merged / 20);
}

TEST_CASE("any edits of different nodes by two sides are all made, whichever side is whose, and no comment is lost", "[slow]") {
    Count count;
    CHECK(rc::check("two sides of a random table", [&](std::uint64_t seed) { judge(seed, count); }));
    WARN(count.merged << " merged, " << count.refused << " refused, " << count.edits << " edits");
    CHECK(count.refused <= count.merged / 20);
}

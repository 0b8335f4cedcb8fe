#include "engine/io/merge_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "engine/core/at.h"
#include "engine/io/merge_lines.h"
#include "engine/io/node_writer.h"
#include "engine/io/same_content.h"
#include "engine/io/structure_patch.h"
#include "engine/io/text_patch.h"
#include "engine/io/yaml_items.h"
#include "engine/scene/edits_between.h"
#include "engine/scene/match.h"
#include "engine/scene/validate.h"

namespace pinfield {
namespace {

using About = MergeConflict::About;

const std::string& text_of(const Reading& reading) { return reading.source().text(); }

/// How often each comment stands in a text.
std::map<std::string, int> comments_of(const Reading& reading) {
    std::map<std::string, int> out;
    const std::string& text = text_of(reading);
    for (const Span span : comments_in(text, {0, text.size()}, *reading.tree->root)) ++out[text.substr(span.begin, span.end - span.begin)];
    return out;
}

int comments_left_out(const Reading& base, const Reading& mine, const Reading& merged) {
    const auto before = comments_of(base), here = comments_of(mine), now = comments_of(merged);
    const auto count = [](const std::map<std::string, int>& comments, const std::string& comment) {
        const auto found = comments.find(comment);
        return found == comments.end() ? 0 : found->second;
    };
    int out = 0;
    for (const auto& [comment, times] : here)
        if (times > count(before, comment)) out += std::max(times - std::max(count(before, comment), count(now, comment)), 0);
    return out;
}

/// A test as a side has it in one line; empty where none has.
std::string text_of_test(const TableTest& test, const Reading& side) {
    for (const TableTest& other : side.scene.tests) {
        const std::string_view written = side.scene.sources.slice(other.where);
        if (same_test(other, test) && written.starts_with('{') && written.find('\n') == std::string_view::npos) return std::string(written);
    }
    return {};
}

/// A text that says what `wanted` says, on the way from one that says nearly that; or why there is none.
Result<Reading> led_to(Reading start, const Scene& wanted, const Reading& mine, const Reading& theirs) {
    start.scene.take_ids(match(wanted, start.scene), wanted);
    const auto as_it_was_written = [&](NodeId id) {
        for (const Reading* side : {&mine, &theirs})
            if (const Node* node = side->scene.find(id); node && same_node(side->scene, *node, wanted, *wanted.find(id)))
                return text_of_node(*side, id).value_or("");
        return std::string();
    };
    Result<std::vector<Edit>> edits = edits_between(start.scene, wanted, as_it_was_written);
    if (!edits) return tl::unexpected(edits.error());
    for (Edit& edit : *edits)
        if (auto* insert = std::get_if<InsertTest>(&edit)) {
            insert->text = text_of_test(insert->test, mine);
            if (insert->text.empty()) insert->text = text_of_test(insert->test, theirs);
        }
    Result<PatchedText> patched = patch_for(start, *edits);
    if (!patched) return tl::unexpected(patched.error());
    if (!same_content(patched->reading.scene, wanted)) return failure("the merged text would say something else");
    patched->reading.scene.take_ids_of(wanted);
    return std::move(patched->reading);
}

// Conflicts told.

std::string value_told(const Scene& scene, const MergeConflict& conflict) {
    const Node* node = scene.find(conflict.node);
    if (!node) return "not there";
    if (node->is_record() && conflict.key == "name") return node->name;
    const auto field = node->type->find_field(conflict.key);
    if (!field) return "not there";
    const FieldSlot& slot = at(node->fields, *field);
    const std::string_view written = scene.sources.slice(slot.where);
    return !slot.is_explicit ? "not given" : std::string(written.substr(0, written.find('\n')));
}

std::string place_told(const Scene& scene, NodeId id) {
    const Node* node = scene.find(id);
    if (!node) return "not there";
    const std::vector<NodeId>& among = scene.siblings(id);
    const int index = scene.index_of(id);
    const std::string where = index > 0 ? "behind " + scene.path(at(among, index - 1)) : "first";
    return node->parent ? fmt::format("{} in {}", where, scene.path(node->parent)) : where;
}

template <class Item, class Told>
std::string item_told(const std::vector<Item>& items, const std::string& name, Told told) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
    return found == items.end() ? "not there" : told(*found);
}

std::string told(const Scene& scene, const MergeConflict& conflict) {
    switch (conflict.about) {
        case About::value: return value_told(scene, conflict);
        case About::type: return scene.find(conflict.node) ? std::string(scene.find(conflict.node)->type->key()) : "not there";
        case About::place: return place_told(scene, conflict.node);
        case About::presence: return scene.find(conflict.node) ? "there" : "taken out";
        case About::input: return item_told(scene.inputs, conflict.key, [](const InputBinding& input) { return keys_text(input.keys); });
        case About::test: return item_told(scene.tests, conflict.key, [](const TableTest& test) { return flow_map(entries_of(test)); });
    }
    return {};
}

std::string what_of(const MergeConflict& conflict, const Scene& mine, const Scene& theirs) {
    if (conflict.about == About::input) return "input " + conflict.key;
    if (conflict.about == About::test) return "test " + conflict.key;
    const std::string path = (mine.find(conflict.node) ? mine : theirs).path(conflict.node);
    switch (conflict.about) {
        case About::value: return fmt::format("{}: {}", path, conflict.key);
        case About::type: return path + ": type";
        case About::place: return path + ": place";
        default: return path;
    }
}

ToldConflict told(const MergeConflict& conflict, const Scene& base, const Scene& mine, const Scene& theirs) {
    ToldConflict out{conflict, what_of(conflict, mine, theirs), told(base, conflict), told(mine, conflict), told(theirs, conflict)};
    if (conflict.about == About::presence)
        for (std::string* side : {&out.mine, &out.theirs})
            if (*side == "there") *side = "changed";
    return out;
}

}  // namespace

MergedText merge_text(const Reading& base, const Reading& mine, Reading theirs, const Choices& choices) {
    share_ids(base.scene, mine.scene, theirs.scene);
    if (text_of(mine) == text_of(base) || text_of(mine) == text_of(theirs)) return {std::move(theirs)};
    if (text_of(theirs) == text_of(base)) return {mine};
    MergedScene merged = merge(base.scene, mine.scene, theirs.scene, choices);
    MergedText out{std::move(theirs)};
    for (const MergeConflict& conflict : merged.conflicts)
        out.conflicts.push_back(told(conflict, base.scene, mine.scene, out.reading.scene));
    for (const Diagnostic& found : validate(merged.scene))
        if (found.severity == Severity::error) {
            out.refusal = found.message;
            return out;
        }
    // Lines first: they carry comments and all that only people read. What they miss or spoil, patches mend; else these begin at a side.
    for (const std::string& text : {merge_lines(text_of(base), text_of(mine), text_of(out.reading)), text_of(out.reading), text_of(mine)}) {
        Reading start = read_again(out.reading, text);
        if (!start.ok()) continue;
        Result<Reading> found = led_to(std::move(start), merged.scene, mine, out.reading);
        if (found) {
            out.comments_left_out = comments_left_out(base, mine, *found) + comments_left_out(base, out.reading, *found);
            out.reading = std::move(*found);
            out.refusal.clear();
            return out;
        }
        out.refusal = found.error().message;
    }
    return out;
}

}  // namespace pinfield

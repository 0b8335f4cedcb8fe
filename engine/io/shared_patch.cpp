#include "engine/io/shared_patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/core/at.h"
#include "engine/io/field_patch.h"
#include "engine/io/rewriting.h"
#include "engine/io/same_content.h"
#include "engine/io/value_writer.h"
#include "engine/io/yaml_items.h"

namespace pinfield {
namespace {

/// From the section to a node's field, each as it stands in the text: perhaps an alias.
struct Way {
    std::vector<const YamlNode*> nodes;
    const YamlNode* body = nullptr;   ///< the node's fields; null: the text does not hold it
    const YamlNode* value = nullptr;  ///< null: it is not said
};

const YamlNode* entry_in(const YamlNode& map, std::string_view key) {
    const YamlNode& body = map.resolved();
    if (body.kind != YamlKind::map) return nullptr;
    const std::size_t entry = body.entry_of(key);
    return entry < body.entries() ? &body.value(entry) : nullptr;
}

Way way_to(const Reading& now, NodeId id, std::string_view field) {
    Way way;
    const Node& node = *now.scene.find(id);
    const auto step = [&](const YamlNode* next) {
        if (next) way.nodes.push_back(next);
        return next;
    };
    const YamlNode* at_node = now.tree->root;
    if (node.is_record()) {
        at_node = step(entry_in(*at_node, node.name.empty() ? node.type->key() : "materials"));
        if (at_node && !node.name.empty()) at_node = step(entry_in(*at_node, node.name));
    } else {
        at_node = step(entry_in(*at_node, "scene"));
        const Indices indices = indices_of(now.scene, id);
        if (indices.front() < 0) return way;  // in another file
        for (std::size_t depth = 0; at_node && depth < indices.size(); ++depth) {
            if (depth > 0) at_node = step(entry_in(*at_node, "children"));
            const YamlNode* item = at_node ? step(at(at_node->resolved().items, indices[depth])) : nullptr;
            at_node = item && item->resolved().kind == YamlKind::map ? step(&item->resolved().value(0)) : nullptr;
        }
    }
    way.body = at_node;
    way.value = at_node ? step(entry_in(*at_node, field)) : nullptr;
    return way;
}

const FieldType& field_of(const Reading& now, const SetField& edit) { return at(now.scene.find(edit.node)->type->fields, edit.field); }

bool is_shared(const YamlNode* node) { return node->target || node->references > 0; }

/// A field of a node: another place that has the text.
struct PlaceOfField {
    NodeId node;
    int field = 0;
};

/// Whatever reads the text that the edit changes: of a value that is there, that value; else the map it is put into or taken from.
std::vector<PlaceOfField> places_of(const Reading& now, const SetField& edit) {
    const Way way = way_to(now, edit.node, field_of(now, edit).key);
    std::vector<PlaceOfField> out;
    const bool by_value = way.value && edit.is_explicit;
    for (const NodeId id : now.scene.all()) {
        const NodeType& type = *now.scene.find(id)->type;
        const Way other = way_to(now, id, field_of(now, edit).key);
        if (!other.body || !way.body) continue;
        if (!by_value) {
            if (&other.body->resolved() == &way.body->resolved()) out.push_back({id, edit.field});
            continue;
        }
        const YamlNode& body = other.body->resolved();
        for (std::size_t i = 0; i < body.entries(); ++i)
            if (const auto field = type.find_field(body.key(i).text); field && &body.value(i).resolved() == &way.value->resolved())
                out.push_back({id, *field});
    }
    return out;
}

const YamlNode& anchor_of(const YamlNode& shared) { return shared.resolved(); }

/// The aliases of an anchor, in the order of the text.
std::vector<const YamlNode*> aliases_of(const YamlTree& tree, const YamlNode& anchor) {
    std::vector<const YamlNode*> out;
    for (const YamlNode& node : tree.nodes)
        if (node.target == &anchor) out.push_back(&node);
    std::sort(out.begin(), out.end(), [](const YamlNode* a, const YamlNode* b) { return a->span.begin < b->span.begin; });
    return out;
}

/// "&name" before a node, with the blanks that go with it.
std::optional<Span> anchor_word(std::string_view text, const YamlNode& node, std::string_view name) {
    const std::string word = fmt::format("&{}", name);
    const std::size_t begin = text.rfind(word, node.span.begin);
    if (begin == std::string_view::npos) return {};
    const std::size_t end = begin + word.size(), content = text.find_first_not_of(" \t", end);
    if (content < text.size() && text[content] != '\n' && text[content] != '\r' && text[content] != '#') return Span{begin, content};
    const std::size_t before = text.find_last_not_of(" \t", begin - 1);
    return Span{before + 1, end};
}

/// What makes the first shared thing on the way one of this place's own, and says the same.
Result<std::vector<Splice>> written_out(const Reading& now, const YamlNode& shared, Aliases aliases) {
    const std::string& text = now.source().text();
    const YamlNode& anchor = anchor_of(shared);
    const auto copy_for = [&](const YamlNode& place) {
        std::string copy = copy_in_line(text, anchor, aliases);
        const bool is_item = place.parent && place.parent->kind == YamlKind::sequence && place.parent->style == YamlStyle::block;
        return is_item && anchor.kind == YamlKind::map && anchor.entries() > 0 ? copy.substr(1, copy.size() - 2) : copy;
    };
    if (shared.target) return std::vector<Splice>{{shared.span, copy_for(shared)}};
    const std::vector<const YamlNode*> others = aliases_of(*now.tree, anchor);
    const YamlNode& next = *others.front();
    const auto word = anchor_word(text, anchor, next.text);
    if (!word) return failure("the anchor is not found; edit the text");
    const bool block_map = next.parent && next.parent->kind == YamlKind::sequence && anchor.kind == YamlKind::map;
    const std::string copy = block_map ? copy_in_line(text, anchor, aliases) : copy_for(next);
    return std::vector<Splice>{{*word, ""}, {next.span, others.size() > 1 ? fmt::format("&{} {}", next.text, copy) : copy_for(next)}};
}

Reading read_spliced(const Reading& now, const std::vector<Splice>& splices, std::vector<TextPatch>& patches) {
    std::string text = now.source().text();
    for (auto splice = splices.rbegin(); splice != splices.rend(); ++splice) {
        text.replace(splice->replaced.begin, splice->replaced.end - splice->replaced.begin, splice->text);
        patches.push_back({now.source().place(splice->replaced), splice->text});
    }
    return read_again(now, std::move(text));
}

Result<Splice> splice_at_anchor(const Reading& now, const SetField& edit) {
    const std::string& text = now.source().text();
    const FieldType& field = field_of(now, edit);
    const Way way = way_to(now, edit.node, field.key);
    if (!way.body) return failure("the text does not hold the node");
    const Node& node = *now.scene.find(edit.node);
    const YamlNode& body = way.body->resolved();
    if (way.value && edit.is_explicit) {
        const YamlNode& value = way.value->resolved();
        for (const YamlNode* item : value.items)
            if (const YamlNode* shared = shared_below(*item)) return tl::unexpected(shared_failure(*shared));
        return value_splice(text, field, value, at(node.fields, edit.field).value, edit.value);
    }
    if (way.value) return remove_entry(text, body, body.entry_of(field.key));
    const std::string entry =
        fmt::format("{}: {}", field.key, write_value(field, edit.value, customary_number(now.scene, &node, field.meta.unit)));
    return body.is_empty() ? insert_body(text, body, entry) : insert_entry(text, body, index_for_new_field(body, field), entry);
}

}  // namespace

std::optional<SharedText> shared_text(const Reading& now, const SetField& edit) {
    if (!now.tree->root || !now.scene.find(edit.node)) return {};
    const Way way = way_to(now, edit.node, field_of(now, edit).key);
    const YamlNode* shared = nullptr;
    for (const YamlNode* node : way.nodes)
        if (is_shared(node)) shared = node;
    if (!shared && way.value) shared = shared_below(*way.value);
    if (!shared) return {};
    const std::vector<const YamlNode*> aliases = aliases_of(*now.tree, anchor_of(*shared));
    return SharedText{std::string(aliases.front()->text), std::max(static_cast<int>(places_of(now, edit).size()), 2)};
}

Result<PatchedText> patch_everywhere(const Reading& now, const SetField& edit) {
    const FieldType& field = field_of(now, edit);
    Scene expected = now.scene;
    for (const PlaceOfField& place : places_of(now, edit)) {
        const FieldType& other = at(now.scene.find(place.node)->type->fields, place.field);
        if (other.kind != field.kind || other.meta.unit != field.meta.unit)
            return failure(
                fmt::format("the value also stands for {} of {}, which is something else", other.key, now.scene.path(place.node)));
        const SetField there{place.node, place.field, edit.value, edit.is_explicit};
        if (const auto why = why_invalid(expected, there)) return failure(fmt::format("{}: {}", now.scene.path(place.node), *why));
        apply(expected, there);
    }
    const Result<Splice> splice = splice_at_anchor(now, edit);
    if (!splice) return tl::unexpected(splice.error());
    PatchedText out{{}, now, 1};
    out.reading = read_spliced(now, {*splice}, out.patches);
    if (!out.reading.ok()) return failure(out.reading.diagnostics.front().message);
    if (!same_content(out.reading.scene, expected)) return failure("the text would change more than this value");
    out.reading.scene.take_ids_of(expected);
    return out;
}

Result<PatchedText> patch_here(const Reading& now, const SetField& edit) {
    PatchedText out{{}, now, 0};
    constexpr int most_layers = 16;
    for (int layer = 0; layer < most_layers; ++layer) {
        const Way way = way_to(out.reading, edit.node, field_of(now, edit).key);
        const auto first = std::find_if(way.nodes.begin(), way.nodes.end(), is_shared);
        std::vector<Splice> splices;
        if (first != way.nodes.end()) {
            Result<std::vector<Splice>> written = written_out(out.reading, **first, Aliases::kept);
            if (!written) return tl::unexpected(written.error());
            splices = std::move(*written);
        } else if (way.value && shared_below(*way.value)) {
            if (const YamlNode* inner = shared_below(*way.value); inner->references > 0) return tl::unexpected(shared_failure(*inner));
            splices = {{way.value->span, copy_in_line(out.reading.source().text(), *way.value, Aliases::written_out)}};
        } else {
            break;
        }
        Reading next = read_spliced(out.reading, splices, out.patches);
        ++out.readings;
        if (!next.ok()) return failure(next.diagnostics.front().message);
        if (!same_content(next.scene, now.scene)) return failure("the text would change more than this value");
        next.scene.take_ids_of(now.scene);
        out.reading = std::move(next);
    }
    const Edit whole = edit;
    Result<PatchedText> patched = patch_for(out.reading, std::span(&whole, 1));
    if (!patched) return patched;
    out.patches.insert(out.patches.end(), std::make_move_iterator(patched->patches.begin()),
                       std::make_move_iterator(patched->patches.end()));
    out.reading = std::move(patched->reading);
    out.readings += patched->readings;
    return out;
}

}  // namespace pinfield

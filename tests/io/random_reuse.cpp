#include "tests/io/random_reuse.h"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "engine/core/at.h"
#include "engine/io/field_patch.h"
#include "engine/io/said_once.h"
#include "engine/io/text_patch.h"
#include "tests/io/support.h"

namespace pinfield::test {
namespace {

using Text = std::optional<std::string>;

Text text_of(const Result<PatchedText>& patched) { return patched ? Text(patched->reading.source().text()) : std::nullopt; }

std::string spliced(std::string text, const Splice& splice) {
    return text.replace(splice.replaced.begin, splice.replaced.end - splice.replaced.begin, splice.text);
}

NodeId some_own_node(const Scene& scene, CounterRng& rng) {
    const std::vector<NodeId> all = scene.all();
    for (int attempt = 0; attempt < 20; ++attempt)
        if (const NodeId id = all[rng.next_u64() % all.size()]; !scene.find(id)->is_record() && !scene.find(id)->origin) return id;
    return {};
}

/// At the top level or in groups alone: where copies may stand.
bool stands_free(const Scene& scene, const Node& node) {
    return !node.generator && (!node.parent || (scene.find(node.parent)->type->key() == "group" && !scene.find(node.parent)->origin));
}

Text with_param(const Reading& now, NodeId node, CounterRng& rng) {
    const auto field = static_cast<int>(rng.next_u64() % now.scene.find(node)->fields.size());
    return text_of(patch_to_param(now, node, field, static_cast<int>(rng.next_u64() % 2), free_name_for(now, "turned")));
}

/// A number once more, as an expression of a param or of itself.
Text with_expression(const Reading& now, NodeId id, CounterRng& rng) {
    const Node& node = *now.scene.find(id);
    const FieldSlot& slot = node.fields[rng.next_u64() % node.fields.size()];
    const YamlNode* value = slot.where ? node_at(*now.tree, slot.where.span) : nullptr;
    if (value && value->kind == YamlKind::sequence && !value->items.empty()) value = value->items[rng.next_u64() % value->items.size()];
    if (!value || value->kind != YamlKind::scalar || value->style != YamlStyle::plain) return {};
    const std::string by = now.scene.params.empty() || rng.next_u64() % 2 ? "{} * 2 / 2" : "{} + 0 * " + now.scene.params.front().name;
    return spliced(now.source().text(), {value->span, fmt::format(fmt::runtime(by), value->text)});
}

Text with_template(const Reading& now, NodeId node, CounterRng& rng) {
    std::vector<NodeId> nodes{node};
    const std::vector<NodeId>& siblings = now.scene.siblings(node);
    const auto next = static_cast<std::size_t>(now.scene.index_of(node)) + 1;
    if (next < siblings.size() && rng.next_u64() % 2) nodes.push_back(siblings[next]);
    return text_of(patch_to_template(now, nodes, free_name_for(now, "made")));
}

Text with_entry(const Reading& now, NodeId id, const std::string& entry) {
    const Node& node = *now.scene.find(id);
    const EntryOfNode found = find_entry(*now.tree, node);
    if (!stands_free(now.scene, node) || !found.owner) return {};
    const YamlNode& body = found.owner->value(found.index);
    if (body.target || body.references > 0 || body.kind != YamlKind::map || body.entries() == 0) return {};
    return spliced(now.source().text(), insert_entry(now.source().text(), body, body.entries(), entry));
}

}  // namespace

std::string with_reuse(std::string table, CounterRng& rng, int tries) {
    static const char* const entries[] = {"copies: {count: 2, step: [7mm, 0]}", "copies: {count: 3, around: [0.26, 0.5]}", "pair: 0.26"};
    for (int i = 0; i < tries; ++i) {
        const Reading now = read(table);
        const NodeId node = some_own_node(now.scene, rng);
        if (!now.tree->root || !node) continue;
        Text next;
        switch (rng.next_u64() % 5) {
            case 0: next = with_param(now, node, rng); break;
            case 1: next = with_template(now, node, rng); break;
            case 2: next = with_expression(now, node, rng); break;
            default: next = with_entry(now, node, entries[rng.next_u64() % 3]); break;
        }
        if (next && read(*next).ok()) table = std::move(*next);
    }
    return table;
}

}  // namespace pinfield::test

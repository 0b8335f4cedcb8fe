#include "engine/io/structure_patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/core/at.h"
#include "engine/io/field_patch.h"
#include "engine/io/node_writer.h"
#include "engine/io/rewriting.h"
#include "engine/io/section_patch.h"
#include "engine/io/value_writer.h"
#include "engine/scene/elsewhere.h"

namespace pinfield {
namespace {

Indices parent_of(Indices node) {
    node.pop_back();
    return node;
}

Result<void> rewrite(Rewriting&, const Scene&, const SetField&) { return failure("a field is no structure"); }

Result<void> rewrite(Rewriting& text, const Scene& scene, const Insert& edit) {
    if (edit.nodes.front().type->meta.kind == NodeKind::record) return insert_material(text, edit.nodes.front(), edit.index - included_materials(scene));
    const Node* beside = edit.parent ? scene.find(edit.parent) : nullptr;
    const std::string block = edit.text.empty() ? write_item(edit.nodes, text.style(beside)) : edit.text;
    return text.insert(indices_of(scene, edit.parent), index_in_text(scene, edit.parent, edit.index), item_text(block));
}

Result<void> rewrite(Rewriting& text, const Scene& scene, const Remove& edit) {
    const Node& node = *scene.find(edit.node);
    if (node.is_record()) {
        const EntryOfNode entry = find_entry(text.tree(), node);
        if (!entry.owner) return failure("the text does not hold the material");
        return text.write({remove_entry(text.text(), *entry.owner, entry.index)});
    }
    const Indices at_node = indices_of(scene, edit.node);
    return text.remove(parent_of(at_node), at_node.back());
}

Result<void> rewrite(Rewriting& text, const Scene& scene, const Move& edit) {
    const Indices from = indices_of(scene, edit.node);
    const Result<ItemText> item = text.item(parent_of(from), from.back());
    if (!item) return tl::unexpected(item.error());
    if (const auto removed = text.remove(parent_of(from), from.back()); !removed) return removed;
    Scene without = scene;
    without.take(edit.node);
    return text.insert(indices_of(without, edit.parent), index_in_text(without, edit.parent, edit.index), *item);
}

Result<void> rewrite(Rewriting& text, const Scene& scene, const Wrap& edit) {
    const Indices parent = indices_of(scene, edit.parent);
    const int first = index_in_text(scene, edit.parent, edit.first);
    std::vector<std::string> blocks, flows;
    for (int i = 0; i < edit.count; ++i) {
        const Result<ItemText> item = text.item(parent, first + i);
        if (!item) return tl::unexpected(item.error());
        blocks.push_back(item->block);
        flows.push_back(item->flow);
    }
    const NodeStyle style = text.style(nullptr);
    ItemText wrapper{write_item_around(edit.wrapper, blocks, style), ""};
    if (std::none_of(flows.begin(), flows.end(), [](const std::string& flow) { return flow.empty(); })) {
        std::vector<std::string> entries = explicit_entries(edit.wrapper, style);
        entries.push_back(fmt::format("children: [{}]", fmt::join(flows, ", ")));
        wrapper.flow = fmt::format("{}: {}", edit.wrapper.type->key(), flow_map(entries));
    }
    if (const auto inserted = text.insert(parent, first, wrapper); !inserted) return inserted;
    for (int i = edit.count; i-- > 0;)
        if (const auto removed = text.remove(parent, first + 1 + i); !removed) return removed;
    return {};
}

/// Comments of an item that belong to none of its children, as lines.
std::string own_comments(const Rewriting& text, const YamlNode& outer, std::size_t index, const YamlNode* inner) {
    const YamlNode& item = *outer.items[index];
    std::string out;
    for (const Span comment : comments_in(text.text(), item_extent(text.text(), outer, index), item)) {
        bool in_child = false;
        for (std::size_t i = 0; inner && i < inner->items.size(); ++i) {
            const Span child = item_extent(text.text(), *inner, i);
            in_child = in_child || (child.begin <= comment.begin && comment.end <= child.end);
        }
        if (!in_child) out += text.text().substr(comment.begin, comment.end - comment.begin) + "\n";
    }
    return out;
}

Result<void> rewrite(Rewriting& text, const Scene& scene, const Unwrap& edit) {
    const Indices node = indices_of(scene, edit.node), parent = parent_of(node);
    const auto outer = text.children_of(parent), inner = text.children_of(node);
    if (!outer) return tl::unexpected(outer.error());
    if (!inner) return tl::unexpected(inner.error());
    std::vector<ItemText> items;
    for (int i = 0; i < static_cast<int>(scene.find(edit.node)->children.size()); ++i) {
        const Result<ItemText> item = text.item(node, i);
        if (!item) return tl::unexpected(item.error());
        items.push_back(*item);
    }
    if (const std::string comments = own_comments(text, *outer->list, static_cast<std::size_t>(node.back()), inner->list); !comments.empty()) {
        items.front().block = comments + items.front().block;
        items.front().flow.clear();
    }
    for (std::size_t i = items.size(); i-- > 0;)
        if (const auto inserted = text.insert(parent, node.back() + 1, items[i]); !inserted) return inserted;
    return text.remove(parent, node.back());
}

Result<void> rewrite(Rewriting& text, const Scene& scene, const Retype& edit) {
    const Node& node = *scene.find(edit.node);
    const Indices indices = indices_of(scene, edit.node);
    const auto here = text.children_of(indices);
    if (!here) return tl::unexpected(here.error());
    if (const auto written = text.write({{here->owner->key(0).span, std::string(edit.type->key())}}); !written) return written;
    for (std::size_t i = 0; i < node.fields.size(); ++i) {  // fields that the new type has not, or not from the text
        const std::string_view key = node.type->fields[i].key;
        const auto kept = edit.type->find_field(key);
        if (!node.fields[i].is_explicit || (kept && at(edit.fields, *kept).is_explicit)) continue;
        const YamlNode& body = *text.children_of(indices)->body;
        if (const auto written = text.write({remove_entry(text.text(), body, body.entry_of(key))}); !written) return written;
    }
    for (std::size_t i = 0; i < edit.fields.size(); ++i) {
        const FieldType& field = edit.type->fields[i];
        const auto before = node.type->find_field(field.key);
        const bool was_there = before && at(node.fields, *before).is_explicit;
        if (!edit.fields[i].is_explicit || (was_there && identical(at(node.fields, *before).value, edit.fields[i].value))) continue;
        if (was_there) return failure(fmt::format("{} would change its value", field.key));
        const YamlNode& body = *text.children_of(indices)->body;
        const std::string entry =
            fmt::format("{}: {}", field.key, write_slot(field, edit.fields[i], text.style(&node).number(field.meta.unit)));
        const Splice splice = body.is_empty() ? insert_body(text.text(), body, entry) : insert_entry(text.text(), body, 0, entry);
        if (const auto written = text.write({splice}); !written) return written;
    }
    return {};
}

// Inputs and tests are no nodes: section_patch.cpp.
Result<void> rewrite(Rewriting& text, const Scene&, const InsertInput& edit) { return insert_input(text, edit); }
Result<void> rewrite(Rewriting& text, const Scene&, const RemoveInput& edit) { return remove_input(text, edit); }
Result<void> rewrite(Rewriting& text, const Scene& scene, const SetKeys& edit) { return set_keys(text, scene, edit); }
Result<void> rewrite(Rewriting& text, const Scene&, const InsertTest& edit) { return insert_test(text, edit); }
Result<void> rewrite(Rewriting& text, const Scene&, const RemoveTest& edit) { return remove_test(text, edit); }
Result<void> rewrite(Rewriting& text, const Scene&, const RenameTest& edit) { return rename_test(text, edit); }

/// Everything that says a name, once each, in the order of the text.
class NameSplices {
public:
    NameSplices(const Rewriting& text, const Rename& edit) : text_(text), edit_(edit) {}

    void key(const Place& place) { add({{place.span.begin, place.span.begin + edit_.from.size()}, edit_.to}); }
    void field(const FieldType& type, const FieldSlot& slot) {
        const Value after = renamed(slot.value, edit_.from, edit_.to);
        const YamlNode* node = identical(after, slot.value) ? nullptr : node_at(text_.tree(), slot.where.span);
        if (!node) return;
        if (node->kind != YamlKind::sequence) return add(value_splice(text_.text(), type, *node, slot.value, after));
        for (const YamlNode* item : node->items)  // a pair's list holds more names than each of the two has
            if (item->kind == YamlKind::scalar && item->text == edit_.from) add({item->span, write_text(edit_.to, item->style)});
    }
    /// Within a scalar, where the name stands first.
    void within(const Place& where) {
        const std::size_t begin = text_.text().find(edit_.from, where.span.begin);
        if (begin < where.span.end) add({{begin, begin + edit_.from.size()}, edit_.to});
    }
    std::vector<Splice> in_order() && {
        std::sort(splices_.begin(), splices_.end(), [](const Splice& a, const Splice& b) { return a.replaced.begin < b.replaced.begin; });
        return std::move(splices_);
    }

    void add(Splice splice) {
        const auto same = [&](const Splice& other) { return other.replaced == splice.replaced; };
        if (std::none_of(splices_.begin(), splices_.end(), same)) splices_.push_back(std::move(splice));
    }

private:
    const Rewriting& text_;
    const Rename& edit_;
    std::vector<Splice> splices_;
};

Result<void> rewrite(Rewriting& text, const Scene& scene, const Rename& edit) {
    NameSplices names(text, edit);
    const Node* node = edit.node ? scene.find(edit.node) : nullptr;
    if (node && !node->is_record()) {
        const int id = *node->type->find_field("id");
        Result<Splice> own = splice_for(text.now(), *node, {edit.node, id, edit.to, edit.is_explicit});
        if (!own) return tl::unexpected(own.error());
        names.add(std::move(*own));
        for (const TableTest& test : scene.tests)
            for (const TableTest::Expectation& expectation : test.expectations)
                if (!edit.from.empty() && expectation.quantity.starts_with(edit.from + ".")) names.within(expectation.where);
        return text.write(std::move(names).in_order());
    }
    if (node) names.key(node->key);
    for (const InputBinding& input : scene.inputs)
        if (!node && input.name == edit.from) names.key(input.where);
    for (const TableTest& test : scene.tests)
        for (const TableTest::Hand& hand : test.inputs)
            if (!node && hand.input == edit.from) names.key(hand.where);
    const Meaning sort = node ? Meaning::material : Meaning::input;
    for (const NodeId id : scene.all()) {
        const Node& other = *scene.find(id);
        for (std::size_t i = 0; i < other.fields.size(); ++i)
            if (other.fields[i].is_explicit && other.type->fields[i].meta.meaning == sort)
                names.field(other.type->fields[i], other.fields[i]);
    }
    return text.write(std::move(names).in_order());
}

/// An item of a list in a file that the table includes.
Result<std::string> text_elsewhere(const Reading& now, const Node& node) {
    const SourceText* source = now.scene.sources.find(node.key);
    for (const auto& [path, file] : now.files) {
        if (file->source.get() != source) continue;
        const YamlNode* item = find_entry(*file->tree, node).owner;
        const YamlNode* list = item ? item->parent : nullptr;
        if (!list || list->kind != YamlKind::sequence) break;
        const auto index = std::find(list->items.begin(), list->items.end(), item) - list->items.begin();
        return item_text(source->text(), *list, static_cast<std::size_t>(index)).block;
    }
    return failure("the text does not hold the node");
}

}  // namespace

Result<std::vector<TextPatch>> structure_patches(const Reading& now, const Edit& edit) {
    Rewriting text(now);
    const Result<void> done = std::visit([&](const auto& e) { return rewrite(text, now.scene, e); }, edit);
    if (!done) return tl::unexpected(done.error());
    return std::move(text).patches();
}

Result<std::string> text_of_node(const Reading& now, NodeId node) {
    if (now.scene.find(node)->is_record()) return failure("only nodes of the scene are items of a list");
    if (const auto& origin = now.scene.find(node)->origin)
        return failure(fmt::format("{} is made by {} ({}): copy that, or write it out first", now.scene.path(node), origin->what,
                                   line_in_table(now.scene, origin->where)));
    if (is_included(now.scene.find(node)->key)) return text_elsewhere(now, *now.scene.find(node));
    Indices indices = indices_of(now.scene, node);
    const int last = indices.back();
    const Result<ItemText> item = Rewriting(now).item(parent_of(std::move(indices)), last);
    if (!item) return tl::unexpected(item.error());
    return item->block;
}

}  // namespace pinfield

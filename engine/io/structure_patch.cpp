#include "engine/io/structure_patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/core/at.h"
#include "engine/io/field_patch.h"
#include "engine/io/node_writer.h"
#include "engine/io/value_writer.h"
#include "engine/io/yaml_items.h"

namespace pinfield {
namespace {

constexpr std::string_view no_room =
    "the list stands in one line, where a comment or an anchor would be lost; give its items lines of their own first";

/// Child of the top level, child of that child ...: where a node is, whatever it is called.
using Indices = std::vector<int>;

Indices indices_of(const Scene& scene, NodeId node) {
    Indices out;
    for (; node; node = scene.find(node)->parent) out.insert(out.begin(), scene.index_of(node));
    return out;
}

/// Where the list of a node's children stands, or would stand.
struct Children {
    const YamlNode* owner = nullptr;  ///< the map one of whose entries is the node; null: the root of the file
    std::size_t entry = 0;
    const YamlNode* body = nullptr;   ///< the node's fields
    const YamlNode* list = nullptr;   ///< null: there is none
};

const YamlNode* list_of(const YamlNode& body, std::string_view key) {
    const std::size_t entry = body.kind == YamlKind::map ? body.entry_of(key) : body.entries();
    return entry < body.entries() ? &body.value(entry) : nullptr;
}

/// The author's text while it changes, a step at a time.
class Rewriting {
public:
    explicit Rewriting(const Reading& now) : now_(now), source_(now.scene.sources.shared_main()), tree_(now.tree) {}

    const Reading& now() const { return now_; }  ///< as it was before the first change
    const std::string& text() const { return source_->text(); }
    const YamlNode& root() const { return *tree_->root; }
    const YamlTree& tree() const { return *tree_; }
    std::vector<TextPatch> patches() && { return std::move(patches_); }

    /// Splices of the text as it is, in its order. Fails where they make it no YAML.
    Result<void> write(std::vector<Splice> splices) {
        std::string changed = text();
        for (auto splice = splices.rbegin(); splice != splices.rend(); ++splice) {
            const Span span = splice->replaced;
            changed.replace(span.begin, span.end - span.begin, splice->text);
            patches_.push_back({now_.source().place(span), std::move(splice->text)});
        }
        source_ = std::make_shared<const SourceText>(source_->name(), std::move(changed), source_->file());
        tree_ = std::make_shared<const YamlTree>(read_yaml(*source_));
        if (tree_->root) return {};
        return failure(fmt::format("the text would not be read: {}", tree_->diagnostics.front().message));
    }

    Result<Children> children_of(const Indices& node) const {
        Children out;
        out.body = tree_->root;
        out.list = list_of(root(), "scene");
        for (const int index : node) {
            if (!out.list || index >= static_cast<int>(out.list->items.size())) return failure("the text does not hold the node");
            const YamlNode& item = *at(out.list->items, index);
            for (const YamlNode* node_or_alias : {out.list, &item})
                if (node_or_alias->references > 0 || node_or_alias->target) return tl::unexpected(shared_failure(*node_or_alias));
            if (item.kind != YamlKind::map || item.entries() != 1) return failure("the text does not hold the node");
            out = {&item, 0, &item.value(0), nullptr};
            if (out.body->references > 0 || out.body->target) return tl::unexpected(shared_failure(*out.body));
            out.list = list_of(*out.body, "children");
        }
        if (out.list && (out.list->references > 0 || out.list->target)) return tl::unexpected(shared_failure(*out.list));
        return out;
    }

    Result<ItemText> item(const Indices& parent, int index) const {
        const auto children = children_of(parent);
        if (!children) return tl::unexpected(children.error());
        if (!children->list || index >= static_cast<int>(children->list->items.size())) return failure("the text does not hold the node");
        return item_text(text(), *children->list, static_cast<std::size_t>(index));
    }

    Result<void> insert(const Indices& parent, int index, ItemText item) {
        const auto children = children_of(parent);
        if (!children) return tl::unexpected(children.error());
        item.block = with_breaks(item.block);
        const bool first = !children->list || children->list->items.empty();
        std::optional<std::vector<Splice>> splices;
        if (!first) {
            if (auto one = insert_item(text(), *children->list, static_cast<std::size_t>(index), item)) splices = {std::move(*one)};
        } else {
            const ListStyle style = list_style(text(), tree());
            splices = children->owner ? insert_first_item(text(), *children->owner, children->entry, "children", item, style)
                                      : insert_first_item(text(), *children->body, "scene", item, style);
        }
        if (!splices) return failure(std::string(no_room));
        return write(std::move(*splices));
    }

    Result<void> remove(const Indices& parent, int index) {
        const auto children = children_of(parent);
        if (!children) return tl::unexpected(children.error());
        return write(remove_item(text(), *children->list, static_cast<std::size_t>(index)));
    }

    NodeStyle style(const Node* beside) const {
        return {list_style(text(), tree()), [this, beside](Unit unit) { return customary_number(now_.scene, beside, unit); }};
    }

private:
    /// Lines of other files end as those of this one do.
    std::string with_breaks(const std::string& lines) const {
        const std::string_view brk = line_break(text());
        std::string out;
        for (const char c : lines)
            if (c == '\n') out += brk;
            else if (c != '\r') out += c;
        return out;
    }

    const Reading& now_;
    std::shared_ptr<const SourceText> source_;
    std::shared_ptr<const YamlTree> tree_;
    std::vector<TextPatch> patches_;
};

Indices parent_of(Indices node) {
    node.pop_back();
    return node;
}

Result<void> insert_material(Rewriting& text, const Node& material) {
    const std::string entry = fmt::format("{}: {}", material.name, flow_map(explicit_entries(material, text.style(nullptr))));
    const YamlNode& root = text.root();
    const std::size_t section = root.entry_of("materials");
    if (section == root.entries()) {
        std::size_t index = 0;
        for (std::size_t i = 0; i < root.entries(); ++i)
            for (const std::string_view before : {"pinfield", "table", "physics"})
                if (root.key(i).text == before) index = i + 1;
        const bool block = root.style == YamlStyle::block;
        const std::string brk(line_break(text.text()));
        return text.write({insert_entry(text.text(), root, index,
                                        block ? fmt::format("materials:{}  {}", brk, entry) : fmt::format("materials: {{{}}}", entry))});
    }
    const YamlNode& map = root.value(section);
    if (map.target || map.references > 0) return tl::unexpected(shared_failure(map));
    if (map.is_empty()) return text.write({insert_body(text.text(), map, entry)});
    return text.write({insert_entry(text.text(), map, map.entries(), entry)});
}

Result<void> rewrite(Rewriting&, const Scene&, const SetField&) { return failure("a field is no structure"); }

Result<void> rewrite(Rewriting& text, const Scene& scene, const Insert& edit) {
    if (edit.nodes.front().type->meta.kind == NodeKind::record) return insert_material(text, edit.nodes.front());
    const Node* beside = edit.parent ? scene.find(edit.parent) : nullptr;
    const std::string block = edit.text.empty() ? write_item(edit.nodes, text.style(beside)) : edit.text;
    return text.insert(indices_of(scene, edit.parent), edit.index, item_text(block));
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
    return text.insert(indices_of(without, edit.parent), edit.index, *item);
}

Result<void> rewrite(Rewriting& text, const Scene& scene, const Wrap& edit) {
    const Indices parent = indices_of(scene, edit.parent);
    std::vector<std::string> blocks, flows;
    for (int i = 0; i < edit.count; ++i) {
        const Result<ItemText> item = text.item(parent, edit.first + i);
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
    if (const auto inserted = text.insert(parent, edit.first, wrapper); !inserted) return inserted;
    for (int i = edit.count; i-- > 0;)
        if (const auto removed = text.remove(parent, edit.first + 1 + i); !removed) return removed;
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
            fmt::format("{}: {}", field.key, write_value(field, edit.fields[i].value, text.style(&node).number(field.meta.unit)));
        const Splice splice = body.is_empty() ? insert_body(text.text(), body, entry) : insert_entry(text.text(), body, 0, entry);
        if (const auto written = text.write({splice}); !written) return written;
    }
    return {};
}

const YamlNode* node_at(const YamlTree& tree, Span span) {
    const auto found = std::find_if(tree.nodes.begin(), tree.nodes.end(), [&](const YamlNode& node) { return node.span == span; });
    return found == tree.nodes.end() ? nullptr : &*found;
}

/// Everything that says a name, once each, in the order of the text.
class NameSplices {
public:
    NameSplices(const Rewriting& text, const Rename& edit) : text_(text), edit_(edit) {}

    void key(const Place& place) { add({{place.span.begin, place.span.begin + edit_.from.size()}, edit_.to}); }
    void field(const FieldType& type, const FieldSlot& slot) {
        const Value after = renamed(slot.value, edit_.from, edit_.to);
        const YamlNode* node = identical(after, slot.value) ? nullptr : node_at(text_.tree(), slot.where.span);
        if (node) add(value_splice(text_.text(), type, *node, slot.value, after));
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
                if (!edit.from.empty() && expectation.quantity == edit.from + ".hits") names.within(expectation.where);
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

}  // namespace

Result<std::vector<TextPatch>> structure_patches(const Reading& now, const Edit& edit) {
    Rewriting text(now);
    const Result<void> done = std::visit([&](const auto& e) { return rewrite(text, now.scene, e); }, edit);
    if (!done) return tl::unexpected(done.error());
    return std::move(text).patches();
}

Result<std::string> text_of_node(const Reading& now, NodeId node) {
    if (now.scene.find(node)->is_record()) return failure("only nodes of the scene are items of a list");
    Indices indices = indices_of(now.scene, node);
    const int last = indices.back();
    const Result<ItemText> item = Rewriting(now).item(parent_of(std::move(indices)), last);
    if (!item) return tl::unexpected(item.error());
    return item->block;
}

}  // namespace pinfield

#include "engine/io/rewriting.h"

#include <fmt/format.h>

#include <utility>

#include "engine/core/at.h"
#include "engine/io/field_patch.h"
#include "engine/scene/elsewhere.h"

namespace pinfield {
namespace {

constexpr std::string_view no_room =
    "the list stands in one line, where a comment or an anchor would be lost; give its items lines of their own first";

const YamlNode* list_of(const YamlNode& body, std::string_view key) {
    const std::size_t entry = body.kind == YamlKind::map ? body.entry_of(key) : body.entries();
    return entry < body.entries() ? &body.value(entry) : nullptr;
}

}  // namespace

Indices indices_of(const Scene& scene, NodeId node) {
    Indices out;
    for (; node; node = scene.find(node)->parent)
        out.insert(out.begin(), index_in_text(scene, scene.find(node)->parent, scene.index_of(node)));
    return out;
}

int index_in_text(const Scene& scene, NodeId parent, int index) { return index - included_children(scene, parent); }

Result<void> Rewriting::write(std::vector<Splice> splices) {
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

Result<Children> Rewriting::children_of(const Indices& node) const {
    Children out;
    out.body = tree_->root;
    out.list = list_of(root(), "scene");
    for (const int index : node) {
        if (!out.list || index < 0 || index >= static_cast<int>(out.list->items.size())) return failure("the text does not hold the node");
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

Result<ItemText> Rewriting::item(const Indices& parent, int index) const {
    const auto children = children_of(parent);
    if (!children) return tl::unexpected(children.error());
    if (!children->list || index < 0 || index >= static_cast<int>(children->list->items.size())) return failure("the text does not hold the node");
    return item_text(text(), *children->list, static_cast<std::size_t>(index));
}

Result<void> Rewriting::insert(const Indices& parent, int index, ItemText item) {
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

Result<void> Rewriting::remove(const Indices& parent, int index) {
    const auto children = children_of(parent);
    if (!children) return tl::unexpected(children.error());
    return write(remove_item(text(), *children->list, static_cast<std::size_t>(index)));
}

NodeStyle Rewriting::style(const Node* beside) const {
    return {list_style(text(), tree()), [this, beside](Unit unit) { return customary_number(now_.scene, beside, unit); }};
}

std::string Rewriting::with_breaks(const std::string& lines) const {
    const std::string_view brk = line_break(text());
    std::string out;
    for (const char c : lines)
        if (c == '\n')
            out += brk;
        else if (c != '\r')
            out += c;
    return out;
}

}  // namespace pinfield

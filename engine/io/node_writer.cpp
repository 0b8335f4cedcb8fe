#include "engine/io/node_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/shown.h"
#include "engine/io/value_writer.h"

namespace pinfield {
namespace {

/// Does what a template or a copy made begin with this node?
bool is_first_made(const Scene& scene, const Node& node) {
    if (!node.origin) return false;
    const Node* parent = scene.find(node.parent);
    if (parent && parent->origin == node.origin) return false;
    const std::vector<NodeId>& siblings = scene.siblings(node.id);
    const auto self = std::find(siblings.begin(), siblings.end(), node.id);
    return self == siblings.begin() || scene.find(*(self - 1))->origin != node.origin;
}

void write_node(const Scene& scene, const Node& node, std::size_t indent, std::string& out) {
    const std::string margin(indent, ' ');
    if (node.generator) {
        out += fmt::format("{}{}\n", margin, node.generator->item);
        return;
    }
    if (is_first_made(scene, node)) out += fmt::format("{}# {}\n", margin, node.origin->what);
    const std::vector<std::string> entries = entries_of(node);
    if (node.children.empty()) {
        out += fmt::format("{}- {}: {}\n", margin, node.type->key(), flow_map(entries));
        return;
    }
    out += fmt::format("{}- {}:\n", margin, node.type->key());
    for (const std::string& entry : entries) out += fmt::format("{}    {}\n", margin, entry);
    out += fmt::format("{}    children:\n", margin);
    for (const NodeId child : node.children) write_node(scene, *scene.find(child), indent + 6, out);
}

/// The common fields first, so that a line begins with id and place.
template <class Write>
std::vector<std::string> entries_if(const Node& node, Write write) {
    std::vector<std::string> common, own;
    for (std::size_t i = 0; i < node.fields.size(); ++i) {
        const FieldType& field = node.type->fields[i];
        if (std::optional<std::string> value = write(field, node.fields[i]))
            (field.common ? common : own).push_back(fmt::format("{}: {}", field.key, *value));
    }
    common.insert(common.end(), own.begin(), own.end());
    return common;
}

std::string write_item_of(const Subtree& nodes, std::size_t& next, const NodeStyle& style) {
    const Node& node = nodes[next++];
    std::vector<std::string> items;
    for (std::size_t i = 0; i < node.children.size(); ++i) items.push_back(write_item_of(nodes, next, style));
    if (node.generator) return node.generator->item;
    if (!items.empty()) return write_item_around(node, items, style);
    return fmt::format("- {}: {}", node.type->key(), flow_map(explicit_entries(node, style)));
}

}  // namespace

std::string flow_map(const std::vector<std::string>& entries) { return fmt::format("{{{}}}", fmt::join(entries, ", ")); }

std::vector<std::string> entries_of(const Node& node) {
    return entries_if(node, [](const FieldType& field, const FieldSlot& slot) -> std::optional<std::string> {
        if (!field.meta.required && !slot.written && identical(slot.value, field.initial)) return {};
        return write_slot(field, slot);
    });
}

std::vector<std::string> explicit_entries(const Node& node, const NodeStyle& style) {
    return entries_if(node, [&](const FieldType& field, const FieldSlot& slot) -> std::optional<std::string> {
        if (!slot.is_explicit) return {};
        return write_slot(field, slot, style.number ? style.number(field.meta.unit) : std::string());
    });
}

std::string write_item(const Subtree& nodes, const NodeStyle& style) {
    std::size_t next = 0;
    return write_item_of(nodes, next, style);
}

std::string write_item_around(const Node& node, const std::vector<std::string>& items, const NodeStyle& style) {
    const std::string margin(style.lists.body, ' ');
    std::string out = fmt::format("- {}:", node.type->key());
    for (const std::string& entry : explicit_entries(node, style)) out += fmt::format("\n{}{}", margin, entry);
    out += fmt::format("\n{}children:", margin);
    for (const std::string& item : items) out += fmt::format("\n{}", indented_lines(item, style.lists.body + style.lists.dash));
    return out;
}

std::string file_comment(const Scene& scene, FileId& file, const Place& place) {
    if (!place || place.file == file) return {};
    file = place.file;
    const Sources::Included* included = scene.sources.inclusion(file);
    const std::string& name = scene.sources.main().name();
    return fmt::format("  # {}\n", shown(included ? included->path : name.substr(name.rfind('/') + 1)));
}

std::string write_nodes(const Scene& scene, const std::vector<NodeId>& nodes, std::size_t indent) {
    std::string out;
    for (const NodeId id : nodes) write_node(scene, *scene.find(id), indent, out);
    return out;
}

}  // namespace pinfield

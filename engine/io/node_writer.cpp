#include "engine/io/node_writer.h"

#include <fmt/format.h>

#include "engine/io/value_writer.h"

namespace pinfield {
namespace {

void write_node(const Scene& scene, const Node& node, std::size_t indent, std::string& out) {
    const std::string margin(indent, ' ');
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

}  // namespace

std::string flow_map(const std::vector<std::string>& entries) { return fmt::format("{{{}}}", fmt::join(entries, ", ")); }

std::vector<std::string> entries_of(const Node& node) {
    std::vector<std::string> common, own;
    for (std::size_t i = 0; i < node.fields.size(); ++i) {
        const FieldType& field = node.type->fields[i];
        if (!field.meta.required && identical(node.fields[i].value, field.initial)) continue;
        (field.common ? common : own).push_back(fmt::format("{}: {}", field.key, write_value(field, node.fields[i].value)));
    }
    common.insert(common.end(), own.begin(), own.end());
    return common;
}

std::string write_nodes(const Scene& scene, const std::vector<NodeId>& nodes, std::size_t indent) {
    std::string out;
    for (const NodeId id : nodes) write_node(scene, *scene.find(id), indent, out);
    return out;
}

}  // namespace pinfield

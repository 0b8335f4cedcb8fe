#include "engine/io/write_table.h"

#include <fmt/format.h>

#include "engine/core/numbers.h"
#include "engine/io/value_writer.h"

namespace pinfield {
namespace {

/// "key: value" of each field that differs from its default; the common ones first, so that a line begins with id and
/// place.
std::vector<std::string> entries_of(const Node& node) {
    std::vector<std::string> common, own;
    for (std::size_t i = 0; i < node.fields.size(); ++i) {
        const FieldType& field = node.type->fields[i];
        if (!field.meta.required && identical(node.fields[i].value, field.initial)) continue;
        (field.common ? common : own)
            .push_back(fmt::format("{}: {}", field.key, write_value(field, node.fields[i].value)));
    }
    common.insert(common.end(), own.begin(), own.end());
    return common;
}

std::string flow_map(const std::vector<std::string>& entries) {
    return fmt::format("{{{}}}", fmt::join(entries, ", "));
}

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

std::string launch_text(const TableTest::Launch& launch) {
    const auto pair = [](const Vec2& v) { return fmt::format("[{}, {}]", to_text(v.x()), to_text(v.y())); };
    return fmt::format("{{at: {}, velocity: {}}}", pair(launch.at), pair(launch.velocity));
}

std::string test_text(const TableTest& test) {
    std::vector<std::string> entries, launches, expectations;
    for (const auto& launch : test.launches) launches.push_back(launch_text(launch));
    for (const auto& e : test.expectations)
        expectations.push_back(fmt::format("{} {} {}", e.quantity, e.comparison, to_text(e.value)));
    if (!test.name.empty()) entries.push_back("name: " + write_text(test.name));
    if (launches.size() == 1) entries.push_back("launch: " + launches[0]);
    if (launches.size() > 1) entries.push_back(fmt::format("launch: [{}]", fmt::join(launches, ", ")));
    entries.push_back("run: " + to_text(test.run));
    entries.push_back(fmt::format("expect: [{}]", fmt::join(expectations, ", ")));
    return flow_map(entries);
}

std::string input_text(const InputBinding& input) {
    std::vector<std::string> keys;
    for (const std::string& key : input.keys) keys.push_back(write_text(key));
    return fmt::format("{}: [{}]", input.name, fmt::join(keys, ", "));
}

}  // namespace

std::string write_table(const Scene& scene) {
    std::string out = "pinfield: 1\n";
    for (const Node* record : {&scene.table(), &scene.physics()})
        if (const auto entries = entries_of(*record); !entries.empty())
            out += fmt::format("{}: {}\n", record->type->key(), flow_map(entries));
    if (!scene.materials().empty()) out += "materials:\n";
    for (const NodeId id : scene.materials())
        out += fmt::format("  {}: {}\n", scene.find(id)->name, flow_map(entries_of(*scene.find(id))));
    out += scene.roots().empty() ? "scene: []\n" : "scene:\n";
    for (const NodeId id : scene.roots()) write_node(scene, *scene.find(id), 2, out);
    std::vector<std::string> inputs;
    for (const InputBinding& input : scene.inputs) inputs.push_back(input_text(input));
    if (!inputs.empty()) out += fmt::format("inputs: {}\n", flow_map(inputs));
    if (!scene.tests.empty()) out += "tests:\n";
    for (const TableTest& test : scene.tests) out += fmt::format("  - {}\n", test_text(test));
    return out;
}

}  // namespace pinfield

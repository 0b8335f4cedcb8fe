// table: and physics:, one record each.
#include <fmt/format.h>

#include "engine/io/node_reader.h"
#include "engine/io/node_writer.h"
#include "engine/io/schema_parts.h"
#include "engine/io/section.h"

namespace pinfield::sections {
namespace {

std::string written(const Node& record) {
    const std::vector<std::string> entries = entries_of(record);
    return entries.empty() ? std::string() : fmt::format("{}: {}\n", record.type->key(), flow_map(entries));
}

}  // namespace

extern const Section table{
    .key = "table",
    .read = [](ReadContext& context, Scene& scene, const YamlNode& key,
               const YamlNode& value) { read_record(context, scene.table(), key, value); },
    .write = [](const Scene& scene) { return written(scene.table()); },
    .schema = [] { return schema::reference("table"); },
    .same = [](const Scene& a, const Scene& b) { return same_node(a, a.table(), b, b.table()); },
    .why_not_included = "a table has one size, slope and name",
};

extern const Section physics{
    .key = "physics",
    .read = [](ReadContext& context, Scene& scene, const YamlNode& key,
               const YamlNode& value) { read_record(context, scene.physics(), key, value); },
    .write = [](const Scene& scene) { return written(scene.physics()); },
    .schema = [] { return schema::reference("physics"); },
    .same = [](const Scene& a, const Scene& b) { return same_node(a, a.physics(), b, b.physics()); },
    .why_not_included = "all that moves on a table has one clock and one ball",
};

}  // namespace pinfield::sections

// scene: the list of nodes.
#include "engine/io/node_reader.h"
#include "engine/io/node_writer.h"
#include "engine/io/schema_parts.h"
#include "engine/io/section.h"

namespace pinfield::sections {

extern const Section scene{
    .key = "scene",
    .read = [](ReadContext& context, Scene& table, const YamlNode&, const YamlNode& value) { read_nodes(context, table, {}, value); },
    .write =
        [](const Scene& table) {
            return table.roots().empty() ? std::string("scene: []\n") : "scene:\n" + write_nodes(table, table.roots(), 2);
        },
    .schema = [] { return schema::list(schema::reference("scene_node")); },
    .same = [](const Scene& a, const Scene& b) { return same_nodes(a, a.roots(), b, b.roots()); },
};

}  // namespace pinfield::sections

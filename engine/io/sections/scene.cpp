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
            std::string out;
            FileId file = main_file;
            for (const NodeId id : table.roots())
                if (const Place& place = table.find(id)->where; !is_elsewhere(table, place))
                    out += file_comment(table, file, place) + write_nodes(table, {id}, 2);
            return out.empty() ? std::string("scene: []\n") : "scene:\n" + out;
        },
    .schema = [] { return schema::list(schema::reference("scene_node")); },
    .same = [](const Scene& a, const Scene& b) { return same_nodes(a, a.roots(), b, b.roots()); },
};

}  // namespace pinfield::sections

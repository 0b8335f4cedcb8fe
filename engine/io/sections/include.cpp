// include: [parts/walls.yaml, parts/gears.yaml]
#include "engine/io/include_reader.h"

#include <fmt/format.h>

#include "engine/io/node_writer.h"
#include "engine/io/section.h"
#include "engine/io/value_writer.h"

namespace pinfield::sections {
namespace {

void read(ReadContext& context, Scene& scene, const YamlNode&, const YamlNode& list) {
    if (list.kind == YamlKind::sequence)
        for (const YamlNode* item : list.items)
            if (item->resolved().kind == YamlKind::scalar) scene.includes.emplace_back(item->resolved().text);
    context.inclusion->read(context, scene.sources, list);
}

std::string write(const Scene& scene) {
    std::vector<std::string> paths;
    for (const std::string& path : scene.includes) paths.push_back(write_text(path));
    return paths.empty() ? std::string() : fmt::format("include: [{}]\n", fmt::join(paths, ", "));
}

}  // namespace

extern const Section include{
    .key = "include",
    .read = read,
    .write = write,
    .schema = [] { return std::string(R"({"description": "Files below this one's folder whose params, materials, templates, scene and inputs belong to the table.", "type": ["array", "null"], "items": {"type": "string", "pattern": "^[^/\\\\:][^\\\\:]*$"}})"); },
    .same = [](const Scene& a, const Scene& b) { return a.includes == b.includes; },
    .phase = Section::Phase::includes,
};

}  // namespace pinfield::sections

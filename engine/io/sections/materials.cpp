// materials: {rubber: {restitution: 0.8}, ...}
#include <fmt/format.h>

#include "engine/io/node_reader.h"
#include "engine/io/node_writer.h"
#include "engine/io/schema_parts.h"
#include "engine/io/section.h"
#include "engine/scene/validate.h"

namespace pinfield::sections {
namespace {

void read(ReadContext& context, Scene& scene, const YamlNode&, const YamlNode& section) {
    if (section.is_empty()) return;
    if (section.kind != YamlKind::map)
        return context.report(Code::wrong_shape, section.span, "materials are due here",
                              "write materials: {rubber: {restitution: 0.8}}");
    const NodeType& type = *context.catalog.find("material");
    for (std::size_t i = 0; i < section.entries() && !context.full(); ++i) {
        const YamlNode& key = section.key(i);
        const YamlNode& body = section.value(i).resolved();
        if (!is_plain_key(key)) continue;
        const bool after_empty = i > 0 && section.value(i - 1).resolved().is_empty();
        if (after_empty && type.find_field(key.text) && body.kind == YamlKind::scalar)
            context.report(Code::under_indented, key.span,
                           fmt::format("the fields of {} are indented too little", section.key(i - 1).text),
                           "indent two more");
        else if (!is_name(key.text))
            context.report(Code::bad_name, key.span, fmt::format("{} is not a valid name for a material", key.text),
                           "small letters, digits and _");
        else if (const auto [twin, is_new] = context.materials.emplace(key.text, context.source().place(key.span)); is_new)
            read_record(context, scene.add_material(std::string(key.text)), key, body);
        else if (twin->second.file == context.source().file())
            context.fail_silently();  // the reader of YAML has told
        else
            context.report(Code::duplicate_id, key.span, fmt::format("there is a material {} already", key.text),
                           scene.sources.line_from(context.source().place(key.span), twin->second) + " has it");
    }
}

std::string write(const Scene& scene) {
    std::string out;
    FileId file = main_file;
    for (const NodeId id : scene.materials()) {
        const Node& material = *scene.find(id);
        if (is_elsewhere(scene, material.key)) continue;
        out += file_comment(scene, file, material.key);
        out += fmt::format("  {}: {}\n", material.name, flow_map(entries_of(material)));
    }
    return out.empty() ? out : "materials:\n" + out;
}

}  // namespace

extern const Section materials{
    .key = "materials",
    .read = read,
    .write = write,
    .schema = [] { return schema::named_map(schema::reference("material")); },
    .same = [](const Scene& a, const Scene& b) { return same_nodes(a, a.materials(), b, b.materials()); },
};

}  // namespace pinfield::sections

// templates: {gear: {args: {r: 46mm}, nodes: [circle: {radius: r}]}}
#include <fmt/format.h>

#include "engine/expression/expression.h"
#include "engine/io/calculate.h"
#include "engine/io/entries.h"
#include "engine/io/node_writer.h"
#include "engine/io/schema_parts.h"
#include "engine/io/section.h"
#include "engine/io/yaml_items.h"
#include "engine/scene/validate.h"

namespace pinfield::sections {
namespace {

/// Arguments mean one thing each: none is called as a param is.
bool are_arguments(ReadContext& context, const YamlNode& args) {
    if (args.kind != YamlKind::map)
        return context.report(Code::wrong_shape, args.span, "arguments are due here", "write args: {r: 3cm}"), false;
    if (args.entries() > context.limits.params)
        return context.report(Code::too_many_params, args.span, fmt::format("{} arguments; at most {} are read", args.entries(), context.limits.params)), false;
    const std::size_t errors = context.errors_so_far();
    for (std::size_t i = 0; i < args.entries(); ++i) {
        const YamlNode& key = args.key(i);
        if (!is_plain_key(key)) continue;
        if (!is_name(key.text) || is_reserved_name(key.text) || key.text == "i")
            context.report(Code::bad_name, key.span, fmt::format("{} is not a valid name for an argument", shortened(key.text)),
                           is_name(key.text) ? "it means something in every expression" : "small letters, digits and _, not beginning with a digit");
        else if (context.table_names.find(key.text))
            context.report(Code::duplicate_id, key.span, fmt::format("the param {} is called so", key.text), "call the argument otherwise");
    }
    return context.errors_so_far() == errors;
}

/// Of two in one file the reader of YAML has told.
void report_twin(ReadContext& context, const Sources& sources, const YamlNode& key, const TemplateText& twin) {
    if (twin.text == &context.source()) return context.fail_silently();
    const std::string where = sources.line_from(context.source().place(key.span), twin.text->place(twin.key->span));
    context.report(Code::duplicate_id, key.span, fmt::format("there is a template {} already", key.text), where + " has it");
}

/// Its text; null, and reported, where it has no name of its own.
const TemplateText* read_entry(ReadContext& context, const Sources& sources, const YamlNode& key, const YamlNode& body) {
    if (!is_name(key.text))
        return context.report(Code::bad_name, key.span, fmt::format("{} is not a valid name for a template", shortened(key.text)), "small letters, digits and _"), nullptr;
    if (const auto twin = context.templates.find(key.text); twin != context.templates.end())
        return report_twin(context, sources, key, twin->second), nullptr;
    TemplateText text{.key = &key, .text = &context.source()};
    if (body.kind != YamlKind::map) {
        context.report(Code::wrong_shape, body.span, "the nodes of a template are due here", fmt::format("write {}: {{nodes: [...]}}", key.text));
    } else {
        static const std::vector<std::string_view> keys{"args", "nodes"};
        read_entries(context, "a template", body, keys, [&](auto index, const YamlNode& value) {
            if (index == 1) text.nodes = &value;
            else if (are_arguments(context, value)) text.args = &value;
        });
        if (!body.find("nodes")) context.report(Code::missing_field, key.span, fmt::format("the template {} needs nodes", key.text));
    }
    return &context.templates.emplace(key.text, text).first->second;
}

/// In one line. An argument without a value is one that every use must give.
std::string written_arguments(const std::string& source, const YamlNode& args) {
    std::vector<std::string> entries;
    for (std::size_t i = 0; i < args.entries(); ++i) {
        const YamlNode& value = args.value(i).resolved();
        entries.push_back(fmt::format("{}: {}", args.key(i).text, value.is_empty() ? "~" : copy_in_line(source, value, Aliases::written_out)));
    }
    return flow_map(entries);
}

/// Its entry in lines: the arguments in one, and each node in one.
std::string lines_of(const ReadContext& context, const TemplateText& text) {
    const std::string& source = context.source().text();
    std::string out = fmt::format("  {}:\n", text.key->text);
    if (text.args) out += fmt::format("    args: {}\n", written_arguments(source, *text.args));
    if (!text.nodes || text.nodes->kind != YamlKind::sequence || text.nodes->items.empty()) return out + "    nodes: []\n";
    out += "    nodes:\n";
    for (const YamlNode* item : text.nodes->items) {
        const YamlNode& node = item->resolved();
        if (node.kind == YamlKind::map && node.entries() == 1)
            out += fmt::format("      - {}: {}\n", node.key(0).text, copy_in_line(source, node.value(0).resolved(), Aliases::written_out));
    }
    return out;
}

void read(ReadContext& context, Scene& scene, const YamlNode&, const YamlNode& section) {
    if (section.is_empty()) return;
    if (section.kind != YamlKind::map)
        return context.report(Code::wrong_shape, section.span, "templates are due here", "write templates: {gear: {nodes: [...]}}");
    for (std::size_t i = 0; i < section.entries() && !context.full(); ++i) {
        const YamlNode& key = section.key(i);
        if (!is_plain_key(key)) continue;
        const TemplateText* text = read_entry(context, scene.sources, key, section.value(i).resolved());
        if (text && context.source().file() == main_file) scene.templates += lines_of(context, *text);
    }
}

}  // namespace

extern const Section templates{
    .key = "templates",
    .read = read,
    .write = [](const Scene& scene) { return scene.templates.empty() ? std::string() : "templates:\n" + scene.templates; },
    .schema =
        [] {
            return schema::named_map(fmt::format(
                R"({{"type": "object", "required": ["nodes"], "additionalProperties": false, "properties": {{"args": {}, "nodes": {}}}}})",
                schema::named_map(R"({"type": ["number", "string", "null"]})"), schema::list(schema::reference("scene_node"))));
        },
    .same = [](const Scene& a, const Scene& b) { return a.templates == b.templates; },
    .phase = Section::Phase::templates,
};

}  // namespace pinfield::sections

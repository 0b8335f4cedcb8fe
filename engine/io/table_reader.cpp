#include "engine/io/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/io/node_reader.h"
#include "engine/io/section_reader.h"

namespace pinfield {
namespace {

struct Unsupported {
    std::string_view key;
    Code code;
};
constexpr std::array unsupported{
    Unsupported{"params", Code::params_unsupported}, Unsupported{"templates", Code::templates_unsupported},
    Unsupported{"include", Code::include_unsupported}, Unsupported{"game", Code::game_unsupported}};

const std::vector<std::string_view> section_keys{"pinfield", "table", "physics", "params", "materials", "templates",
                                                 "include",  "scene", "inputs",  "game",   "tests"};

void read_version(ReadContext& context, const YamlNode& root) {
    const YamlNode* version = root.find("pinfield");
    if (!version)
        return context.report(Code::missing_version, {root.span.begin, root.span.begin},
                              "the file does not say its version", "begin with: pinfield: 1");
    if (version->kind == YamlKind::scalar && version->text == "1") return;
    const bool bare = version->kind == YamlKind::scalar;
    context.report(Code::unknown_version, version->span,
                   bare ? fmt::format("version {} of the format is not known", version->text)
                        : "the version of the format is due here",
                   "this program reads version 1");
}

void read_record(ReadContext& context, Node& record, const YamlNode& key, const YamlNode& body) {
    record.key = key.span;
    record.where = {key.span.begin, std::max(key.span.end, body.span.end)};
    read_fields(context, record, key, body);
}

void read_materials(ReadContext& context, Scene& scene, const YamlNode& section) {
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
            context.report(Code::bad_name, key.span, fmt::format("{} is no name for a material", key.text),
                           "small letters, digits and _");
        else
            read_record(context, scene.add_material(std::string(key.text)), key, body);
    }
}

/// A key that no section has: often a field of the empty section before it, indented too little.
void report_unknown_section(ReadContext& context, const YamlNode& root, std::size_t i) {
    const YamlNode& key = root.key(i);
    if (i > 0 && root.value(i - 1).resolved().is_empty()) {
        const NodeType* type = context.catalog.find(root.key(i - 1).text);
        if (type && type->meta.kind == NodeKind::record && type->find_field(key.text))
            return context.report(Code::under_indented, key.span,
                                  fmt::format("the fields of {} are indented too little", type->key()),
                                  "indent two more");
    }
    context.report(Code::unknown_key, key.span, fmt::format("a table has no {}", key.text),
                   suggestion(key.text, section_keys));
}

void read_sections(ReadContext& context, Scene& scene, const YamlNode& root) {
    for (std::size_t i = 0; i < root.entries() && !context.full(); ++i) {
        const std::string_view key = root.key(i).text;
        if (!is_plain_key(root.key(i))) continue;
        const YamlNode& value = root.value(i).resolved();
        const auto refused =
            std::find_if(unsupported.begin(), unsupported.end(), [&](const Unsupported& u) { return u.key == key; });
        if (refused != unsupported.end())
            context.report(refused->code, root.key(i).span,
                           fmt::format("{} {} not supported yet", key, key.ends_with('s') ? "are" : "is"));
        else if (key == "table")
            read_record(context, scene.table(), root.key(i), value);
        else if (key == "physics")
            read_record(context, scene.physics(), root.key(i), value);
        else if (key == "materials")
            read_materials(context, scene, value);
        else if (key == "scene")
            read_nodes(context, scene, {}, value);
        else if (key == "inputs")
            read_inputs(context, scene, value);
        else if (std::find(section_keys.begin(), section_keys.end(), key) == section_keys.end())
            report_unknown_section(context, root, i);
    }
    if (context.full()) return;
    check_scene(context, scene);
    if (const YamlNode* tests = root.find("tests")) read_tests(context, scene, *tests);
    const YamlNode* nodes = root.find("scene");
    if (!nodes || nodes->is_empty())
        context.report(Code::empty_scene, {root.span.begin, root.span.begin}, "the table has no scene");
}

}  // namespace

ReadResult read_table(std::shared_ptr<const SourceText> source, std::shared_ptr<const Catalog> catalog,
                      const Limits& limits) {
    ReadResult result{source, Scene(catalog), {}};
    YamlTree tree = read_yaml(*source, limits);
    result.diagnostics = std::move(tree.diagnostics);
    if (!tree.root) return result;
    ReadContext context{*source, *catalog, limits, result.diagnostics};
    const YamlNode& root = *tree.root;
    if (root.kind != YamlKind::map) {
        context.report(Code::wrong_shape, root.span, "a table is a map of sections", "begin with: pinfield: 1");
        return result;
    }
    read_version(context, root);
    read_sections(context, result.scene, root);
    std::stable_sort(result.diagnostics.begin(), result.diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.where.begin < b.where.begin; });
    return result;
}

}  // namespace pinfield

#include "engine/io/table_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/io/section.h"
#include "engine/scene/validate.h"

namespace pinfield {
namespace {

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
    std::vector<std::string_view> keys;
    for (const Section* section : all_sections())
        if (section->read) keys.push_back(section->key);
    context.report(Code::unknown_key, key.span, fmt::format("a table has no {}", key.text), suggestion(key.text, keys));
}

void read_sections(ReadContext& context, Scene& scene, const YamlNode& root, bool those_naming_nodes) {
    for (std::size_t i = 0; i < root.entries() && !context.full(); ++i) {
        const YamlNode& key = root.key(i);
        if (!is_plain_key(key)) continue;
        const Section* section = find_section(key.text);
        if ((section && section->names_nodes) != those_naming_nodes) continue;
        if (!section)
            report_unknown_section(context, root, i);
        else if (!section->read)
            context.report(section->unsupported, key.span,
                           fmt::format("{} {} not supported yet", key.text, key.text.ends_with('s') ? "are" : "is"));
        else
            section->read(context, scene, key, root.value(i).resolved());
    }
}

void read_root(ReadContext& context, Scene& scene, const YamlNode& root) {
    const Span begin{root.span.begin, root.span.begin};
    if (!root.find("pinfield"))
        context.report(Code::missing_version, begin, "the file does not say its version", "begin with: pinfield: 1");
    read_sections(context, scene, root, false);
    if (context.full()) return;
    for (Diagnostic& found : check_relations(scene, context.limits.errors)) context.report(std::move(found));
    read_sections(context, scene, root, true);
    const YamlNode* nodes = root.find("scene");
    if (!nodes || nodes->is_empty()) context.report(Code::empty_scene, begin, "the table has no scene");
}

}  // namespace

Reading read_table(std::shared_ptr<const SourceText> source, std::shared_ptr<const Catalog> catalog, const Limits& limits) {
    const auto tree = std::make_shared<YamlTree>(read_yaml(*source, limits));
    Reading result{tree, Scene(catalog), tree->diagnostics};
    result.scene.sources = Sources(source);
    if (!tree->root) return result;
    ReadContext context{*source, *catalog, limits, result.diagnostics};
    const YamlNode& root = *tree->root;
    if (root.kind != YamlKind::map) {
        context.report(Code::wrong_shape, root.span, "a table is a map of sections", "begin with: pinfield: 1");
        return result;
    }
    read_root(context, result.scene, root);
    std::stable_sort(result.diagnostics.begin(), result.diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.where.span.begin < b.where.span.begin; });
    return result;
}

}  // namespace pinfield

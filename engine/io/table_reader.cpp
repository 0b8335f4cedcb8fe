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

void read_sections(ReadContext& context, Scene& scene, const YamlNode& root, Section::Phase phase) {
    for (std::size_t i = 0; i < root.entries() && !context.full(); ++i) {
        const YamlNode& key = root.key(i);
        if (!is_plain_key(key)) continue;
        const Section* section = find_section(key.text);
        if ((section ? section->phase : Section::Phase::as_it_stands) != phase) continue;
        if (!section)
            report_unknown_section(context, root, i);
        else if (!section->read)
            context.report(section->unsupported, key.span,
                           fmt::format("{} {} not supported yet", key.text, key.text.ends_with('s') ? "are" : "is"));
        else
            section->read(context, scene, key, root.value(i).resolved());
    }
}

/// Params and templates that nothing depends on: often a name that was misspelt elsewhere.
void report_unused(ReadContext& context, const Scene& scene) {
    if (has_errors(context.diagnostics)) return;  // what could not be read may use them
    for (const Param& param : scene.params)
        if (!context.table_names.is_used(param.name))
            context.report(diagnose(Code::unused_param, param.where, fmt::format("nothing depends on the param {}", param.name)));
    for (const auto& [name, text] : context.templates)
        if (!text.is_used)
            context.report(Code::unused_template, text.key->span, fmt::format("nothing uses the template {}", name));
}

void read_root(ReadContext& context, Scene& scene, const YamlNode& root) {
    const Span begin{root.span.begin, root.span.begin};
    if (!root.find("pinfield"))
        context.report(Code::missing_version, begin, "the file does not say its version", "begin with: pinfield: 1");
    context.names = &context.table_names;
    for (const auto phase : {Section::Phase::params, Section::Phase::templates, Section::Phase::as_it_stands})
        read_sections(context, scene, root, phase);
    if (context.full()) return;
    for (Diagnostic& found : check_relations(scene, context.limits.errors)) context.report(std::move(found));
    read_sections(context, scene, root, Section::Phase::after_nodes);
    report_unused(context, scene);
    const YamlNode* nodes = root.find("scene");
    if (!nodes || nodes->is_empty()) context.report(Code::empty_scene, begin, "the table has no scene");
}

Reading read_tree(const Sources& sources, const std::shared_ptr<const YamlTree>& tree, const std::shared_ptr<const Catalog>& catalog,
                  const Limits& limits, const std::map<std::string, double>* set_params) {
    Reading result{tree, Scene(catalog), tree->diagnostics};
    result.scene.sources = sources;
    if (!tree->root) return result;
    ReadContext context{&sources.main(), *catalog, limits, result.diagnostics, set_params};
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

}  // namespace

Reading read_table(std::shared_ptr<const SourceText> source, std::shared_ptr<const Catalog> catalog, const Limits& limits) {
    const auto tree = std::make_shared<YamlTree>(read_yaml(*source, limits));
    return read_tree(Sources(std::move(source)), tree, catalog, limits, nullptr);
}

Reading read_with_params(const Reading& now, const std::map<std::string, double>& values, const Limits& limits) {
    return read_tree(now.scene.sources, now.tree, now.scene.shared_catalog(), limits, &values);
}

}  // namespace pinfield

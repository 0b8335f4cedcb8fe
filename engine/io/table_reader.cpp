#include "engine/io/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/io/include_reader.h"
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
        if (section->read || section->read_all) keys.push_back(section->key);
    context.report(Code::unknown_key, key.span, fmt::format("a table has no {}", key.text), suggestion(key.text, keys));
}

void read_section(ReadContext& context, Scene& scene, const YamlNode& root, std::size_t i, const Section& section) {
    const YamlNode& key = root.key(i);
    if (context.source().file() != main_file && !section.why_not_included.empty())
        context.report(Code::misplaced_section, key.span, fmt::format("{} can stand in the table's own file only: {}", key.text, section.why_not_included),
                       "move it there");
    else if (section.read)
        section.read(context, scene, key, root.value(i).resolved());
    else if (!section.read_all)
        context.report(section.unsupported, key.span,
                       fmt::format("{} {} not supported yet", key.text, key.text.ends_with('s') ? "are" : "is"));
}

void read_sections(ReadContext& context, Scene& scene, const YamlNode& root, Section::Phase phase) {
    for (std::size_t i = 0; i < root.entries() && !context.full(); ++i) {
        const YamlNode& key = root.key(i);
        if (!is_plain_key(key)) continue;
        const Section* section = find_section(key.text);
        if ((section ? section->phase : Section::Phase::as_it_stands) != phase) continue;
        if (section) read_section(context, scene, root, i, *section);
        else report_unknown_section(context, root, i);
    }
}

/// What each of the table's files says in a section, in their order.
std::vector<SectionText> texts_of(const ReadContext& context, const Section& section) {
    std::vector<SectionText> out;
    for (const TableText& file : context.files)
        for (std::size_t i = 0; i < file.root->entries(); ++i)
            if (const YamlNode& key = file.root->key(i); is_plain_key(key) && key.text == section.key)
                out.push_back({file.text, &file.root->value(i).resolved()});
    return out;
}

void read_phase(ReadContext& context, Scene& scene, Section::Phase phase) {
    for (const Section* section : all_sections())
        if (section->read_all && section->phase == phase) section->read_all(context, scene, texts_of(context, *section));
    for (const TableText& file : context.files) {
        const InText there(context, file.text);
        read_sections(context, scene, *file.root, phase);
    }
}

/// Params and templates that nothing depends on: often a name that was misspelt elsewhere. What is included may hold more than one table uses.
void report_unused(ReadContext& context, const Scene& scene) {
    if (has_errors(context.diagnostics)) return;  // what could not be read may use them
    for (const Param& param : scene.params)
        if (!is_included(param.where) && !context.table_names.is_used(param.name))
            context.report(diagnose(Code::unused_param, param.where, fmt::format("nothing depends on the param {}", param.name)));
    for (const auto& [name, text] : context.templates)
        if (!text.is_used && text.text == &context.source())
            context.report(Code::unused_template, text.key->span, fmt::format("nothing uses the template {}", name));
}

void report_missing_versions(ReadContext& context) {
    for (const TableText& file : context.files) {
        const InText there(context, file.text);
        const std::size_t begin = file.root->span.begin;
        if (!file.root->find("pinfield"))
            context.report(Code::missing_version, {begin, begin}, "the file does not say its version", "begin with: pinfield: 1");
    }
}

bool has_nodes(const TableText& file) {
    const YamlNode* nodes = file.root->find("scene");
    return nodes && !nodes->is_empty();
}

void read_root(ReadContext& context, Scene& scene, const YamlNode& root) {
    context.names = &context.table_names;
    read_sections(context, scene, root, Section::Phase::includes);
    context.files.push_back({&context.source(), &root});
    report_missing_versions(context);
    for (const auto phase : {Section::Phase::params, Section::Phase::templates, Section::Phase::as_it_stands})
        read_phase(context, scene, phase);
    if (context.full()) return;
    for (Diagnostic& found : check_relations(scene, context.limits.errors)) context.report(std::move(found));
    read_phase(context, scene, Section::Phase::after_nodes);
    report_unused(context, scene);
    if (std::none_of(context.files.begin(), context.files.end(), has_nodes))
        context.report(Code::empty_scene, {root.span.begin, root.span.begin}, "the table has no scene");
}

/// In the order of the texts.
void sort(Diagnostics& diagnostics) {
    std::stable_sort(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::pair(a.where.file.value, a.where.span.begin) < std::pair(b.where.file.value, b.where.span.begin);
    });
}

/// What a table is read from beside its text.
struct Given {
    const OpenFile& open;
    const TableFiles& known;
    const std::map<std::string, double>* set_params = nullptr;
};

Reading read_tree(std::shared_ptr<const SourceText> source, const std::shared_ptr<const YamlTree>& tree, std::shared_ptr<const Catalog> catalog,
                  const Limits& limits, const Given& given) {
    Reading result{tree, Scene(std::move(catalog)), tree->diagnostics, given.open};
    result.scene.sources = Sources(std::move(source));
    if (!tree->root) return result;
    Inclusion inclusion(result.source(), *tree, given.open, given.known);
    ReadContext context{&result.source(), result.scene.catalog(), limits, result.diagnostics, given.set_params};
    context.inclusion = &inclusion;
    const YamlNode& root = *tree->root;
    if (root.kind != YamlKind::map) {
        context.report(Code::wrong_shape, root.span, "a table is a map of sections", "begin with: pinfield: 1");
        return result;
    }
    read_root(context, result.scene, root);
    result.files = std::move(inclusion).files();
    sort(result.diagnostics);
    return result;
}

Reading read_text(std::shared_ptr<const SourceText> source, std::shared_ptr<const Catalog> catalog, const Limits& limits, const Given& given) {
    const auto tree = std::make_shared<const YamlTree>(read_yaml(*source, limits));
    return read_tree(std::move(source), tree, std::move(catalog), limits, given);
}

}  // namespace

Reading read_table(std::shared_ptr<const SourceText> source, std::shared_ptr<const Catalog> catalog, const Limits& limits, const OpenFile& open) {
    const TableFiles none;
    return read_text(std::move(source), std::move(catalog), limits, {open, none});
}

Reading read_again(const Reading& now, std::string text, const Limits& limits) {
    return read_again(now, std::make_shared<const SourceText>(now.source().name(), std::move(text), now.source().file()), limits);
}

Reading read_again(const Reading& now, const std::shared_ptr<const SourceText>& text, const Limits& limits) {
    return read_text(text, now.scene.shared_catalog(), limits, {now.open, now.files});
}

void know_names_of(const Reading& table, ReadContext& context) {
    if (!table.tree->root || table.tree->root->kind != YamlKind::map) return;
    for (const auto& [path, file] : table.files)
        if (file->tree->root) context.files.push_back({file->source.get(), file->tree->root});
    context.files.push_back({&table.source(), table.tree->root});
    context.names = &context.table_names;
    const std::size_t findings = context.diagnostics.size();
    Scene unused(table.scene.shared_catalog());
    for (const auto phase : {Section::Phase::params, Section::Phase::templates}) read_phase(context, unused, phase);
    context.diagnostics.resize(findings);  // said where the table was read
}

Reading read_with_params(const Reading& now, const std::map<std::string, double>& values, const Limits& limits) {
    return read_tree(now.scene.sources.shared_main(), now.tree, now.scene.shared_catalog(), limits, {now.open, now.files, &values});
}

}  // namespace pinfield

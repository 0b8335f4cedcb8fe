#include "engine/io/fragment.h"

#include <fmt/format.h>

#include "engine/core/at.h"
#include "engine/io/node_reader.h"
#include "engine/io/yaml_items.h"

namespace pinfield {
namespace {

/// "circle: {...}" alone is a node too.
std::string as_list(const std::string& text, const YamlTree& tree) {
    if (!tree.root || tree.root->kind != YamlKind::map) return text;
    return "- " + text.substr(0, tree.root->span.begin) + indented_lines(text.substr(tree.root->span.begin), 2).substr(2);
}

Failure failure_of(const Diagnostics& diagnostics, const SourceText& source) {
    for (const Diagnostic& d : diagnostics) {
        if (d.severity != Severity::error) continue;
        const LineColumn place = source.line_column(d.where.span.begin);
        const std::string hint = d.hint.empty() ? "" : fmt::format(" ({})", d.hint);
        return {fmt::format("line {}, column {}: {}{}", place.line, place.column, d.message, hint)};
    }
    return {"the text holds no node"};
}

}  // namespace

Result<std::vector<Fragment>> read_fragments(const std::string& text, const std::shared_ptr<const Catalog>& catalog) {
    const SourceText as_given("pasted", text);
    const SourceText source("pasted", as_list(text, read_yaml(as_given)));
    const YamlTree tree = read_yaml(source);
    Diagnostics diagnostics = tree.diagnostics;
    if (!tree.root) return tl::unexpected(failure_of(diagnostics, source));
    const Limits limits;
    Scene scene(catalog);
    ReadContext context{source, *catalog, limits, diagnostics};
    read_nodes(context, scene, {}, *tree.root);
    if (has_errors(diagnostics) || scene.roots().empty()) return tl::unexpected(failure_of(diagnostics, source));
    std::vector<Fragment> out;
    for (std::size_t i = 0; i < scene.roots().size(); ++i)
        out.push_back({scene.copy(scene.roots()[i]), item_text(source.text(), *tree.root, i).block});
    return out;
}

}  // namespace pinfield

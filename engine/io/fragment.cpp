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

/// The scalars that are ids of the nodes in a list.
void add_ids(const YamlNode& list, std::vector<const YamlNode*>& out) {
    for (const YamlNode* item : list.items) {
        if (item->kind != YamlKind::map || item->entries() != 1) continue;
        const YamlNode& body = item->value(0);
        for (std::size_t i = 0; i < body.entries(); ++i) {
            if (body.key(i).text == "id" && body.value(i).kind == YamlKind::scalar) out.push_back(&body.value(i));
            if (body.key(i).text == "children") add_ids(body.value(i), out);
        }
    }
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

Result<std::vector<Fragment>> read_fragments(const std::string& text, const Reading& table) {
    const SourceText as_given("pasted", text);
    const SourceText source("pasted", as_list(text, read_yaml(as_given)));
    const YamlTree tree = read_yaml(source);
    Diagnostics diagnostics = tree.diagnostics;
    if (!tree.root) return tl::unexpected(failure_of(diagnostics, source));
    const Limits limits;
    Scene scene(table.scene.shared_catalog());
    ReadContext context{&source, scene.catalog(), limits, diagnostics};
    know_names_of(table, context);
    read_nodes(context, scene, {}, *tree.root);
    if (has_errors(diagnostics) || scene.roots().empty()) return tl::unexpected(failure_of(diagnostics, source));
    std::vector<Fragment> out;
    for (std::size_t i = 0; i < scene.roots().size(); ++i)
        out.push_back({scene.copy(scene.roots()[i]), item_text(source.text(), *tree.root, i).block});
    return out;
}

Result<Fragment> with_ids(const Fragment& fragment, const std::function<std::string(const std::string&)>& new_id, const Reading& table) {
    const SourceText source("pasted", fragment.text);
    const YamlTree tree = read_yaml(source);
    std::vector<const YamlNode*> ids;
    if (tree.root) add_ids(*tree.root, ids);
    std::vector<std::string> names;
    for (const YamlNode* id : ids) names.push_back(new_id(std::string(id->text)));
    std::string text = fragment.text;
    for (std::size_t i = ids.size(); i-- > 0;)
        if (names[i] != ids[i]->text) text.replace(ids[i]->span.begin, ids[i]->span.end - ids[i]->span.begin, names[i]);
    Result<std::vector<Fragment>> again = read_fragments(text, table);
    if (!again) return tl::unexpected(again.error());
    return std::move(again->front());
}

}  // namespace pinfield

#include "engine/io/said_once.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "engine/core/at.h"
#include "engine/expression/expression.h"
#include "engine/io/field_patch.h"
#include "engine/io/quantity.h"
#include "engine/io/rewriting.h"
#include "engine/io/section_patch.h"
#include "engine/scene/validate.h"

namespace pinfield {
namespace {

const Param* find_param(const Scene& scene, const std::string& name) {
    const auto found = std::find_if(scene.params.begin(), scene.params.end(), [&](const Param& param) { return param.name == name; });
    return found == scene.params.end() ? nullptr : &*found;
}

/// Every node with the values it had, bit for bit, in the order it had.
bool same_values(const Scene& a, const Scene& b) {
    const std::vector<NodeId> x = a.all(), y = b.all();
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), [&](NodeId i, NodeId j) {
        const Node &p = *a.find(i), &q = *b.find(j);
        return p.type == q.type && p.children.size() == q.children.size() &&
               std::equal(p.fields.begin(), p.fields.end(), q.fields.begin(), q.fields.end(),
                          [](const FieldSlot& s, const FieldSlot& t) { return identical(s.value, t.value); });
    });
}

/// The rewritten text read again, which must make the nodes of `expected`; they have its ids.
Result<PatchedText> proven(const Reading& now, Rewriting rewriting, const Scene& expected, const Limits& limits) {
    PatchedText out{{}, read_again(now, rewriting.text(), limits), 1};
    for (const Diagnostic& d : out.reading.diagnostics)
        if (d.severity == Severity::error)
            return failure(fmt::format("line {}: {}", out.reading.scene.sources.line_column(d.where).line, d.message));
    if (!same_values(out.reading.scene, expected)) return failure("the table would become another one");
    out.reading.scene.take_ids_of(expected);
    out.patches = std::move(rewriting).patches();
    return out;
}

/// Why nothing may be called so, or nothing.
std::optional<std::string> why_no_name(const Reading& now, const std::string& name) {
    if (!is_name(name)) return fmt::format("{} is no name: small letters, digits and _, not beginning with a digit", name);
    if (is_reserved_name(name)) return fmt::format("{} means something in every expression", name);
    if (free_name_for(now, name) != name) return fmt::format("{} is taken", name);
    return {};
}

// --- a param written out

/// A text's own place of every name of a param in it: scalars that are no keys, and nobody's words.
class Calls {
public:
    Calls(const Reading& now, const Param& param) : now_(now), param_(param) {
        for (const NodeId id : now.scene.all()) {
            const Node& node = *now.scene.find(id);
            for (std::size_t i = 0; i < node.fields.size(); ++i) {
                const FieldKind kind = node.type->fields[i].kind;
                const bool is_number = kind == FieldKind::integer || kind == FieldKind::number || kind == FieldKind::vec2 || kind == FieldKind::points;
                if (!is_number && node.fields[i].where.file == main_file) words_.push_back(node.fields[i].where.span);
            }
        }
    }

    std::vector<Splice> splices() const {
        std::vector<Splice> out;
        for (const YamlNode& node : now_.tree->nodes)
            if (node.kind == YamlKind::scalar && !is_key(node) && !is_word(node.span)) add(node, out);
        std::sort(out.begin(), out.end(), [](const Splice& a, const Splice& b) { return a.replaced.begin < b.replaced.begin; });
        return out;
    }

private:
    static bool is_key(const YamlNode& node) {
        if (!node.parent || node.parent->kind != YamlKind::map) return false;
        const auto& items = node.parent->items;
        return (std::find(items.begin(), items.end(), &node) - items.begin()) % 2 == 0;
    }
    bool is_word(const Span& span) const {
        return std::any_of(words_.begin(), words_.end(), [&](const Span& word) { return word.begin <= span.begin && span.end <= word.end; });
    }

    void add(const YamlNode& scalar, std::vector<Splice>& out) const {
        const auto expression = parse_expression(scalar.text);
        if (!expression) return;
        const bool alone = expression->nodes.size() == 1;
        const auto said = parse_expression(param_.value.text);
        const bool is_plain = said && said->nodes.size() == 1;
        const std::string text = alone || is_plain ? param_.value.text : fmt::format("({})", param_.value.text);
        const std::size_t begin = now_.source().text().find(scalar.text, scalar.span.begin);
        for (const ExpressionNode& node : expression->nodes)
            if (node.operation == Operation::name && expression->slice(node.span) == param_.name)
                out.push_back({{begin + node.span.begin, begin + node.span.end}, text});
    }

    const Reading& now_;
    const Param& param_;
    std::vector<Span> words_;
};

}  // namespace

std::string free_name_for(const Reading& now, const std::string& like) {
    std::set<std::string> taken;
    for (const Param& param : now.scene.params) taken.insert(param.name);
    for (const InputBinding& input : now.scene.inputs) taken.insert(input.name);
    for (const NodeId id : now.scene.all()) taken.insert(now.scene.find(id)->name);
    if (const YamlNode* templates = now.tree->root ? now.tree->root->find("templates") : nullptr)
        for (std::size_t i = 0; i < templates->entries(); ++i) taken.emplace(templates->key(i).text);
    std::string name;
    for (const char c : like) {
        const bool is_capital = c >= 'A' && c <= 'Z', is_plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        name += is_capital ? static_cast<char>(c - 'A' + 'a') : is_plain ? c : '_';
    }
    if (!is_name(name)) name = fmt::format("n{}", name);
    std::string out = name;
    for (int i = 2; taken.contains(out) || is_reserved_name(out) || out == "i"; ++i) out = fmt::format("{}_{}", name, i);
    return out;
}

Result<PatchedText> patch_to_param(const Reading& now, NodeId node, int field, int part, const std::string& name, const Limits& limits) {
    const Node* found = now.scene.find(node);
    if (!found || field < 0 || field >= static_cast<int>(found->fields.size())) return failure("the node has no such field");
    if (const auto why = why_no_name(now, name)) return failure(*why);
    const FieldSlot& slot = at(found->fields, field);
    const FieldType& type = at(found->type->fields, field);
    const YamlNode* value = slot.where.file == main_file ? node_at(*now.tree, slot.where.span) : nullptr;
    if (value && value->kind == YamlKind::sequence && part < static_cast<int>(value->items.size())) value = at(value->items, part);
    if (!value || value->kind != YamlKind::scalar) return failure(fmt::format("{} is not in the text: give it a number first", type.key));
    if (!read_quantity(value->text, type.meta.unit)) return failure(fmt::format("{} is no plain number", value->text));
    if (const YamlNode* shared = shared_above(value)) return tl::unexpected(shared_failure(*shared));
    const std::string number(value->text);
    Rewriting rewriting(now);
    if (const auto written = rewriting.write({{value->span, name}}); !written) return tl::unexpected(written.error());
    if (const auto put = insert_param(rewriting, static_cast<int>(now.scene.params.size()), fmt::format("{}: {}", name, number)); !put)
        return tl::unexpected(put.error());
    return proven(now, std::move(rewriting), now.scene, limits);
}

Result<PatchedText> patch_inlined(const Reading& now, const std::string& name, const Limits& limits) {
    const Param* param = find_param(now.scene, name);
    const YamlNode* section = now.tree->root ? now.tree->root->find("params") : nullptr;
    if (!param || !section || section->entry_of(name) == section->entries()) return failure(fmt::format("no param is called {}", name));
    Rewriting rewriting(now);
    if (const auto written = rewriting.write(Calls(now, *param).splices()); !written) return tl::unexpected(written.error());
    const YamlNode& params = *rewriting.root().find("params");
    if (const auto removed = rewriting.write({remove_entry(rewriting.text(), params, params.entry_of(name))}); !removed)
        return tl::unexpected(removed.error());
    return proven(now, std::move(rewriting), now.scene, limits);
}

Result<PatchedText> patch_to_template(const Reading& now, std::span<const NodeId> nodes, const std::string& name, const Limits& limits) {
    if (const auto why = why_no_name(now, name)) return failure(*why);
    if (nodes.empty()) return failure("there is nothing to make a template of");
    const NodeId parent = now.scene.find(nodes.front()) ? now.scene.find(nodes.front())->parent : NodeId{};
    const int first = now.scene.index_of(nodes.front());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Node* node = now.scene.find(nodes[i]);
        if (!node || node->is_record() || node->origin) return failure("only nodes with lines of their own become a template");
        if (node->parent != parent || now.scene.index_of(node->id) != first + static_cast<int>(i)) return failure("only neighbours become a template");
    }
    if (parent && now.scene.find(parent)->type->key() != "group") return failure("a template is used at the top level or in a group");

    Scene expected = now.scene;
    Node& group = expected.add(*now.scene.catalog().find("group"));
    const NodeId group_id = group.id;
    for (std::size_t i = 0; i < nodes.size(); ++i) expected.put(expected.take(nodes[i]), group_id, static_cast<int>(i));
    expected.put(expected.take(group_id), parent, first);

    Rewriting rewriting(now);
    const Indices where = indices_of(now.scene, parent);
    std::string lines = fmt::format("{}:\n  nodes:", name);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Result<ItemText> item = rewriting.item(where, first + static_cast<int>(i));
        if (!item) return tl::unexpected(item.error());
        lines += fmt::format("\n{}", indented_lines(item->block, 4));
    }
    const std::string use = fmt::format("use: {{template: {}}}", name);
    if (const auto put = rewriting.insert(where, first, {"- " + use, use}); !put) return tl::unexpected(put.error());
    for (std::size_t i = nodes.size(); i-- > 0;)
        if (const auto removed = rewriting.remove(where, first + 1 + static_cast<int>(i)); !removed) return tl::unexpected(removed.error());
    if (const auto put = insert_template(rewriting, rewriting.with_breaks(lines)); !put) return tl::unexpected(put.error());
    return proven(now, std::move(rewriting), expected, limits);
}

}  // namespace pinfield

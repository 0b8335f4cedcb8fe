#include "engine/io/node_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/core/at.h"
#include "engine/io/generators.h"
#include "engine/io/other_words.h"
#include "engine/io/quantity.h"
#include "engine/io/value_reader.h"
#include "engine/scene/part_traits.h"
#include "engine/scene/validate.h"

namespace pinfield {
namespace {

constexpr std::string_view children_key = "children";

std::vector<std::string_view> keys_of(const NodeType& type, bool is_use = false) {
    std::vector<std::string_view> keys;
    if (is_use) keys = {"template", "with", "copies", "pair"};
    for (const FieldType& field : type.fields) keys.push_back(field.key);
    if (type.meta.children.max > 0 && !is_use) keys.push_back(children_key);
    return keys;
}

/// Every word that may begin a scene node.
std::vector<std::string_view> node_words(const Catalog& catalog) {
    std::vector<std::string_view> words;
    for (const NodeType& type : catalog.types())
        if (type.meta.kind != NodeKind::record) words.push_back(type.key());
    return words;
}

const NodeType* find_node_type(const Catalog& catalog, std::string_view key) {
    const NodeType* type = catalog.find(key);
    return type && type->meta.kind != NodeKind::record ? type : nullptr;
}

bool takes(const NodeType& type, std::string_view key) {
    return type.find_field(key) || (type.meta.children.max > 0 && key == children_key);
}

bool repeats_too_often(const ReadContext& context, const FieldType& field, const YamlNode& value) {
    if (field.meta.meaning != Meaning::count || value.kind != YamlKind::scalar) return false;
    const auto count = read_quantity(value.text, Unit::none);
    return count && count->value > static_cast<double>(context.limits.repeats);
}

void read_field(ReadContext& context, Node& node, int index, const YamlNode& key, const YamlNode& value) {
    if (value.kind == YamlKind::null) return report_missing_value(context, key, value);
    const FieldType& field = at(node.type->fields, index);
    if (repeats_too_often(context, field, value))
        return context.report(Code::too_many_repeats, value.span,
                              fmt::format("more than {} copies", context.limits.repeats));
    context.written.clear();
    context.parts_read = 0;
    auto read = read_value(context, field, value);
    if (!read) return;
    // An expression's outcome is known only now.
    if (const auto* count = std::get_if<std::int64_t>(&*read);
        count && field.meta.meaning == Meaning::count && *count > static_cast<std::int64_t>(context.limits.repeats))
        return context.report(Code::too_many_repeats, value.span, fmt::format("more than {} copies", context.limits.repeats));
    FieldSlot& slot = at(node.fields, index);
    slot = {std::move(*read), true, context.source().place(value.span)};
    if (!context.written.empty()) slot.written = std::make_shared<const WrittenParts>(std::exchange(context.written, {}));
}

void read_children(ReadContext& context, Scene& scene, Node& node, const YamlNode& key, const YamlNode* list) {
    const NodeType& type = *node.type;
    if (list) read_nodes(context, scene, node.id, *list);
    if (list && list->kind != YamlKind::sequence && !list->is_empty()) return;  // is reported already
    const auto count = list && list->kind == YamlKind::sequence ? static_cast<int>(list->items.size()) : 0;
    if (auto wrong = wrong_child_count(type, count, context.source().place(key.span))) context.report(std::move(*wrong));
}

/// "-circle" and "radius:30mm" are words of their own to YAML: what was meant, or nothing.
std::string missing_blank(std::string_view text) {
    if (text.size() > 1 && text[0] == '-' && is_name(text.substr(1)))
        return fmt::format("a blank belongs after the dash: - {}", text.substr(1));
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos || colon == 0 || colon + 1 == text.size() || !is_name(text.substr(0, colon))) return {};
    return fmt::format("a blank belongs after the colon: {}: {}", text.substr(0, colon), text.substr(colon + 1));
}

/// A node that is no map of one key: says which of the usual mistakes it is.
void report_no_node(ReadContext& context, const YamlNode& item) {
    if (item.kind == YamlKind::scalar) {
        if (find_node_type(context.catalog, item.text))
            return context.report(Code::wrong_shape, item.span,
                                  fmt::format("{} alone is a text, not a node", item.text),
                                  fmt::format("write {}: {{}}", item.text));
        return context.report(Code::wrong_shape, item.span, "a node is due here, not a single value", missing_blank(item.text));
    }
    if (item.kind != YamlKind::map)
        return context.report(Code::wrong_shape, item.span, "a node is due here",
                              "a node is a map with one key: circle: {radius: 3cm}");
    if (item.entries() == 0) return context.report(Code::not_one_key, item.span, "a node without a type");
    const NodeType* type = find_node_type(context.catalog, item.key(0).text);
    const YamlNode& second = item.key(1);
    if (type && item.value(0).resolved().is_empty() && takes(*type, second.text))
        return context.report(Code::under_indented, second.span,
                              fmt::format("the fields of {} are indented too little", type->key()), "indent two more");
    const bool forgotten_dash = type && find_node_type(context.catalog, second.text);
    context.report(Code::not_one_key, second.span, "a node has exactly one key, its type",
                   forgotten_dash ? "begin the next node with a dash"
                   : type         ? fmt::format("{} belongs inside {}", second.text, type->key())
                                  : "");
}

/// The node that comes when `left` nodes have been counted, or null. Counted before the first is made: they are large.
const YamlNode* first_node_beyond(const YamlNode& list, std::size_t& left) {
    if (list.kind != YamlKind::sequence) return nullptr;
    for (const YamlNode* item : list.items) {
        if (left == 0) return item;
        --left;
        const YamlNode& node = item->resolved();
        if (node.kind != YamlKind::map || node.entries() == 0) continue;
        const YamlNode* children = node.value(0).resolved().find(children_key);
        if (const YamlNode* beyond = children ? first_node_beyond(*children, left) : nullptr) return beyond;
    }
    return nullptr;
}

/// An alias of a key where a node is due: its anchor stands before the first word of what it was to name. Told at the
/// alias, as the anchor alone would be no error, with the line where the author must act.
bool report_alias_of_key(ReadContext& context, const YamlNode& written) {
    if (!written.target || written.target->kind != YamlKind::scalar || !written.target->parent) return false;
    const YamlNode& key = *written.target;
    const std::vector<YamlNode*>& entries = key.parent->items;
    const auto at = std::find(entries.begin(), entries.end(), &key) - entries.begin();
    if (key.parent->kind != YamlKind::map || at % 2 != 0) return false;
    const int line = context.source().line_column(key.span.begin).line;
    context.report(
        Code::wrong_shape, written.span,
        fmt::format("*{} is only the word {}: in line {} its anchor stands before a key", written.text, key.text, line),
        fmt::format("write - &{} {{{}: ...}}, or &{} alone in the line of the dash", written.text, key.text,
                    written.text));
    return true;
}

/// Is a generator where only shapes and operations may stand?
bool report_misplaced_copies(ReadContext& context, const NodeType* parent, const NodeItem& item) {
    if (!parent || (parent->part && parent->part->role == Role::group) || !(item.is_use() || is_repeated(item))) return false;
    context.report(Code::misplaced_copies, item.key.span,
                   fmt::format("{} cannot stand inside {}", item.is_use() ? "use" : "what has copies or a pair", parent->key()),
                   item.is_use() ? "put it directly into the scene or a group" : "repeat, repeat_polar and mirror are for shapes");
    return true;
}

/// The id with what is around it where the node is made.
void take_id(const ReadContext& context, Node& node) {
    const auto field = node.type->find_field("id");
    if (!field) return;
    auto& id = std::get<std::string>(at(node.fields, *field).value);
    if (!id.empty()) id = context.id_prefix + id + context.id_suffix;
    node.name = id;
}

void read_node(ReadContext& context, Scene& scene, NodeId parent, const YamlNode& written) {
    if (report_alias_of_key(context, written)) return;
    const YamlNode& item = written.resolved();
    if (item.kind != YamlKind::map || item.entries() != 1) return report_no_node(context, item);
    const YamlNode& key = item.key(0);
    const YamlNode& body = item.value(0).resolved();
    if (!is_plain_key(key)) return;
    const bool is_use = key.text == "use";
    const NodeType* type = is_use ? context.catalog.find("group") : find_node_type(context.catalog, key.text);
    if (!type) {
        const std::string_view other = other_word_for_node(key.text);
        std::vector<std::string_view> words = node_words(context.catalog);
        words.emplace_back("use");
        return context.report(Code::unknown_node, key.span, fmt::format("no node is called {}", key.text),
                              other.empty() ? suggestion(key.text, words) : std::string(other));
    }
    const NodeType* parent_type = parent ? scene.find(parent)->type : nullptr;
    const NodeItem it{key, body, *type};
    if (report_misplaced_copies(context, parent_type, it)) return;
    if (auto misplaced = misplaced_part(*type, parent_type, context.source().place(key.span))) return context.report(std::move(*misplaced));
    if (is_repeated(it)) read_repeated(context, scene, parent, it);
    else read_single(context, scene, parent, it);
}

void report_unknown_key(ReadContext& context, const Node& node, const YamlNode& key, const YamlNode& field_key) {
    std::string hint = missing_blank(field_key.text);
    if (hint.empty() && !node.is_record()) hint = other_word_for_field(field_key.text);
    const std::vector<std::string_view> keys = keys_of(*node.type, key.text == "use");
    if (hint.empty()) hint = suggestion(field_key.text, keys);
    if (hint.empty()) hint = fmt::format("it has {}", fmt::join(keys, ", "));
    context.report(Code::unknown_key, field_key.span, fmt::format("{} has no {}", key.text, field_key.text), std::move(hint));
}

}  // namespace

void read_fields(ReadContext& context, Node& node, const YamlNode& key, const YamlNode& body,
                 const std::vector<std::string_view>& skipped) {
    const std::size_t errors_before = context.errors_so_far();
    if (body.kind != YamlKind::map && !body.is_empty()) {
        const std::string blank = body.kind == YamlKind::scalar ? missing_blank(body.text) : "";
        return context.report(Code::wrong_shape, body.span, fmt::format("the fields of {} are due here", key.text),
                              blank.empty() ? fmt::format("write {}: {{...}}", key.text) : blank);
    }
    for (std::size_t i = 0; i < body.entries() && !context.full(); ++i) {
        const YamlNode& field_key = body.key(i);
        const YamlNode& value = body.value(i).resolved();
        if (!is_plain_key(field_key)) continue;
        if (i > 0 && value.kind == YamlKind::null && report_comma_split(context, body.value(i - 1))) continue;
        if (const auto index = node.type->find_field(field_key.text))
            read_field(context, node, *index, field_key, value);
        else if (std::find(skipped.begin(), skipped.end(), field_key.text) == skipped.end())
            report_unknown_key(context, node, key, field_key);
    }
    for (const FieldType& field : node.type->fields)
        if (field.meta.required && !body.find(field.key))
            context.report(Code::missing_field, key.span, fmt::format("{} needs {}", key.text, field.key));
    if (context.errors_so_far() != errors_before) return;
    if (auto broken = broken_contract(node)) context.report(std::move(*broken));
}

Node* add_node(ReadContext& context, Scene& scene, NodeId parent, const NodeItem& item, const NodeType& type) {
    if (context.is_exhausted) return nullptr;
    if (context.nodes_made++ == context.limits.nodes) {
        context.report(Code::too_many_nodes, item.key.span, fmt::format("more than {} nodes", context.limits.nodes));
        context.is_exhausted = true;
        return nullptr;
    }
    Node& node = scene.add(type, parent);
    node.key = context.source().place(item.key.span);
    node.where = context.source().place({item.key.span.begin, std::max(item.key.span.end, item.body.span.end)});
    node.origin = context.origin;
    return &node;
}

Node* read_single(ReadContext& context, Scene& scene, NodeId parent, const NodeItem& item) {
    Node* const node = add_node(context, scene, parent, item, item.type);
    if (!node) return nullptr;
    static const std::vector<std::string_view> of_node{children_key, "copies", "pair"}, of_use{"template", "with", "copies", "pair"};
    read_fields(context, *node, item.key, item.body, item.is_use() ? of_use : of_node);
    take_id(context, *node);
    if (item.is_use()) {
        read_template(context, scene, *node, item);
    } else if (item.body.kind == YamlKind::map || item.body.is_empty()) {
        // Ids in a copy are told apart by its own.
        const std::string prefix = context.id_prefix, suffix = std::exchange(context.id_suffix, "");
        if (!suffix.empty() && !node->name.empty()) context.id_prefix = node->name + ".";
        read_children(context, scene, *node, item.key, item.body.find(children_key));
        context.id_prefix = prefix;
        context.id_suffix = suffix;
    }
    return node;
}

void read_record(ReadContext& context, Node& record, const YamlNode& key, const YamlNode& body) {
    record.key = context.source().place(key.span);
    record.where = context.source().place({key.span.begin, std::max(key.span.end, body.span.end)});
    read_fields(context, record, key, body);
}

void read_nodes(ReadContext& context, Scene& scene, NodeId parent, const YamlNode& list) {
    if (list.is_empty()) return;
    if (list.kind != YamlKind::sequence) {
        const bool is_map = list.kind == YamlKind::map && list.entries() > 0;
        const std::string blank = list.kind == YamlKind::scalar ? missing_blank(list.text) : is_map ? missing_blank(list.key(0).text) : "";
        return context.report(Code::wrong_shape, list.span, "a list of nodes is due here",
                              blank.empty() ? "begin each node with a dash" : blank);
    }
    std::size_t left = context.limits.nodes - std::min(context.nodes_made, context.limits.nodes);
    if (const YamlNode* beyond = parent ? nullptr : first_node_beyond(list, left))
        return context.report(Code::too_many_nodes, beyond->span,
                              fmt::format("more than {} nodes", context.limits.nodes));
    if (context.depth == context.limits.depth)
        return context.report(Code::too_deep, list.span, fmt::format("more than {} lists of nodes within each other", context.limits.depth));
    ++context.depth;
    for (const YamlNode* item : list.items) {
        if (context.full()) break;
        read_node(context, scene, parent, *item);
    }
    --context.depth;
}

}  // namespace pinfield

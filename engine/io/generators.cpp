#include "engine/io/generators.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/io/calculate.h"
#include "engine/io/entries.h"
#include "engine/io/value_reader.h"
#include "engine/io/yaml_items.h"

namespace pinfield {
namespace {

/// While it lives, what is read is part of something made; then the context is as it was.
class Making {
public:
    Making(ReadContext& context, const Names* names, std::string what, const YamlNode& asked_by)
        : context_(context),
          names_(std::exchange(context.names, names)),
          prefix_(context.id_prefix),
          suffix_(context.id_suffix),
          origin_(std::exchange(context.origin, std::make_shared<const Origin>(Origin{
                                                    std::move(what), context.source().place(asked_by.span), context.origin}))) {}
    ~Making() {
        context_.names = names_;
        context_.id_prefix = prefix_;
        context_.id_suffix = suffix_;
        context_.origin = origin_;
    }
    Making(const Making&) = delete;
    Making& operator=(const Making&) = delete;

private:
    ReadContext& context_;
    const Names* names_;
    std::string prefix_, suffix_;
    std::shared_ptr<const Origin> origin_;
};

const YamlNode& key_of(const YamlNode& body, std::string_view key) { return body.key(body.entry_of(key)); }

std::string name_of(const NodeItem& item) {
    const YamlNode* id = item.body.find("id");
    return std::string(id && id->kind == YamlKind::scalar ? id->text : item.key.text);
}

FieldSlot& slot_of(Node& node, std::string_view key) { return at(node.fields, *node.type->find_field(key)); }
template <class T>
T& value_of(Node& node, std::string_view key) { return std::get<T>(slot_of(node, key).value); }

// --- copies

/// Where copies stand: each a step from the one before, or turned about a point, or where their own expressions say.
struct Layout {
    int count = 0;
    Vec2 step{0, 0};
    bool turns = false;
    Vec2 around{0, 0};
    double angle = 0;  ///< degrees from each to the next; 0: all of them share a turn
};

std::optional<Layout> read_layout(ReadContext& context, const YamlNode& key, const YamlNode& map) {
    if (map.kind != YamlKind::map)
        return context.report(Code::wrong_shape, map.span, "how many copies is due here", "write copies: {count: 4, step: [5cm, 0]}"), std::nullopt;
    static const std::vector<std::string_view> keys{"count", "step", "around", "angle"};
    const FieldType count = number_field("count", Unit::none, from(0), to(static_cast<double>(context.limits.repeats)), FieldKind::integer);
    const FieldType place = number_field("step", Unit::metre, from(-1e6), to(1e6), FieldKind::vec2);
    const FieldType angle = number_field("angle", Unit::degree, from(-360), to(360));
    Layout out;
    const std::size_t errors = context.errors_so_far();
    read_entries(context, "copies", map, keys, [&](auto index, const YamlNode& value) {
        const auto read = read_value(context, index == 0 ? count : index == 3 ? angle : place, value);
        context.written.clear();
        if (!read) return;
        if (index == 0) out.count = static_cast<int>(std::get<std::int64_t>(*read));
        if (index == 1) out.step = std::get<Vec2>(*read);
        if (index == 2) out = {out.count, out.step, true, std::get<Vec2>(*read), out.angle};
        if (index == 3) out.angle = std::get<double>(*read);
    });
    if (!map.find("count")) context.report(Code::missing_field, key.span, "copies needs count");
    if (map.find("step") && map.find("around"))
        context.report(Code::broken_contract, key_of(map, "around").span, "copies: either step or around must hold");
    if (map.find("angle") && !map.find("around"))
        context.report(Code::missing_field, key_of(map, "angle").span, "copies needs around beside angle: the point to turn about");
    return context.errors_so_far() == errors ? std::optional(out) : std::nullopt;
}

/// Puts copy `i`, from 1, where it belongs: what it says of itself is where the first one is.
void place_copy(Node& node, const Layout& layout, int i) {
    Vec2& place = value_of<Vec2>(node, "at");
    if (!layout.turns) {
        place += layout.step * static_cast<double>(i - 1);
        return;
    }
    const double angle = layout.angle != 0 ? layout.angle * (i - 1) : 360.0 * (i - 1) / layout.count;
    const Similarity turn{cosine_degrees(angle), sine_degrees(angle), 1, false, Vec2(0, 0)};
    place = layout.around + turn * Vec2(place - layout.around);
    value_of<double>(node, "turn") += angle;
}

Node* add_group(ReadContext& context, Scene& scene, NodeId parent, const NodeItem& item) {
    const NodeType& group_type = *context.catalog.find("group");
    Node* group = add_node(context, scene, parent, item, group_type);
    if (!group) return nullptr;
    group->generator = std::make_shared<const Generator>(Generator{line_of(context, item), false});
    const YamlNode* id = item.body.find("id");
    if (!id || id->kind != YamlKind::scalar) return group;
    FieldSlot& slot = slot_of(*group, "id");
    const auto text = resolve_text(context, *id);
    context.written.clear();
    if (!text) return group;  // said again, with its words, when the first copy is read
    group->name = context.id_prefix + *text + context.id_suffix;
    slot = {group->name, true, context.source().place(id->span)};
    return group;
}

Node* read_copies(ReadContext& context, Scene& scene, NodeId parent, const NodeItem& item) {
    const YamlNode* copies = item.body.find("copies");
    if (!copies) return read_single(context, scene, parent, item);
    const YamlNode& key = key_of(item.body, "copies");
    const std::optional<Layout> layout = read_layout(context, key, *copies);
    if (!layout) return nullptr;
    Node* group = add_group(context, scene, parent, item);
    for (int i = 1; group && i <= layout->count && !context.full(); ++i) {
        Names names(context.names);
        names.set("i", {.value = static_cast<double>(i), .measure = {{}, true, false}});
        const Making making(context, &names, fmt::format("copy {} of {}", i, name_of(item)), key);
        context.id_suffix += fmt::format(".{}", i);
        if (Node* copy = read_single(context, scene, group->id, item)) place_copy(*copy, *layout, i);
    }
    return group;
}

// --- pair

/// Is the author's own of the two on the left of the line? Where its place cannot be read, reading the node says why.
bool is_left(ReadContext& context, const NodeItem& item, double line) {
    const YamlNode* place = item.body.find("at");
    if (!place) return 0 < line;
    Names names(context.names);
    names.set("i", {.value = 1, .measure = {{}, true, false}});
    const Making making(context, &names, "a pair", item.key);
    const auto read = read_value(context, at(item.type.fields, *item.type.find_field("at")), *place);
    context.written.clear();
    return !read || std::get<Vec2>(*read).x() <= line;
}

/// The node's reflection in the line x = `line` of its parent's frame: M R(turn) F = R(-turn) M F, and M is a flip of x.
void reflect(Node& node, double line) {
    Vec2& place = value_of<Vec2>(node, "at");
    place.x() = 2 * line - place.x();
    double& turn = value_of<double>(node, "turn");
    if (turn != 0) turn = -turn;
    auto& flip = value_of<std::string>(node, "flip");
    if (flip == "y") turn += 180;  // both axes negated are half a turn
    flip = flip == "none" ? "x" : "none";
}

/// Of two inputs, the left one of a pair listens to the first and the right one to the second.
void share_inputs(Node& node, bool left) {
    for (std::size_t i = 0; i < node.fields.size(); ++i) {
        if (node.type->fields[i].meta.meaning != Meaning::input) continue;
        auto& inputs = std::get<std::vector<std::string>>(node.fields[i].value);
        if (inputs.size() == 2) inputs.erase(left ? inputs.end() - 1 : inputs.begin());
    }
}

void share_inputs(Scene& scene, NodeId node, bool left) {
    share_inputs(*scene.find(node), left);
    if (scene.find(node)->generator && !scene.find(node)->generator->is_group)
        for (const NodeId copy : std::vector(scene.find(node)->children)) share_inputs(*scene.find(copy), left);
}

void read_pair(ReadContext& context, Scene& scene, NodeId parent, const NodeItem& item, const YamlNode& value) {
    const YamlNode& key = key_of(item.body, "pair");
    if (value.kind == YamlKind::null) return report_missing_value(context, key, value);
    const auto line = read_value(context, number_field("pair", Unit::metre, from(-1e6), to(1e6)), value);
    context.written.clear();
    if (!line) return;
    Node* group = add_group(context, scene, parent, item);
    const bool left_first = group && is_left(context, item, std::get<double>(*line));
    for (const bool is_twin : {false, true}) {
        if (!group || context.full()) return;
        const bool left = left_first != is_twin;
        const Making making(context, context.names, fmt::format("the {} one of the pair {}", left ? "left" : "right", name_of(item)), key);
        context.id_suffix += left ? ".left" : ".right";
        Node* node = read_copies(context, scene, group->id, item);
        if (!node) return;
        if (is_twin) reflect(*node, std::get<double>(*line));
        share_inputs(scene, node->id, left);
    }
}

// --- templates

/// What a value stands for: a number where it calculates one, else a text. `like`: what it must be; null: whatever it is.
NamedValue read_argument(ReadContext& context, const YamlNode& node, const NamedValue* like) {
    using Kind = NamedValue::Kind;
    const NamedValue broken{.kind = Kind::broken};
    if (node.kind != YamlKind::scalar) {
        context.report(Code::wrong_shape, node.span, "a number or a text is due here");
        return broken;
    }
    const bool is_dollar = node.text.starts_with('$');
    const auto expression = parse_expression(node.text);
    const bool is_word = expression && expression->nodes.size() == 1 && expression->names.size() == 1 &&
                         !(context.names && context.names->find(node.text));
    const bool is_text = like && like->kind != Kind::broken ? like->kind == Kind::text : is_dollar || !expression || is_word;
    if (is_text) {
        const auto text = resolve_text(context, node);
        context.written.clear();
        return text ? NamedValue{.kind = Kind::text, .text = *text} : broken;
    }
    const auto number = calculate(context, node);
    return number ? NamedValue{.value = number->value, .measure = number->measure} : broken;
}

/// The template's arguments as this use gives them, else as the template has them, of those before them.
void read_arguments(ReadContext& context, const TemplateText& text, std::string_view name, const NodeItem& item, Names& out) {
    const YamlNode* with = item.body.find("with");
    if (with && with->kind != YamlKind::map) {
        context.report(Code::wrong_shape, with->span, "arguments are due here", "write with: {r: 3cm}");
        with = nullptr;
    }
    std::vector<std::string_view> known;
    for (std::size_t i = 0; text.args && i < text.args->entries(); ++i) {
        const YamlNode &key = text.args->key(i), &initial = text.args->value(i).resolved();
        known.push_back(key.text);
        const YamlNode* given = with ? with->find(key.text) : nullptr;
        NamedValue value{.kind = NamedValue::Kind::broken};
        if (!initial.is_empty()) {
            const InText there(context, text.text);
            const Names* const outside = std::exchange(context.names, &out);
            value = read_argument(context, initial, nullptr);
            context.names = outside;
        } else if (!given) {
            context.report(Code::missing_field, item.key.span, fmt::format("{} needs {}", name, key.text), fmt::format("with: {{{}: ...}}", key.text));
        }
        if (given && given->is_empty()) report_missing_value(context, key_of(*with, key.text), *given);
        else if (given) value = read_argument(context, *given, initial.is_empty() ? nullptr : &value);
        out.set(std::string(key.text), std::move(value));
    }
    for (std::size_t i = 0; with && i < with->entries(); ++i)
        if (const YamlNode& key = with->key(i); is_plain_key(key) && std::find(known.begin(), known.end(), key.text) == known.end())
            context.report(Code::unknown_argument, key.span, fmt::format("the template {} has no argument {}", name, key.text),
                           suggestion(key.text, known));
}

TemplateText* find_template(ReadContext& context, const NodeItem& item) {
    const YamlNode* name = item.body.find("template");
    if (!name || name->kind != YamlKind::scalar) {
        context.report(Code::missing_field, name ? name->span : item.key.span, "use needs the name of a template", "write use: {template: gear}");
        return nullptr;
    }
    const auto found = context.templates.find(name->text);
    if (found == context.templates.end()) {
        std::vector<std::string_view> known;
        for (const auto& [key, text] : context.templates) known.push_back(key);
        context.report(Code::unknown_template, name->span, fmt::format("no template is called {}", shortened(name->text)), suggestion(name->text, known));
        return nullptr;
    }
    if (std::find(context.open_templates.begin(), context.open_templates.end(), name->text) != context.open_templates.end()) {
        std::string way;
        for (const std::string_view open : context.open_templates) way += std::string(open) + " -> ";
        context.report(Code::cyclic_template, name->span, fmt::format("a template uses itself: {}{}", way, name->text));
        return nullptr;
    }
    return &found->second;
}

}  // namespace

std::string line_of(const ReadContext& context, const NodeItem& item) {
    return fmt::format("- {}: {}", item.key.text, copy_in_line(context.source().text(), item.body, Aliases::written_out));
}

bool is_repeated(const NodeItem& item) { return item.body.kind == YamlKind::map && (item.body.find("copies") || item.body.find("pair")); }

void read_repeated(ReadContext& context, Scene& scene, NodeId parent, const NodeItem& item) {
    if (const YamlNode* pair = item.body.find("pair")) read_pair(context, scene, parent, item, *pair);
    else read_copies(context, scene, parent, item);
}

void read_template(ReadContext& context, Scene& scene, Node& group, const NodeItem& item) {
    group.generator = std::make_shared<const Generator>(Generator{line_of(context, item), true});
    TemplateText* const text = find_template(context, item);
    if (!text) return;
    text->is_used = true;
    const std::string_view name = text->key->text;
    Names arguments(&context.table_names);
    read_arguments(context, *text, name, item, arguments);
    if (!text->nodes) return context.fail_silently();
    const Making making(context, &arguments, fmt::format("the template {}", name), item.key);
    if (!group.name.empty()) context.id_prefix = group.name + ".";
    context.id_suffix.clear();
    const InText there(context, text->text);
    context.open_templates.push_back(name);
    read_nodes(context, scene, group.id, *text->nodes);
    context.open_templates.pop_back();
}

}  // namespace pinfield

#include "engine/io/value_home.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/core/at.h"
#include "engine/expression/expression.h"
#include "engine/io/entries.h"
#include "engine/io/field_patch.h"
#include "engine/io/home_search.h"
#include "engine/io/param_patch.h"
#include "engine/io/quantity.h"
#include "engine/io/value_writer.h"

namespace pinfield {
namespace {

const FieldType& type_of(const Scene& scene, const SetField& edit) { return at(scene.find(edit.node)->type->fields, edit.field); }
const FieldSlot& slot_of(const Scene& scene, const SetField& edit) { return at(scene.find(edit.node)->fields, edit.field); }

const Param* find_param(const Scene& scene, const std::string& name) {
    const auto found = std::find_if(scene.params.begin(), scene.params.end(), [&](const Param& param) { return param.name == name; });
    return found == scene.params.end() ? nullptr : &*found;
}

/// Where an argument's value stands, or would stand, for the use that made a node.
struct ArgumentPlace {
    const YamlNode* use = nullptr;    ///< the fields of the item
    const YamlNode* with = nullptr;   ///< null: it has none
    const YamlNode* value = nullptr;  ///< what the use says; null: the template's default holds
    const YamlNode* initial = nullptr;  ///< that default; null: there is none
    std::string item;                 ///< what the use is called
};

/// What a template of any of the table's files takes; null: nothing, or there is none.
const YamlNode* arguments_of(const Reading& now, std::string_view name) {
    std::vector<const YamlTree*> trees{now.tree.get()};
    for (const auto& [path, file] : now.files) trees.push_back(file->tree.get());
    for (const YamlTree* tree : trees) {
        const YamlNode* templates = tree->root ? tree->root->find("templates") : nullptr;
        if (const YamlNode* body = templates ? templates->find(name) : nullptr) return body->find("args");
    }
    return nullptr;
}

/// The innermost template that made the node, as an argument's home.
std::optional<ArgumentPlace> argument_place(const Reading& now, const Node& node, const std::string& name) {
    auto origin = node.origin;
    while (origin && !origin->what.starts_with("the template ")) origin = origin->outer;
    const YamlNode* key = origin && origin->where.file == main_file ? node_at(*now.tree, origin->where.span) : nullptr;
    if (!key || !key->parent || key->parent->kind != YamlKind::map) return {};
    ArgumentPlace place;
    place.use = &key->parent->value(0).resolved();
    if (place.use->kind != YamlKind::map) return {};
    const YamlNode *word = place.use->find("template"), *id = place.use->find("id");
    const YamlNode* args = word ? arguments_of(now, word->text) : nullptr;
    if (!args || args->entry_of(name) == args->entries()) return {};
    place.initial = args->find(name);
    place.with = place.use->find("with");
    place.value = place.with ? place.with->find(name) : nullptr;
    place.item = id && id->kind == YamlKind::scalar ? std::string(id->text) : std::string(word->text);
    return place;
}

std::vector<ExpressionName> names_in(std::string_view text) {
    const auto expression = parse_expression(text.starts_with('$') ? text.substr(1) : text);
    return expression ? expression->names : std::vector<ExpressionName>{};
}

/// The params that hands can move and that these names come from, through arguments and calculated params.
class ParamsBehind {
public:
    ParamsBehind(const Reading& now, const Node& node) : now_(now), node_(node) {}

    void add_text(std::string_view text) {
        for (const ExpressionName& name : names_in(text)) add(name.text);
    }
    const std::vector<std::string>& names() const { return names_; }

private:
    void add(const std::string& name) {
        if (!seen_.insert(name).second) return;
        if (const Param* param = find_param(now_.scene, name)) {
            if (param->is_calculated) add_text(param->value.text);
            else if (param->value_where.file == main_file) names_.push_back(name);
            return;
        }
        const auto argument = argument_place(now_, node_, name);
        const YamlNode* said = argument ? (argument->value ? argument->value : argument->initial) : nullptr;
        if (said && said->kind == YamlKind::scalar) add_text(said->text);
    }

    const Reading& now_;
    const Node& node_;
    std::set<std::string> seen_;
    std::vector<std::string> names_;
};

std::string line_told(const Node& node, const FieldSlot& slot) {
    const std::string place = !node.origin ? "here" : fmt::format("in {}", node.origin->what.starts_with("the template ") ? node.origin->what : "the item it is made of");
    return slot.written ? fmt::format("{}, in place of {}", place, slot.written->front().text) : place;
}

/// As a number of this field: where no text says what it is written like, as the neighbours are.
std::string number_text(const Reading& now, const FieldType& field, double x, const YamlNode* like) {
    const FieldType number = number_field(field.key, field.meta.unit, {}, {}, field.kind == FieldKind::integer ? FieldKind::integer : FieldKind::number);
    const Value value = field.kind == FieldKind::integer ? Value(static_cast<std::int64_t>(std::llround(x))) : Value(x);
    if (like && like->kind == YamlKind::scalar && read_quantity(like->text, field.meta.unit)) return write_scalar_like(number, value, *like);
    return write_value(number, value, customary_number(now.scene, nullptr, field.meta.unit));
}

Result<Splice> argument_splice(const Reading& now, const ArgumentPlace& place, const std::string& name, const std::string& text) {
    if (place.value) {
        if (const YamlNode* shared = shared_above(place.value)) return tl::unexpected(shared_failure(*shared));
        return Splice{place.value->span, text};
    }
    const std::string entry = fmt::format("{}: {}", name, text);
    if (const YamlNode* shared = shared_above(place.use)) return tl::unexpected(shared_failure(*shared));
    if (!place.with) return insert_entry(now.source().text(), *place.use, place.use->entries(), fmt::format("with: {{{}}}", entry));
    if (place.with->is_empty()) return insert_body(now.source().text(), *place.with, entry);
    return insert_entry(now.source().text(), *place.with, place.with->entries(), entry);
}

Result<PatchedText> patch_argument(const Reading& now, const SetField& edit, const std::string& name, const Limits& limits) {
    const auto place = argument_place(now, *now.scene.find(edit.node), name);
    if (!place) return failure(fmt::format("{} is no argument of what made it", name));
    const FieldType& field = type_of(now.scene, edit);
    if (const auto* word = std::get_if<std::string>(&edit.value)) {
        const Result<Splice> splice = argument_splice(now, *place, name, write_text(*word));
        if (!splice) return tl::unexpected(splice.error());
        Result<PatchedText> out = read_home(now, *splice, limits);
        if (out && !identical(slot_of(out->reading.scene, edit).value, edit.value)) return failure(fmt::format("{} makes another value of it", name));
        return out;
    }
    const auto reads = [&](const YamlNode* node) { return node && node->kind == YamlKind::scalar && read_quantity(node->text, field.meta.unit); };
    const YamlNode* like = reads(place->value) || !place->initial ? place->value : place->initial;
    const auto with_number = [&](double x) -> Result<PatchedText> {
        const Result<Splice> splice = argument_splice(now, *place, name, number_text(now, field, x, like));
        if (!splice) return tl::unexpected(splice.error());
        return read_home(now, *splice, limits);
    };
    const YamlNode* said = place->value ? place->value : place->initial;
    const std::optional<double> start = reads(said) ? std::optional(read_quantity(said->text, field.meta.unit)->value) : std::nullopt;
    return solve_number(now, edit, start, name, with_number, limits);
}

Result<PatchedText> patch_through_param(const Reading& now, const SetField& edit, const std::string& name, const Limits& limits) {
    const Param* param = find_param(now.scene, name);
    if (!param) return failure(fmt::format("no param is called {}", name));
    return solve_number(now, edit, param->value.value, name, [&](double x) { return patch_param(now, name, x, limits); }, limits);
}

Result<PatchedText> patch_own(const Reading& now, const SetField& edit, const Limits& limits) {
    Result<PatchedText> out = patch_written_out(now, edit.node, limits);
    if (!out) return out;
    const Edit plain = edit;
    Result<PatchedText> set = patch_for(out->reading, std::span(&plain, 1), limits);
    if (!set) return set;
    out->patches.insert(out->patches.end(), std::make_move_iterator(set->patches.begin()), std::make_move_iterator(set->patches.end()));
    out->reading = std::move(set->reading);
    out->readings += set->readings;
    return out;
}

}  // namespace

bool stands_elsewhere(const Scene& scene, const SetField& edit) {
    const Node* node = scene.find(edit.node);
    if (!node || edit.field < 0 || edit.field >= static_cast<int>(node->fields.size())) return false;
    if (node->generator && !node->generator->is_group) return false;  // a row has no values: its copies have
    return node->origin || at(node->fields, edit.field).written;
}

const Node* maker_of(const Scene& scene, NodeId id) {
    const Node* node = scene.find(id);
    while (node && node->origin) node = scene.find(node->parent);
    return node && node->generator ? node : nullptr;
}

std::vector<ValueHome> homes_of(const Reading& now, const SetField& edit) {
    std::vector<ValueHome> out;
    const Scene& scene = now.scene;
    if (!now.tree->root || !stands_elsewhere(scene, edit)) return out;
    const Node& node = *scene.find(edit.node);
    const FieldSlot& slot = slot_of(scene, edit);
    if (node.origin && type_of(scene, edit).meta.meaning == Meaning::id) return out;  // ids are made of those of the makers
    ParamsBehind params(now, node);
    for (const WrittenPart& part : slot.written ? *slot.written : WrittenParts{}) {
        for (const ExpressionName& name : names_in(part.text)) {
            const auto known = [&](const ValueHome& home) { return home.name == name.text; };
            const auto place = argument_place(now, node, name.text);
            if (place && std::none_of(out.begin(), out.end(), known))
                out.push_back({ValueHome::Kind::argument, name.text, fmt::format("{} of this {}", name.text, place->item), 1});
        }
        params.add_text(part.text);
    }
    if (is_number(slot.value))
        for (const std::string& name : params.names()) out.push_back({ValueHome::Kind::param, name, fmt::format("the param {}", name), 1});
    if (node.key.file == main_file) {
        const std::vector<NodeId> all = scene.all();
        const auto same = std::count_if(all.begin(), all.end(), [&](NodeId id) { return is_same_line(scene, edit, *scene.find(id)); });
        out.push_back({ValueHome::Kind::line, {}, line_told(node, slot), static_cast<int>(same)});
    }
    if (const Node* maker = maker_of(scene, edit.node))
        out.push_back({ValueHome::Kind::own, scene.path(maker->id), fmt::format("here only: {} is written out", scene.path(maker->id)), 1});
    return out;
}

Result<PatchedText> patch_home(const Reading& now, const SetField& edit, const ValueHome& home, const Limits& limits) {
    if (!now.tree->root || !stands_elsewhere(now.scene, edit)) return failure("the value stands at the node itself");
    if (const auto why = why_invalid(type_of(now.scene, edit), edit.value))
        return failure(fmt::format("{} {}", type_of(now.scene, edit).key, *why));
    switch (home.kind) {
        case ValueHome::Kind::argument: return patch_argument(now, edit, home.name, limits);
        case ValueHome::Kind::param: return patch_through_param(now, edit, home.name, limits);
        case ValueHome::Kind::own: return patch_own(now, edit, limits);
        case ValueHome::Kind::line: break;
    }
    return patch_line(now, edit, limits);
}

}  // namespace pinfield

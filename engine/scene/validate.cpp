#include "engine/scene/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/core/at.h"
#include "engine/core/closest.h"
#include "engine/core/error_codes.h"
#include "engine/reflect/text_fault.h"
#include "engine/scene/part_traits.h"
#include "engine/sdf/kernels.h"

namespace pinfield {
namespace {

bool holds(const std::vector<std::string_view>& sorted, std::string_view name) {
    return std::binary_search(sorted.begin(), sorted.end(), name);
}

std::string count_allowed(ChildCount allowed) {
    const auto children = [](int n) { return fmt::format("{} {}", n, n == 1 ? "child" : "children"); };
    if (allowed.max == 0) return "no children";
    if (allowed.min == allowed.max) return "exactly " + children(allowed.min);
    if (allowed.max == any_number) return "at least " + children(allowed.min);
    return fmt::format("{} to {} children", allowed.min, allowed.max);
}

/// Where something else is, for a hint at `here`: its line, or, in a scene that no text was read for, its path.
std::string whereabouts(const Scene& scene, const Place& here, const Place& place, NodeId node) {
    if (place) return scene.sources.line_from(here, place);
    return node ? scene.path(node) : "the table";
}

/// A finding about a node that a template or copies made tells the way to it.
Diagnostic through(const Node& node, Diagnostic found) {
    for (auto step = node.origin; step; step = step->outer) found.via.push_back({step->what, step->where});
    return found;
}

void check_ids(const Scene& scene, std::size_t most, Diagnostics& findings) {
    struct Holder {
        NodeId node;  ///< none: an input or a param
        Place where;
    };
    std::map<std::string_view, Holder> taken;
    for (const Param& param : scene.params) taken.emplace(param.name, Holder{{}, param.where});
    for (const InputBinding& input : scene.inputs) {
        const auto [first, is_new] = taken.emplace(input.name, Holder{{}, input.where});
        if (!is_new && !first->second.node && findings.size() <= most)
            findings.push_back(diagnose(Code::duplicate_id, input.where, taken_id(input.name), whereabouts(scene, input.where, first->second.where, {}) + " has it"));
    }
    for (const NodeId id : scene.all()) {
        const Node& node = *scene.find(id);
        if (node.is_record() || node.name.empty()) continue;
        const auto [first, is_new] = taken.emplace(node.name, Holder{id, node.key});
        if (is_new) continue;
        if (findings.size() > most) return;
        const Place& here = at(node.fields, *node.type->find_field("id")).where;
        findings.push_back(through(node, diagnose(Code::duplicate_id, here, taken_id(node.name),
                                                  node.origin ? "give each use an id of its own"
                                                              : whereabouts(scene, here, first->second.where, first->second.node) + " has it")));
    }
}

std::string why_idle(const Node& node, const FieldType& field) {
    const OnlyWith& with = field.meta.only_with;
    if (with.field.empty()) return fmt::format("{} does nothing beside children: they are the shape of the {}", field.key, node.type->key());
    return fmt::format("{} does nothing without {}: {}", field.key, with.field, with.choice);
}

void check_fields(const Scene& scene, std::size_t most, Diagnostics& findings) {
    const KnownNames known(scene);
    for (const NodeId id : scene.all()) {
        const Node& node = *scene.find(id);
        for (std::size_t i = 0; i < node.fields.size(); ++i) {
            if (findings.size() > most) return;
            const FieldType& field = node.type->fields[i];
            if (!node.fields[i].is_explicit) continue;
            if (!node.has_use_for(i)) findings.push_back(through(node, diagnose(Code::idle_field, node.fields[i].where, why_idle(node, field))));
            const std::size_t before = findings.size();
            check_references(known, field, node.fields[i], most, findings);
            for (std::size_t f = before; f < findings.size(); ++f) findings[f] = through(node, std::move(findings[f]));
        }
    }
}

void check_domains(const Scene& scene, std::size_t most, Diagnostics& findings) {
    std::map<std::string, NodeId> domain_of;
    for (const NodeId id : scene.all()) {
        const Node& node = *scene.find(id);
        if (!node.type->part || node.type->part->role != Role::domain) continue;
        for (const std::string& layer : scene.layers(id)) {
            if (findings.size() > most) return;
            const auto [first, is_new] = domain_of.emplace(layer, id);
            if (is_new || first->second == id) continue;  // a layer named twice is still one
            findings.push_back(diagnose(
                Code::second_domain, node.key,
                fmt::format("a second {} on {}", node.type->key(), layer == ground_layer_name ? "the ground layer" : "layer " + layer),
                fmt::format("the first is in {}; one holds several shapes as children",
                            whereabouts(scene, node.key, scene.find(first->second)->key, first->second))));
        }
    }
}

void check_nodes(const Scene& scene, std::size_t most, Diagnostics& findings) {
    const auto take = [&](std::optional<Diagnostic> found) {
        if (found) findings.push_back(std::move(*found));
    };
    for (const NodeId id : scene.all()) {
        if (findings.size() > most) return;
        const Node& node = *scene.find(id);
        take(wrong_child_count(*node.type, static_cast<int>(node.children.size()), node.key));
        take(misplaced_part(*node.type, node.parent ? scene.find(node.parent)->type : nullptr, node.key));
        take(broken_contract(node));
    }
}

bool has_formula(const NodeType& type) { return type.kernels && type.kernels->refusal; }

/// Bytes of a field's text as bytes of the author's; the whole field where the author's text does not hold it letter by letter.
Place place_within(const FieldSlot& slot, const std::string& text, Span span) {
    const std::size_t length = slot.where.span.end - slot.where.span.begin;
    const bool is_quoted = length == text.size() + 2;
    if (slot.written || (length != text.size() && !is_quoted)) return slot.where;
    const std::size_t begin = slot.where.span.begin + (is_quoted ? 1 : 0);
    return {slot.where.file, {begin + span.begin, begin + span.end}};
}

/// What a formula's text breaks, by itself or with the node's other values.
std::optional<Diagnostic> refused_formula(const Node& node, const std::vector<double>& params) {
    if (!has_formula(*node.type)) return {};
    const auto field = std::find_if(node.type->fields.begin(), node.type->fields.end(), [](const FieldType& f) { return f.pack_text != nullptr; });
    const FieldSlot& slot = node.fields[static_cast<std::size_t>(field - node.type->fields.begin())];
    const auto& text = std::get<std::string>(slot.value);
    std::vector<double> read;
    std::optional<TextFault> fault = field->pack_text(text, read);
    if (!fault) fault = node.type->kernels->refusal(params.data(), text);
    if (!fault) return {};
    return diagnose(fault->code, slot.where ? place_within(slot, text, fault->span) : node.key, fault->message, fault->hint);
}

}  // namespace

bool is_name(std::string_view text) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
    return !text.empty() && letter(text[0]) &&
           std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

std::optional<Diagnostic> wrong_child_count(const NodeType& type, int count, const Place& where) {
    const ChildCount allowed = type.meta.children;
    if (count >= allowed.min && count <= allowed.max) return {};
    return diagnose(Code::child_count, where, fmt::format("{} takes {}; it has {}", type.key(), count_allowed(allowed), count));
}

std::optional<Diagnostic> misplaced_part(const NodeType& type, const NodeType* parent, const Place& where) {
    const bool takes_any = !parent || (parent->part && parent->part->role == Role::group);
    if (type.meta.kind != NodeKind::part || takes_any) return {};
    return diagnose(Code::misplaced_part, where, fmt::format("{} cannot stand inside {}", type.key(), parent->key()),
                    "only shapes and operations may; put it directly into the scene or a group");
}

std::optional<Diagnostic> broken_contract(const Node& node) {
    const NodeType& type = *node.type;
    if (type.contracts.empty() && !has_formula(type)) return {};
    std::vector<Value> own;
    own.reserve(static_cast<std::size_t>(type.own_fields));
    for (int i = 0; i < type.own_fields; ++i) own.push_back(at(node.fields, i).value);
    // A contract may read what derive() fills in, so the block has room for it.
    const std::vector<double> params = pack(type, own, type.kernels ? type.kernels->derived_count : 0);
    const auto sentence = broken_contract(type, params.data());
    if (!sentence) return refused_formula(node, params);
    const bool is_material = type.meta.kind == NodeKind::record && !node.name.empty();
    return diagnose(Code::broken_contract, node.key,
                    fmt::format("{}: {} must hold", is_material ? std::string_view(node.name) : type.key(), *sentence));
}

KnownNames::KnownNames(const Scene& scene) {
    for (const NodeId id : scene.materials()) materials.push_back(scene.find(id)->name);
    for (const InputBinding& input : scene.inputs) inputs.push_back(input.name);
    std::sort(materials.begin(), materials.end());
    std::sort(inputs.begin(), inputs.end());
}

void check_references(const KnownNames& known, const FieldType& field, const FieldSlot& slot, std::size_t most, Diagnostics& findings) {
    if (field.meta.meaning == Meaning::material) {
        const auto& name = std::get<std::string>(slot.value);
        if (name.empty() || name == "default" || holds(known.materials, name)) return;
        findings.push_back(
            diagnose(Code::unknown_material, slot.where, fmt::format("no material is called {}", name), suggestion(name, known.materials)));
    }
    if (field.meta.meaning == Meaning::input)
        for (const std::string& name : std::get<std::vector<std::string>>(slot.value))
            if (findings.size() <= most && !holds(known.inputs, name))
                findings.push_back(
                    diagnose(Code::unknown_input, slot.where, fmt::format("no input is called {}", name), suggestion(name, known.inputs)));
}

std::string taken_id(std::string_view id) { return fmt::format("the id {} is taken", id); }

bool is_id_taken(const Scene& scene, std::string_view id, NodeId node) {
    const bool is_input =
        std::any_of(scene.inputs.begin(), scene.inputs.end(), [&](const InputBinding& input) { return input.name == id; });
    if (is_input || std::any_of(scene.params.begin(), scene.params.end(), [&](const Param& param) { return param.name == id; })) return true;
    const std::vector<NodeId> all = scene.all();
    return std::any_of(all.begin(), all.end(), [&](NodeId other) {
        const Node& holder = *scene.find(other);
        return other != node && !holder.is_record() && holder.name == id;
    });
}

Diagnostics check_relations(const Scene& scene, std::size_t most) {
    Diagnostics findings;
    check_ids(scene, most, findings);
    check_fields(scene, most, findings);
    check_domains(scene, most, findings);
    return findings;
}

Diagnostics validate(const Scene& scene, std::size_t most) {
    Diagnostics findings;
    check_nodes(scene, most, findings);
    const Diagnostics relations = check_relations(scene, most);
    findings.insert(findings.end(), relations.begin(), relations.end());
    return findings;
}

}  // namespace pinfield

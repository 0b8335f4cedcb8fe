// What only the whole scene can tell.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/core/at.h"
#include "engine/io/node_reader.h"
#include "engine/scene/part_traits.h"

namespace pinfield {
namespace {

void check_ids(ReadContext& context, const Scene& scene) {
    std::map<std::string_view, Span> taken;  // one namespace for nodes and inputs
    for (const InputBinding& input : scene.inputs) taken.emplace(input.name, input.where);
    for (const NodeId id : scene.all()) {
        const Node& node = *scene.find(id);
        if (node.type->meta.kind == NodeKind::record || node.name.empty()) continue;
        const auto [first, is_new] = taken.emplace(node.name, node.key);
        if (is_new) continue;
        if (context.full()) return;
        const auto field = node.type->find_field("id");
        context.report(Code::duplicate_id, at(node.fields, *field).where,
                       fmt::format("the id {} is taken", node.name),
                       fmt::format("line {} has it", context.source.place(first->second.begin).line));
    }
}

/// Sorted: for looking up, and for suggesting from.
using Names = std::vector<std::string_view>;

bool holds(const Names& names, std::string_view name) { return std::binary_search(names.begin(), names.end(), name); }

void check_material(ReadContext& context, const Names& materials, const FieldSlot& slot) {
    const auto& name = std::get<std::string>(slot.value);
    if (name.empty() || name == "default" || holds(materials, name)) return;
    context.report(Code::unknown_material, slot.where, fmt::format("no material is called {}", name),
                   suggestion(name, materials));
}

void check_inputs(ReadContext& context, const Names& inputs, const FieldSlot& slot) {
    for (const std::string& name : std::get<std::vector<std::string>>(slot.value))
        if (!context.full() && !holds(inputs, name))
            context.report(Code::unknown_input, slot.where, fmt::format("no input is called {}", name),
                           suggestion(name, inputs));
}

/// What fields refer to, and whether they are of use.
void check_fields(ReadContext& context, const Scene& scene) {
    Names materials, inputs;
    for (const NodeId id : scene.materials()) materials.push_back(scene.find(id)->name);
    for (const InputBinding& input : scene.inputs) inputs.push_back(input.name);
    std::sort(materials.begin(), materials.end());
    std::sort(inputs.begin(), inputs.end());
    for (const NodeId id : scene.all()) {
        if (context.full()) return;
        const Node& node = *scene.find(id);
        for (std::size_t i = 0; i < node.fields.size(); ++i) {
            const FieldType& field = node.type->fields[i];
            if (!node.fields[i].is_explicit) continue;
            if (!node.has_use_for(i))
                context.report(
                    Code::idle_field, node.fields[i].where,
                    fmt::format("{} does nothing without {}: {}", field.key, field.meta.only_with.field, field.meta.only_with.choice));
            if (field.meta.meaning == Meaning::material) check_material(context, materials, node.fields[i]);
            if (field.meta.meaning == Meaning::input) check_inputs(context, inputs, node.fields[i]);
        }
    }
}

void check_domains(ReadContext& context, const Scene& scene) {
    std::map<std::string, Span> domain_of;
    for (const NodeId id : scene.all()) {
        if (context.full()) return;
        const Node& node = *scene.find(id);
        if (!node.type->part || node.type->part->role != Role::boundary) continue;
        auto layers = node.get<std::vector<std::string>>("layer");
        if (layers.empty()) layers.emplace_back();
        for (const std::string& layer : layers) {
            const auto [first, is_new] = domain_of.emplace(layer, node.key);
            if (!is_new && first->second != node.key)  // a layer named twice is still one
                context.report(Code::second_domain, node.key,
                               fmt::format("a second {} on {}", node.type->key(),
                                           layer.empty() ? "the ground layer" : "layer " + layer),
                               fmt::format("the first is in line {}; one holds several shapes as children",
                                           context.source.place(first->second.begin).line));
        }
    }
}

}  // namespace

void check_scene(ReadContext& context, const Scene& scene) {
    check_ids(context, scene);
    check_fields(context, scene);
    check_domains(context, scene);
}

}  // namespace pinfield

#include "engine/scene/elsewhere.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/scene/edit.h"

namespace pinfield {
namespace {

int count_included(const Scene& scene, const std::vector<NodeId>& nodes) {
    return static_cast<int>(std::count_if(nodes.begin(), nodes.end(), [&](NodeId id) { return is_included(scene.find(id)->key); }));
}

bool says(const FieldType& field, const FieldSlot& slot, const std::string& name, Meaning sort) {
    return field.meta.meaning == sort && !identical(renamed(slot.value, name, ""), slot.value);
}

}  // namespace

int included_children(const Scene& scene, NodeId parent) { return parent ? 0 : count_included(scene, scene.roots()); }
int included_materials(const Scene& scene) { return count_included(scene, scene.materials()); }
int included_inputs(const Scene& scene) {
    const auto& inputs = scene.inputs;
    return static_cast<int>(std::count_if(inputs.begin(), inputs.end(), [](const InputBinding& input) { return is_included(input.where); }));
}

std::string line_in_table(const Scene& scene, const Place& place) { return scene.sources.line_from({main_file, {}}, place); }

std::optional<std::string> why_elsewhere(const Scene& scene, std::string_view name, const Place& place) {
    if (!is_included(place)) return {};
    return fmt::format("{} stands in {}: change it there", name, line_in_table(scene, place));
}

std::optional<std::string> why_before_included(int index, int included) {
    if (index >= included) return {};
    return "what the table includes comes before what it has itself";
}

std::optional<std::string> why_named_elsewhere(const Scene& scene, const std::string& name, Meaning sort) {
    for (const NodeId id : scene.all()) {
        const Node& node = *scene.find(id);
        for (std::size_t i = 0; i < node.fields.size(); ++i)
            if (is_included(node.fields[i].where) && says(node.type->fields[i], node.fields[i], name, sort))
                return fmt::format("{} is called so in {}, too: change both there", name, line_in_table(scene, node.fields[i].where));
    }
    return {};
}

}  // namespace pinfield

#include "engine/scene/edit.h"

#include <fmt/format.h>

#include <cassert>

#include "engine/sdf/kernels.h"

namespace pinfield {
namespace {

bool is_id_field(const FieldType& field) { return field.common && field.kind == FieldKind::id && field.key == "id"; }

}  // namespace

std::optional<std::string> refuse(const Scene& scene, const Edit& edit) {
    const Node* node = scene.find(edit.node);
    if (!node) return "the node no longer exists";
    if (edit.field < 0 || edit.field >= static_cast<int>(node->fields.size())) return "the node has no such field";
    const FieldType& field = node->type->fields[static_cast<std::size_t>(edit.field)];
    if (auto why = refuse(field, edit.value)) return fmt::format("{} {}", field.key, *why);
    if (is_id_field(field)) {
        const auto& id = std::get<std::string>(edit.value);
        const Node* holder = id.empty() ? nullptr : scene.find(id);
        if (holder && holder->id != edit.node) return fmt::format("the id {} is taken", id);
    }
    std::vector<Value> own;
    for (int i = 0; i < node->type->own_fields; ++i)
        own.push_back(i == edit.field ? edit.value : node->fields[static_cast<std::size_t>(i)].value);
    const std::vector<double> params = pack(*node->type, own);
    if (const auto sentence = broken_contract(*node->type, params.data()))
        return fmt::format("{} must hold", *sentence);
    return {};
}

Edit apply(Scene& scene, const Edit& edit) {
    assert(!refuse(scene, edit) && "apply() takes edits that refuse() lets pass");
    Node& node = *scene.find(edit.node);
    FieldSlot& slot = node.fields[static_cast<std::size_t>(edit.field)];
    Edit inverse{edit.node, edit.field, std::move(slot.value), slot.given};
    slot.value = edit.value;
    slot.given = edit.given;
    if (is_id_field(node.type->fields[static_cast<std::size_t>(edit.field)])) node.name = std::get<std::string>(edit.value);
    return inverse;
}

}  // namespace pinfield

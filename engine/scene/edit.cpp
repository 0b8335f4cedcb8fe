#include "engine/scene/edit.h"

#include <fmt/format.h>

#include <cassert>

#include "engine/core/at.h"
#include "engine/sdf/kernels.h"

namespace pinfield {
namespace {

bool is_id_field(const FieldType& field) { return field.common && field.meta.meaning == Meaning::id; }

/// A contract may read what derive() fills in, so the block has room for it.
std::optional<std::string_view> contract_broken_by(const Node& node, int field, const Value& value) {
    const NodeType& type = *node.type;
    std::vector<Value> own;
    for (int i = 0; i < type.own_fields; ++i) own.push_back(i == field ? value : at(node.fields, i).value);
    const std::vector<double> params = pack(type, own, type.kernels ? type.kernels->derived_count : 0);
    return broken_contract(type, params.data());
}

}  // namespace

std::optional<std::string_view> broken_contract(const Node& node) {
    return contract_broken_by(node, -1, {});
}

std::optional<std::string> why_invalid(const Scene& scene, const Edit& edit) {
    const Node* node = scene.find(edit.node);
    if (!node) return "the node no longer exists";
    if (edit.field < 0 || edit.field >= static_cast<int>(node->fields.size())) return "the node has no such field";
    const FieldType& field = at(node->type->fields, edit.field);
    if (auto why = why_invalid(field, edit.value)) return fmt::format("{} {}", field.key, *why);
    if (is_id_field(field)) {
        const auto& id = std::get<std::string>(edit.value);
        const Node* holder = id.empty() ? nullptr : scene.find(id);
        if (holder && holder->id != edit.node) return fmt::format("the id {} is taken", id);
    }
    if (const auto sentence = contract_broken_by(*node, edit.field, edit.value))
        return fmt::format("{} must hold", *sentence);
    return {};
}

Edit apply(Scene& scene, const Edit& edit) {
    assert(!why_invalid(scene, edit) && "apply() takes edits that why_invalid() lets pass");
    Node& node = *scene.find(edit.node);
    FieldSlot& slot = at(node.fields, edit.field);
    Edit inverse{edit.node, edit.field, std::move(slot.value), slot.is_explicit};
    slot.value = edit.value;
    slot.is_explicit = edit.is_explicit;
    if (is_id_field(at(node.type->fields, edit.field))) node.name = std::get<std::string>(edit.value);
    return inverse;
}

}  // namespace pinfield

#include "engine/scene/edit.h"

#include <fmt/format.h>

#include <cassert>

#include "engine/core/at.h"
#include "engine/scene/validate.h"

namespace pinfield {
namespace {

bool is_id_field(const FieldType& field) { return field.common && field.meta.meaning == Meaning::id; }

}  // namespace

std::optional<std::string> why_invalid(const Scene& scene, const Edit& edit) {
    const Node* node = scene.find(edit.node);
    if (!node) return "the node no longer exists";
    if (edit.field < 0 || edit.field >= static_cast<int>(node->fields.size())) return "the node has no such field";
    const FieldType& field = at(node->type->fields, edit.field);
    if (auto why = why_invalid(field, edit.value)) return fmt::format("{} {}", field.key, *why);
    if (is_id_field(field)) {
        const auto& id = std::get<std::string>(edit.value);
        if (!id.empty() && is_id_taken(scene, id, edit.node)) return taken_id(id);
    }
    Node changed = *node;
    at(changed.fields, edit.field).value = edit.value;
    Diagnostics findings;
    check_references(KnownNames(scene), field, at(changed.fields, edit.field), 1, findings);
    if (auto broken = broken_contract(changed)) findings.push_back(std::move(*broken));
    if (!findings.empty()) return findings.front().message;
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

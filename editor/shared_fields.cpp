#include "editor/shared_fields.h"

#include <fmt/format.h>

#include <algorithm>

#include "editor/edit_tools.h"
#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

const FieldSlot& slot_of(const Scene& scene, const FieldOf& f) { return at(scene.find(f.node)->fields, f.field); }

bool is_own_id(const FieldType& field) { return field.common && field.meta.meaning == Meaning::id; }

bool are_alike(const FieldType& a, const FieldType& b) {
    return a.key == b.key && a.kind == b.kind && a.meta.unit == b.meta.unit && a.meta.meaning == b.meta.meaning && a.choices == b.choices;
}

/// Whether the field does something in this node, or the file says it all the same.
bool is_of_use(const Node& node, int field) { return node.has_use_for(static_cast<std::size_t>(field)) || at(node.fields, field).is_explicit; }

std::optional<FieldOf> alike_in(const Node& node, const FieldType& field) {
    const std::optional<int> found = node.type->find_field(field.key);
    if (!found || !are_alike(at(node.type->fields, *found), field) || !is_of_use(node, *found)) return {};
    return FieldOf{node.id, *found};
}

/// Previews what `value_of` gives for each field, and commits it all.
template <class ValueOf>
std::optional<std::string> write_all(Document& document, std::span<const FieldOf> fields, bool is_explicit, ValueOf value_of) {
    const std::string label = change_label(document.scene(), fields);
    for (const FieldOf& f : fields) {
        const std::optional<Value> value = value_of(f);
        if (!value) continue;
        if (auto why = document.preview({f.node, f.field, *value, is_explicit})) {
            document.cancel_preview();
            return fields.size() == 1 ? *why : fmt::format("{}: {}", document.scene().path(f.node), *why);
        }
    }
    return document.commit(label);
}

}  // namespace

std::vector<SharedField> shared_fields(const Scene& scene, NodeId shown, std::span<const NodeId> nodes) {
    std::vector<SharedField> out;
    const Node& first = *scene.find(shown);
    for (int i = 0; i < static_cast<int>(first.fields.size()); ++i) {
        const FieldType& field = at(first.type->fields, i);
        if (!is_of_use(first, i) || (nodes.size() > 1 && is_own_id(field))) continue;
        SharedField shared{{shown, i}};
        bool by_all = true;
        for (const NodeId id : nodes) {
            const Node* node = scene.find(id);
            if (!node || id == shown) continue;
            const std::optional<FieldOf> same = alike_in(*node, field);
            if (same) shared.push_back(*same);
            by_all = by_all && same;
        }
        if (by_all) out.push_back(std::move(shared));
    }
    return out;
}

bool is_mixed(const Scene& scene, std::span<const FieldOf> fields, int component) {
    const Value& first = slot_of(scene, fields.front()).value;
    return std::any_of(fields.begin() + 1, fields.end(), [&](const FieldOf& f) {
        const Value& value = slot_of(scene, f).value;
        if (component < 0) return !identical(value, first);
        return component < component_count(value) &&
               !identical(editor::component(value, component), editor::component(first, component));
    });
}

bool any_explicit(const Scene& scene, std::span<const FieldOf> fields) {
    return std::any_of(fields.begin(), fields.end(), [&](const FieldOf& f) { return slot_of(scene, f).is_explicit; });
}

std::optional<std::string> change_all(Document& document, std::span<const FieldOf> fields, const ValueChange& change) {
    return write_all(document, fields, true, [&](const FieldOf& f) { return change(slot_of(document.scene(), f).value); });
}

std::optional<std::string> set_all(Document& document, std::span<const FieldOf> fields, const Value& value, bool is_explicit) {
    return write_all(document, fields, is_explicit, [&](const FieldOf&) { return std::optional(value); });
}

std::optional<std::string> set_component_of_all(Document& document, std::span<const FieldOf> fields, int component, double x) {
    return change_all(document, fields, [&](const Value& before) {
        return component < component_count(before) ? std::optional(with_component(before, component, x)) : std::nullopt;
    });
}

std::optional<std::string> set_all_from_text(Document& document, std::span<const FieldOf> fields, std::string_view text) {
    const Node* first = document.scene().find(fields.front().node);
    if (!first) return "the node no longer exists";
    const Result<Value> value = value_of(at(first->type->fields, fields.front().field), text);
    if (!value) return value.error().message;
    return set_all(document, fields, *value);
}

std::optional<std::string> reset_all(Document& document, std::span<const FieldOf> fields) {
    return write_all(document, fields, false, [&](const FieldOf& f) {
        return std::optional(at(document.scene().find(f.node)->type->fields, f.field).initial);
    });
}

std::string change_label(const Scene& scene, std::span<const FieldOf> fields) {
    const FieldOf& first = fields.front();
    if (fields.size() == 1) return change_label(scene, first.node, first.field);
    return fmt::format("Change {} of {} nodes", at(scene.find(first.node)->type->fields, first.field).key, fields.size());
}

std::vector<NodeId> users_of(const Scene& scene, Meaning meaning, const std::string& name) {
    std::vector<NodeId> out;
    for (const NodeId id : scene.all()) {
        const Node& node = *scene.find(id);
        for (std::size_t i = 0; i < node.fields.size(); ++i) {
            if (node.type->fields[i].meta.meaning != meaning) continue;
            const Value& value = node.fields[i].value;
            const auto* names = std::get_if<std::vector<std::string>>(&value);
            const bool named = names ? std::find(names->begin(), names->end(), name) != names->end() : identical(value, Value(name));
            if (named && (out.empty() || out.back() != id)) out.push_back(id);
        }
    }
    return out;
}

}  // namespace pinfield::editor

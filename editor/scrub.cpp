#include "editor/scrub.h"

#include <cmath>
#include <utility>

#include "editor/edit_tools.h"
#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

constexpr double pixels_per_integer = 8;

}  // namespace

bool Scrub::begin(const Document& document, std::span<const FieldOf> fields, int component_index) {
    if (active() || component_index < 0) return false;
    for (const FieldOf& f : fields) {
        const Node* node = document.scene().find(f.node);
        if (node && component_index < component_count(at(node->fields, f.field).value)) held_.push_back({f, at(node->fields, f.field).value});
    }
    component_ = component_index;
    return active();
}

void Scrub::update(Document& document, double pixels, bool fine, bool coarse) {
    const Node* shown = active() ? document.scene().find(node()) : nullptr;
    if (!shown) return;
    const FieldType& field = at(shown->type->fields, held_.front().of.field);
    const bool integer = field.kind == FieldKind::integer;
    const double step = scrub_step(field, component(held_.front().before, component_)) * (coarse ? 10 : fine && !integer ? 0.1 : 1);
    const double steps = std::round(pixels / (integer ? pixels_per_integer : 1));
    if (steps == 0 && !document.previewing()) return;
    for (const Held& held : held_) {
        if (!document.scene().find(held.of.node)) continue;
        const double from = component(held.before, component_), target = steps == 0 ? from : on_grid(from + steps * step, step);
        SetField edit{held.of.node, held.of.field, held.before, true};
        const auto allowed = [&](double x) {
            edit.value = with_component(held.before, component_, x);
            return !document.why_not(edit);
        };
        edit.value = with_component(held.before, component_, nearest_allowed(allowed, from, target, step));
        document.preview(edit);
    }
}

std::optional<std::string> Scrub::end(Document& document) {
    SharedField there;
    for (const Held& held : std::exchange(held_, {}))
        if (document.scene().find(held.of.node)) there.push_back(held.of);
    return there.empty() ? std::nullopt : document.commit(change_label(document.scene(), there));
}

void Scrub::cancel(Document& document) {
    if (active()) document.cancel_preview();
    held_.clear();
}

}  // namespace pinfield::editor

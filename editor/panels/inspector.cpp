#include <algorithm>
#include <optional>

#include "editor/panels/fields.h"
#include "editor/panels/ui.h"
#include "editor/widgets/widgets.h"
#include "engine/program/program.h"

namespace pinfield::editor {

namespace {

/// What a node was compiled to in a field, or nothing. A solid whose boundary is known as pieces is exact whatever its tree is.
std::optional<Exactness> exactness_in(const Field& field, NodeId node) {
    for (const Solid& solid : field.solids)
        if (solid.lowered && field.ops[static_cast<std::size_t>(solid.root)].origin == node) return Exactness{};
    for (auto op = field.ops.rbegin(); op != field.ops.rend(); ++op)
        if (op->origin == node) return op->exactness;
    return std::nullopt;
}

/// Exactness of a node: of what it was compiled to, which knows its children and values, else of its type.
Exactness exactness_of(const AppState& state, const Node& node) {
    const Program& program = state.session.program();
    if (const auto found = exactness_in(program.fixed, node.id)) return *found;
    for (const Mover& mover : program.movers)
        if (const auto found = exactness_in(mover.field, node.id)) return *found;
    return node.type->meta.exactness;
}

void exactness_badge(const AppState& state, const Theme& theme, const Node& node) {
    if (node.type->meta.kind != NodeKind::shape && node.type->meta.kind != NodeKind::operation) return;
    const Exactness e = exactness_of(state, node);
    const bool outside = e.outside == Side::exact, inside = e.inside == Side::exact;
    const char* word = outside && inside ? "exact" : outside ? "exact outside" : inside ? "exact inside" : "bound";
    ImGui::Dummy({0, theme.px(1)});
    pill(theme, word, outside && inside ? palette::accent : palette::amber);
    std::string text = "What this node's distance may be trusted for.\nOutside: ";
    text += outside ? "the true distance." : "never more than the true distance.";
    text += "\nInside: ";
    text += inside ? "the true depth." : "never more than the true depth.";
    tooltip(theme, text);
}

void header(const AppState& state, const Theme& theme, const Node& node) {
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float icon = theme.px(18);
    draw_icon(*ImGui::GetWindowDrawList(), icon_of(*node.type), {place.x + 0.5f * icon, place.y + 0.5f * theme.large->FontSize}, icon,
              ink(color_of(*node.type)));
    ImGui::SetCursorScreenPos({place.x + icon + theme.px(9), place.y});
    ImGui::PushFont(theme.large);
    const std::string title = fitted(title_of(node), ImGui::GetContentRegionAvail().x);
    ImGui::PopFont();
    text_in(theme.large, palette::text, title);
    std::string line(node.type->key());
    if (!node.name.empty()) {
        text_in(theme.small, palette::quiet, line);
        ImGui::SameLine(0, theme.px(6));
        text_in(theme.small, palette::faint, "\u00b7");
        ImGui::SameLine(0, theme.px(6));
    }
    if (node.where.end > 0)
        text_in(theme.small, palette::quiet, "line " + std::to_string(state.document.source().place(node.where.begin).line));
    else text_in(theme.small, palette::quiet, "not in the file yet");
    ImGui::PushTextWrapPos(0);
    text_in(theme.body, palette::quiet, node.type->meta.doc);
    ImGui::PopTextWrapPos();
    exactness_badge(state, theme, node);
}

void field_rows(AppState& state, Ui& ui, const Node& node, bool common) {
    for (std::size_t i = 0; i < node.type->fields.size(); ++i)
        if (node.type->fields[i].common == common) field_row(state, ui, node, static_cast<int>(i));
}

void contracts(const Theme& theme, const NodeType& type) {
    if (type.contracts.empty()) return;
    ImGui::Dummy({0, theme.px(2)});
    for (const ContractType& contract : type.contracts)
        text_in(theme.small, palette::quiet, "Must hold: " + std::string(contract.sentence));
}

void nothing_selected(const Theme& theme) {
    text_in(theme.strong, palette::text, "Nothing selected");
    ImGui::PushTextWrapPos(0);
    text_in(theme.body, palette::quiet, "Click something on the table, or a row of the tree. Drag a number here to change it while the balls roll.");
    ImGui::PopTextWrapPos();
}

}  // namespace

void inspector_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    begin_region("##inspector", position, size, palette::panel, {theme.px(14), theme.px(12)}, ImGuiWindowFlags_None);
    ImGui::BeginChild("##fields", {0, 0}, false, ImGuiWindowFlags_NoNav);
    const Node* found = state.document.scene().find(state.selection);
    if (!found) {
        nothing_selected(theme);
    } else {
        // A field's edit may replace the whole tree (an id changed, the file reloaded): rows look at a copy.
        const Node node = *found;
        ImGui::PushID(static_cast<int>(node.id.value));
        header(state, theme, node);
        const auto& fields = node.type->fields;
        const bool own = std::any_of(fields.begin(), fields.end(), [](const FieldType& f) { return !f.common; });
        const bool common = std::any_of(fields.begin(), fields.end(), [](const FieldType& f) { return f.common; });
        if (own) {
            section(theme, "Properties");
            field_rows(state, ui, node, false);
            contracts(theme, *node.type);
        }
        if (common) {
            section(theme, "Place");
            field_rows(state, ui, node, true);
        }
        ImGui::PopID();
    }
    ImGui::EndChild();
    ImGui::End();
}

}  // namespace pinfield::editor

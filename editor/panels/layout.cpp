#include <algorithm>

#include "editor/panels/ui.h"
#include "editor/widgets/widgets.h"

namespace pinfield::editor {

Icon icon_of(const NodeType& type) {
    switch (type.meta.kind) {
        case NodeKind::shape: return Icon::shape;
        case NodeKind::operation: return Icon::operation;
        case NodeKind::part: return type.meta.children.max > 0 && type.own_fields == 0 ? Icon::group : Icon::part;
        default: break;
    }
    if (type.key() == "table") return Icon::table;
    return type.key() == "physics" ? Icon::physics : Icon::material;
}

Tint color_of(const NodeType& type) {
    switch (type.meta.kind) {
        case NodeKind::shape: return palette::accent;
        case NodeKind::operation: return palette::amber;
        case NodeKind::part: return palette::teal;
        default: return palette::quiet;
    }
}

std::string title_of(const Node& node) { return node.name.empty() ? std::string(node.type->key()) : node.name; }

Problems problems_of(const AppState& state) {
    Problems problems{state.document.diagnostics(), {}};
    // The compiler would only repeat what the reader has said.
    if (!has_errors(problems.in_file)) problems.in_program = state.session.problems();
    return problems;
}

void draw_panels(AppState& state, Ui& ui) {
    const Theme& theme = ui.theme;
    // New problems open their panel once; closing it again is the user's.
    const std::size_t problems = problems_of(state).count();
    if (problems > ui.problems_seen) ui.problems_open = true;
    if (problems == 0) ui.problems_open = ui.problems_open && ui.problems_seen == 0;
    ui.problems_seen = problems;

    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float top = menu_bar(state, ui);
    const float status = theme.px(28), transport = theme.px(50), grip = std::max(theme.px(3), 2.0f);
    const float widest = 0.4f * window.x / theme.scale;
    const float left = theme.px(std::min(ui.left, widest)), right = theme.px(std::min(ui.right, widest));
    const float bottom = ui.problems_open ? theme.px(std::min(ui.bottom, 0.5f * window.y / theme.scale)) : 0;
    const float height = window.y - top - status;
    const float middle_x = left + grip, middle_width = std::max(window.x - left - right - 2 * grip, 40.0f);
    const float view_height = std::max(height - transport - bottom - (bottom > 0 ? grip : 0), 40.0f);

    viewport_panel(state, ui, {middle_x, top}, {middle_width, view_height});
    transport_bar(state, ui, {middle_x, top + view_height}, {middle_width, transport});
    if (bottom > 0) {
        const float y = top + view_height + transport;
        splitter("##split_bottom", {middle_x, y}, {middle_width, grip}, false, -1, theme.scale, ui.bottom, 70, 500);
        problems_panel(state, ui, {middle_x, y + grip}, {middle_width, bottom});
    }
    const float palette_height = state.show_palette ? theme.px(std::min(ui.palette_height, 0.6f * height / theme.scale)) : 0;
    const float tree_height = height - palette_height - (palette_height > 0 ? grip : 0);
    hierarchy_panel(state, ui, {0, top}, {left, tree_height});
    if (palette_height > 0) {
        splitter("##split_palette", {0, top + tree_height}, {left, grip}, false, -1, theme.scale, ui.palette_height, 120, 0.6f * height / theme.scale);
        palette_panel(state, ui, {0, top + tree_height + grip}, {left, palette_height});
    }
    splitter("##split_left", {left, top}, {grip, height}, true, 1, theme.scale, ui.left, 160, widest);
    inspector_panel(state, ui, {window.x - right, top}, {right, height});
    splitter("##split_right", {window.x - right - grip, top}, {grip, height}, true, -1, theme.scale, ui.right, 240, widest);
    status_bar(state, ui, {0, window.y - status}, {window.x, status});

    carry_from_palette(state, ui);
    path_dialog(state, ui);
    starter_dialog(state, ui);
    prompt_dialog(state, ui);
    recovery_dialog(state, ui);
    shortcut_sheet(state, ui);
}

}  // namespace pinfield::editor

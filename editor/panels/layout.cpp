#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "editor/panels/ui.h"
#include "editor/widgets/widgets.h"
#include "engine/core/numbers.h"

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

std::string size_in_words(const Box2& box) {
    if (box.is_empty() || !box.is_finite()) return {};
    const auto tenths = [](double metres) { return to_text(std::round(10'000 * metres) / 10 + 0.0); };
    return fmt::format("{} \u00d7 {} mm", tenths(box.size().x()), tenths(box.size().y()));
}

std::string place_in_words(const Box2& box) {
    if (box.is_empty() || !box.is_finite()) return {};
    const Vec2 at = 1000 * box.centre();
    return fmt::format("at {}, {}", to_text(at.x(), 0), to_text(at.y(), 0));
}

Problems problems_of(const AppState& state) {
    Problems problems{state.source.problems(), state.document.diagnostics(), {}};
    // The compiler would only repeat what the reader has said.
    if (!has_errors(problems.in_file)) problems.in_program = state.session.problems();
    return problems;
}

namespace {

constexpr float least_tree = 160;   // design pixels
constexpr float least_upper = 240;  // likewise: some rows of what stands above another panel

/// Widths in screen pixels; 0: not shown.
struct Columns {
    float left = 0, right = 0, source = 0;
    float widest = 0;  ///< that a panel at the side may be drawn, in design pixels
};

/// The table keeps a quarter of the window. Where that leaves no room for the source too, this takes the inspector's place, as both show
/// what is selected; the tree grows narrower, and goes only where it could not be read.
Columns columns_in(float width, const Preferences& preferences, const Theme& theme) {
    Columns columns;
    columns.widest = 0.4f * width / theme.scale;
    columns.left = theme.px(std::min(preferences.left, columns.widest));
    columns.right = theme.px(std::min(preferences.right, columns.widest));
    if (!preferences.show_source) return columns;
    const float room = std::floor(width - std::max(width / 4, theme.px(240)));
    const float wanted = std::min(theme.px(preferences.source_width), room), least = std::min(theme.px(280), room);
    if (columns.left + columns.right + least > room) columns.right = 0;
    if (columns.left + columns.right + least > room) columns.left = room - least >= theme.px(least_tree) ? room - least : 0;
    columns.source = std::min(wanted, room - columns.left - columns.right);
    return columns;
}

/// The table, what makes it run, and under it what is wrong.
void middle_column(AppState& state, Ui& ui, ImVec2 position, ImVec2 size, float grip) {
    const Theme& theme = ui.theme;
    const float transport = theme.px(50);
    const float bottom =
        ui.problems_open ? theme.px(std::min(state.preferences.problems_height, 0.5f * ImGui::GetIO().DisplaySize.y / theme.scale)) : 0;
    const float view_height = std::max(size.y - transport - bottom - (bottom > 0 ? grip : 0), 40.0f);
    viewport_panel(state, ui, position, {size.x, view_height});
    transport_bar(state, ui, {position.x, position.y + view_height}, {size.x, transport});
    if (bottom <= 0) return;
    const float y = position.y + view_height + transport;
    splitter("##split_bottom", {position.x, y}, {size.x, grip}, false, -1, theme.scale, state.preferences.problems_height, 70, 500);
    problems_panel(state, ui, {position.x, y + grip}, {size.x, bottom});
}

using Panel = void (*)(AppState&, Ui&, ImVec2, ImVec2);

/// A panel that may stand under another.
struct LowerPanel {
    Panel draw;
    const char* grip;
    float& design_height;
    float least;  ///< design pixels
    bool shown;
};

void column(AppState& state, Ui& ui, ImVec2 position, ImVec2 size, float grip, Panel upper, const LowerPanel& lower) {
    const Theme& theme = ui.theme;
    const float whole = size.y / theme.scale, most = std::clamp(whole - least_upper, 0.35f * whole, 0.6f * whole);
    const float height = lower.shown ? theme.px(std::min(lower.design_height, most)) : 0;
    const float rest = size.y - height - (height > 0 ? grip : 0);
    upper(state, ui, position, {size.x, rest});
    if (height <= 0) return;
    splitter(lower.grip, {position.x, position.y + rest}, {size.x, grip}, false, -1, theme.scale, lower.design_height, lower.least, most);
    lower.draw(state, ui, {position.x, position.y + rest + grip}, {size.x, height});
}

/// The tree, and under it what can be added.
void left_column(AppState& state, Ui& ui, ImVec2 position, ImVec2 size, float grip) {
    column(state, ui, position, size, grip, hierarchy_panel,
           {palette_panel, "##split_palette", state.preferences.palette_height, 120, state.preferences.show_palette});
}

/// What is selected, and under it what was done.
void right_column(AppState& state, Ui& ui, ImVec2 position, ImVec2 size, float grip) {
    column(state, ui, position, size, grip, inspector_panel,
           {history_panel, "##split_history", state.preferences.history_height, 80, state.preferences.show_history});
}

/// Nobody types where nothing is seen.
void leave_source(AppState& state, Ui& ui) {
    ui.source.focused = false;
    ui.source.wanted.reset();
    state.source.read(state.document);
}

void dialogs(AppState& state, Ui& ui) {
    path_dialog(state, ui);
    starter_dialog(state, ui);
    prompt_dialog(state, ui);
    recovery_dialog(state, ui);
    merge_dialog(state, ui);
    shared_dialog(state, ui);
    home_dialog(state, ui);
    lists_dialog(state, ui);
    shortcut_sheet(state, ui);
    preferences_dialog(state, ui);
    command_palette(state, ui);
}

}  // namespace

void draw_panels(AppState& state, Ui& ui) {
    const Theme& theme = ui.theme;
    // New problems open their panel once; closing it again is the user's. Half a word typed in the source does not: it stands there.
    const std::size_t problems = problems_of(state).of_table();
    if (problems > ui.problems_seen) ui.problems_open = true;
    if (problems == 0) ui.problems_open = ui.problems_open && ui.problems_seen == 0;
    ui.problems_seen = problems;

    const ImVec2 window = ImGui::GetIO().DisplaySize;
    if (!state.show_panels) {
        viewport_panel(state, ui, {0, 0}, window);
        leave_source(state, ui);
        return dialogs(state, ui);
    }
    const float top = menu_bar(state, ui);
    const float status = theme.px(28), grip = std::max(theme.px(3), 2.0f);
    const Columns columns = columns_in(window.x - 3 * grip, state.preferences, theme);
    const float left = columns.left, right = columns.right, source = columns.source;
    const float height = window.y - top - status;
    const float middle_x = left + (left > 0 ? grip : 0), end_x = window.x - right - (right > 0 ? grip : 0);
    const float source_x = end_x - source, middle_end = source_x - (source > 0 ? grip : 0),
                middle_width = std::max(middle_end - middle_x, 40.0f);

    middle_column(state, ui, {middle_x, top}, {middle_width, height}, grip);
    const float widest = columns.widest;
    if (left > 0) {
        left_column(state, ui, {0, top}, {left, height}, grip);
        splitter("##split_left", {left, top}, {grip, height}, true, 1, theme.scale, state.preferences.left, least_tree, widest);
    }
    if (right > 0) {
        right_column(state, ui, {window.x - right, top}, {right, height}, grip);
        splitter("##split_right", {end_x, top}, {grip, height}, true, -1, theme.scale, state.preferences.right, 240, widest);
    }
    if (source > 0) {  // after the tree: what is under the mouse there has its lines marked here
        source_panel(state, ui, {source_x, top}, {source, height});
        splitter("##split_source", {middle_end, top}, {grip, height}, true, -1, theme.scale, state.preferences.source_width, 240,
                 2 * widest);
    } else {
        leave_source(state, ui);
    }
    status_bar(state, ui, {0, window.y - status}, {window.x, status});

    carry_from_palette(state, ui);
    dialogs(state, ui);
}

}  // namespace pinfield::editor

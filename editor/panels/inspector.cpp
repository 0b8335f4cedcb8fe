#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "editor/panels/fields.h"
#include "editor/panels/ui.h"
#include "editor/shared_fields.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"
#include "engine/core/numbers.h"
#include "engine/core/shown.h"
#include "engine/program/distance_quality.h"
#include "engine/scene/elsewhere.h"

namespace pinfield::editor {

namespace {

/// What the node was compiled to, which knows its children and values; else, while it does not compile, what its type promises.
std::optional<DistanceQuality> quality_shown(const AppState& state, const Node& node) {
    if (const auto found = distance_quality_of(state.session.program(), node.id)) return found;
    if (!node.type->kernels) return std::nullopt;
    return DistanceQuality{node.type->meta.exactness, false};
}

/// Puts the next badge beside the last one, or below it where the panel is too narrow.
void next_badge(const Theme& theme, std::string_view text) {
    const float gap = theme.px(5), right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + gap + pill_width(theme, text) <= right) ImGui::SameLine(0, gap);
}

/// Words and filled or bare pills tell the sides apart, not color alone.
void side_badge(const Theme& theme, const std::string& where, Side side) {
    const bool exact = side == Side::exact;
    pill(theme, (exact ? "exact " : "bound ") + where, exact ? palette::accent : palette::amber,
         exact ? PillStyle::filled : PillStyle::bare);
    tooltip(theme, exact ? "The distance shown and used " + where + " is the true one."
                         : "The distance shown and used " + where + " may fall short of the true one but never exceeds it: safe for balls, "
                           "while an offset of it would be misplaced.");
}

void exactness_badges(const AppState& state, const Theme& theme, const Node& node) {
    const std::optional<DistanceQuality> quality = quality_shown(state, node);
    if (!quality) return;
    const Exactness e = quality->exactness();
    ImGui::Dummy({0, theme.px(1)});
    if (quality->fit_error > 0) {
        const std::string within = "right to " + to_text(std::ceil(1e9 * quality->fit_error), 0) + " nm";
        pill(theme, within, palette::accent, PillStyle::bare);
        tooltip(theme, "The distance used is not exact, but off by at most that many millionths of a millimetre, on both sides.");
    } else if (e.outside == e.inside) {
        side_badge(theme, "on both sides", e.outside);
    } else {
        side_badge(theme, "outside", e.outside);
        next_badge(theme, "bound inside");
        side_badge(theme, "inside", e.inside);
    }
    if (quality->boundary_known) {
        const char* word = quality->fit_error > 0 ? "boundary fitted" : "boundary known";
        next_badge(theme, word);
        pill(theme, word, palette::quiet, PillStyle::filled);
        tooltip(theme, quality->fit_error > 0
                           ? "The boundary of this node was fitted with arcs when the table was compiled and is what the ball meets: its "
                             "distance is right on both sides, but for the error shown."
                           : "The boundary of this node was found when the table was compiled and is what the ball meets, so that its "
                             "distance is exact on both sides.");
    }
    const std::string slope = "L = " + to_text(e.lipschitz, e.lipschitz == 1 ? 0 : 2);
    next_badge(theme, slope);
    pill(theme, slope, palette::quiet, PillStyle::bare);
    tooltip(theme, "The Lipschitz constant: a millimetre of way changes the distance by at most this many millimetres.");
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
    if (node.where)
        text_in(theme.small, palette::quiet, pinfield::shown(line_in_table(state.document.scene(), node.where)));
    else text_in(theme.small, palette::quiet, "not in the file yet");
    if (node.origin) {
        const std::string made = fmt::format("made by {}, asked for in line {}", node.origin->what,
                                             state.document.scene().sources.line_column(node.origin->where).line);
        text_in(theme.small, palette::quiet, fitted(made, ImGui::GetContentRegionAvail().x));
        tooltip(theme, "What is changed here is changed where it comes from: the editor asks where. Edit > Write out gives it lines of its own.");
    }
    ImGui::PushTextWrapPos(0);
    text_in(theme.body, palette::quiet, node.type->meta.doc);
    ImGui::PopTextWrapPos();
    exactness_badges(state, theme, node);
}

void field_rows(AppState& state, Ui& ui, const Node& node, std::span<const SharedField> fields, bool common) {
    for (const SharedField& field : fields)
        if (at(node.type->fields, field.front().field).common == common) field_row(state, ui, node, field);
}

void contracts(const Theme& theme, const NodeType& type) {
    if (type.contracts.empty()) return;
    ImGui::Dummy({0, theme.px(2)});
    ImGui::PushTextWrapPos(0);
    for (const ContractType& contract : type.contracts)
        text_in(theme.small, palette::quiet, "Must hold: " + std::string(contract.sentence));
    ImGui::PopTextWrapPos();
}

void nothing_selected(const Theme& theme) {
    text_in(theme.strong, palette::text, "Nothing selected");
    ImGui::PushTextWrapPos(0);
    text_in(theme.body, palette::quiet,
            "Click something on the table, or a row of the tree. Drag a number here to change it while the balls roll.");
    ImGui::PopTextWrapPos();
}

/// "2 circles, bumper": the kinds of several nodes, in the order of the first of each.
std::string kinds_of(const Scene& scene, std::span<const NodeId> nodes) {
    std::vector<std::pair<std::string_view, int>> counts;
    for (const NodeId id : nodes) {
        const std::string_view key = scene.find(id)->type->key();
        const auto there = std::find_if(counts.begin(), counts.end(), [&](const auto& count) { return count.first == key; });
        if (there == counts.end()) counts.emplace_back(key, 1);
        else ++there->second;
    }
    std::string text;
    for (const auto& [key, count] : counts) {
        text += text.empty() ? "" : ", ";
        text += count == 1 ? std::string(key) : std::to_string(count) + " \u00d7 " + std::string(key);
    }
    return text;
}

void header_of_many(const AppState& state, const Theme& theme, std::span<const NodeId> nodes) {
    text_in(theme.large, palette::text, std::to_string(nodes.size()) + " nodes");
    ImGui::PushTextWrapPos(0);
    text_in(theme.small, palette::quiet, kinds_of(state.document.scene(), nodes));
    text_in(theme.body, palette::quiet, "What they have in common. A number that is typed goes to all of them, one that is dragged changes each by as much.");
    ImGui::PopTextWrapPos();
}

/// The nodes that have this material, to click.
void users(AppState& state, const Ui& ui, const Node& material) {
    const Theme& theme = ui.theme;
    const std::vector<NodeId> nodes = users_of(state.document.scene(), Meaning::material, material.name);
    section(theme, "Used by");
    if (nodes.empty()) text_in(theme.body, palette::quiet, "Nothing yet");
    std::optional<NodeId> clicked;
    for (const NodeId id : nodes) {
        ImGui::PushID(static_cast<int>(id.value));
        if (ImGui::Selectable(state.document.scene().path(id).c_str())) clicked = id;
        ImGui::PopID();
    }
    if (nodes.size() > 1 && small_button(theme, "Select all of them", "Selects every node that names this material.")) select(state, nodes);
    else if (clicked) select(state, *clicked);
}

bool is_material(const Scene& scene, NodeId node) {
    const std::vector<NodeId>& materials = scene.materials();
    return std::find(materials.begin(), materials.end(), node) != materials.end();
}

/// The selected nodes that there are; the one that panels show comes last.
std::vector<NodeId> shown_nodes(const AppState& state) {
    std::vector<NodeId> nodes;
    for (const NodeId id : state.selection.nodes())
        if (state.document.scene().find(id)) nodes.push_back(id);
    return nodes;
}

/// A field's edit may replace the whole tree (an id changed, the file reloaded): rows look at a copy of the node.
void properties(AppState& state, Ui& ui, const Node& node, std::span<const NodeId> nodes) {
    const Theme& theme = ui.theme;
    const std::vector<SharedField> fields = shared_fields(state.document.scene(), node.id, nodes);
    const auto is_common = [&](const SharedField& f) { return at(node.type->fields, f.front().field).common; };
    if (!std::all_of(fields.begin(), fields.end(), is_common)) {
        section(theme, "Properties");
        field_rows(state, ui, node, fields, false);
        if (nodes.size() == 1) contracts(theme, *node.type);
    }
    if (std::any_of(fields.begin(), fields.end(), is_common)) {
        section(theme, "Place");
        field_rows(state, ui, node, fields, true);
    }
}

/// Tab has been pressed: what it comes to is typed from the next frame on.
void go_on_typing(AppState& state, Ui& ui) {
    ui.types_at.reset();
    const auto from = std::exchange(ui.tabbed_from, std::nullopt);
    const std::vector<TabStop> stops = std::exchange(ui.tab_stops, {});
    const bool first = std::exchange(state.type_value, false);
    if (stops.empty() || asks(state)) return;
    if (first) ui.types_at = stops.front();
    const auto there = from ? std::find(stops.begin(), stops.end(), *from) : stops.end();
    if (there == stops.end()) return;
    const std::size_t count = stops.size(), index = static_cast<std::size_t>(there - stops.begin());
    ui.types_at = stops[(index + (ui.tabs_back ? count - 1 : 1)) % count];
}

}  // namespace

void inspector_panel(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    begin_region("##inspector", position, size, palette::panel, {theme.px(14), theme.px(12)}, ImGuiWindowFlags_None);
    ImGui::BeginChild("##fields", {0, 0}, false, ImGuiWindowFlags_NoNav);
    const std::vector<NodeId> nodes = shown_nodes(state);
    if (nodes.empty()) {
        nothing_selected(theme);
    } else {
        const Node node = *state.document.scene().find(nodes.back());
        ImGui::PushID(static_cast<int>(node.id.value));
        if (nodes.size() == 1) header(state, theme, node);
        else header_of_many(state, theme, nodes);
        properties(state, ui, node, nodes);
        if (nodes.size() == 1 && is_material(state.document.scene(), node.id)) users(state, ui, node);
        ImGui::PopID();
    }
    param_rows(state, ui);
    go_on_typing(state, ui);
    ImGui::EndChild();
    ImGui::End();
}

}  // namespace pinfield::editor

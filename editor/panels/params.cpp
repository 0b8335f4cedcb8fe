// The table's params as sliders: the running table follows while one is dragged, and the text changes when it is let go.
#include <fmt/format.h>

#include "editor/panels/fields.h"
#include "editor/panels/ui.h"
#include "editor/param_value.h"
#include "editor/widgets/widgets.h"
#include "engine/io/quantity.h"
#include "engine/scene/elsewhere.h"

namespace pinfield::editor {
namespace {

/// The value with its name before and its unit behind, on a bar as full as it is of its range.
void draw_slider(const Theme& theme, const Param& param, bool fixed, ImVec2 place, ImVec2 size, const Tint& background) {
    const Shown text = shown(param.value.value, unit_of(param.dimension));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{place.x + size.x, place.y + size.y};
    const float round = ImGui::GetStyle().FrameRounding, pad = theme.px(8);
    list.AddRectFilled(place, end, ink(background), round);
    if (const auto share = share_of(param, param.value.value)) {
        const float at = place.x + static_cast<float>(*share) * size.x;
        list.PushClipRect(place, {at, end.y}, true);
        list.AddRectFilled(place, end, ink(palette::accent.faded(0.16f)), round);
        list.PopClipRect();
        list.AddRectFilled({at - theme.px(1), place.y + theme.px(3)}, {at + theme.px(1), end.y - theme.px(3)}, ink(palette::accent), theme.px(1));
    }
    const float y = place.y + 0.5f * (size.y - ImGui::GetFontSize());
    const std::string number = text.unit.empty() ? text.number : text.number + " " + text.unit;
    list.AddText({place.x + pad, y}, ink(fixed ? palette::quiet : palette::text), number.c_str());
}

/// The value where the mouse has dragged the slider to.
double dragged(const Theme& theme, const Param& param, double before, float left, float width) {
    const ImGuiIO& io = ImGui::GetIO();
    if (param.min && param.max) return value_at(param, (io.MousePos.x - left) / width);
    return stepped(param, before, ImGui::GetMouseDragDelta(0, 0).x / theme.scale);
}

void slide(AppState& state, Ui& ui, const Param& param, ImVec2 place, float width) {
    Document& document = state.document;
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActivated()) ui.param_before = param.value.value;
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 2)) {
        const double value = dragged(ui.theme, param, ui.param_before, place.x, width);
        if (value != param.value.value)
            if (const auto why = document.preview_param(param.name, value)) say(state, *why, true);
    }
    if (ImGui::IsItemDeactivated() && document.previewing()) {
        const auto why = document.commit("Change " + param.name);
        say(state, why.value_or("Change " + param.name), why.has_value());
    }
}

/// Why no hand moves it, or nothing.
std::optional<std::string> why_fixed(const Scene& scene, const Param& param) {
    if (param.is_calculated) return fmt::format("Follows {}: change it in the text.", param.value.text);
    return why_elsewhere(scene, param.name, param.where);
}

void param_row(AppState& state, Ui& ui, const Param& param) {
    const Theme& theme = ui.theme;
    const std::optional<std::string> fixed = why_fixed(state.document.scene(), param);
    const float label = theme.px(104), width = ImGui::GetContentRegionAvail().x - label;
    const ImVec2 left = ImGui::GetCursorScreenPos();
    ImGui::AlignTextToFramePadding();
    text_in(theme.body, palette::quiet, fitted(param.label.empty() ? param.name : param.label, label - theme.px(8)));
    tooltip(theme, fmt::format("{}: {}", param.name, param.value.text));
    if (ImGui::BeginPopupContextItem("param menu")) {
        if (ImGui::MenuItem("Write it out wherever it is called")) write_out_param(state, param.name);
        ImGui::EndPopup();
    }
    const ImVec2 place{left.x + label, left.y}, size{width, ImGui::GetFrameHeight()};
    ImGui::SetCursorScreenPos(place);
    ImGui::InvisibleButton("slider", size);
    const bool hot = ImGui::IsItemHovered() && !fixed, held = ImGui::IsItemActive() && !fixed;
    draw_slider(theme, param, fixed.has_value(), place, size, held ? palette::field_active : hot ? palette::field_hot : palette::field);
    if (fixed) tooltip(theme, *fixed);
    else slide(state, ui, param, place, width);
}

}  // namespace

void param_rows(AppState& state, Ui& ui) {
    const std::vector<Param> params = state.document.scene().params;  // a slider in motion makes another scene
    if (params.empty()) return;
    section(ui.theme, "Params");
    for (const Param& param : params) {
        ImGui::PushID(param.name.c_str());
        param_row(state, ui, param);
        ImGui::PopID();
    }
}

}  // namespace pinfield::editor

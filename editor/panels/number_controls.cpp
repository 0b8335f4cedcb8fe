#include <algorithm>
#include <cmath>

#include "editor/edit_tools.h"
#include "editor/panels/field_row.h"
#include "editor/panels/fields.h"
#include "editor/widgets/widgets.h"

namespace pinfield::editor {
namespace {

/// How full a number's bar is, where the field has both ends of a range.
float share_of_range(const FieldMeta& meta, double value) {
    const double lo = meta.min.value, hi = meta.max.value;
    if (!std::isfinite(lo) || !std::isfinite(hi) || hi - lo > 1000) return 0;
    return static_cast<float>(std::clamp((value - lo) / (hi - lo), 0.0, 1.0));
}

/// Drags the number under the mouse, or begins to type it.
void scrub_number(const Row& row, int component, bool hot, bool held) {
    Scrub& scrub = row.ui.scrub;
    Document& document = row.state.document;
    if (hot || held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (hot && ImGui::IsMouseDoubleClicked(0)) {
        scrub.cancel(document);
        begin_typing(row, component);
    } else if (held && !scrub.active() && ImGui::IsMouseDragging(0, 2)) {
        scrub.begin(document, row.all, component);
    }
    if (held && scrub.active()) {
        const ImGuiIO& io = ImGui::GetIO();
        const double pixels = ImGui::GetMouseDragDelta(0, 0).x / row.theme().scale;
        scrub.update(document, pixels, io.KeyShift, io.KeyCtrl);
    }
    if (ImGui::IsItemDeactivated() && scrub.active()) tell(row.state, scrub.end(document));
}

/// The number with its name before and its unit behind, on a bar as full as the value is of its range.
void draw_number(const Row& row, int component, ImVec2 place, ImVec2 size, const Tint& background, const char* name) {
    const Theme& theme = row.theme();
    const double value = editor::component(row.value(), component);
    const bool mixed = row.mixed(component);
    const Shown text = mixed ? Shown{mixed_word, ""} : shown(value, row.field().meta.unit);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{place.x + size.x, place.y + size.y};
    const float round = ImGui::GetStyle().FrameRounding, pad = theme.px(8);
    list.AddRectFilled(place, end, ink(background), round);
    const float share = mixed ? 0 : share_of_range(row.field().meta, value);
    if (share > 0) {
        list.PushClipRect(place, {place.x + share * size.x, end.y}, true);
        list.AddRectFilled(place, end, ink(palette::accent.faded(0.16f)), round);
        list.PopClipRect();
    }
    const float y = place.y + 0.5f * (size.y - ImGui::GetFontSize());
    float x = place.x + pad;
    if (*name) {
        list.AddText({x, y}, ink(palette::faint), name);
        x += theme.px(16);
    }
    const float unit_width = theme.small->CalcTextSizeA(theme.small->FontSize, 1e9f, 0, text.unit.c_str()).x;
    const std::string number = fitted(text.number, end.x - pad - unit_width - theme.px(4) - x);
    list.AddText({x, y}, ink(mixed ? palette::quiet : palette::text), number.c_str());
    list.AddText(theme.small, theme.small->FontSize, {end.x - pad - unit_width, place.y + 0.5f * (size.y - theme.small->FontSize)},
                 ink(palette::quiet), text.unit.c_str());
}

/// A point more: half way to the next, behind the last as far on as half the way to it.
std::vector<Vec2> with_point_behind(std::vector<Vec2> points, std::size_t i) {
    const bool last = i + 1 == points.size();
    const Vec2 there = points[i], beyond = !last ? points[i + 1] : i > 0 ? Vec2(2 * there - points[i - 1]) : Vec2(there + Vec2(0.02, 0));
    const Vec2 between = 0.5 * (there + beyond);
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(i) + 1, Vec2(on_grid(between.x(), 0), on_grid(between.y(), 0)));
    return points;
}

}  // namespace

void number_control(const Row& row, int component, float width, const char* name) {
    ImGui::PushID(component);
    tab_stop(row, component);
    if (row.ui.typing.is(row.node.id, row.index(), component)) {
        typing_field(row, width);
    } else {
        const ImVec2 place = ImGui::GetCursorScreenPos(), size{width, ImGui::GetFrameHeight()};
        ImGui::InvisibleButton("scrub", size);
        const bool hot = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
        scrub_number(row, component, hot, held);
        draw_number(row, component, place, size, held ? palette::field_active : hot ? palette::field_hot : palette::field, name);
    }
    ImGui::PopID();
}

void vec2_control(const Row& row, int first) {
    const float gap = row.theme().px(6), half = 0.5f * (row.width - gap);
    number_control(row, first, std::floor(half), "x");
    ImGui::SameLine(0, gap);
    number_control(row, first + 1, std::floor(half), "y");
}

void points_control(const Row& row) {
    const auto points = std::get<std::vector<Vec2>>(row.value());
    const bool alone = row.all.size() == 1;
    std::optional<std::vector<Vec2>> changed;
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < points.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::BeginGroup();
        vec2_control(row, 2 * static_cast<int>(i));
        ImGui::EndGroup();
        if (alone && ImGui::BeginPopupContextItem("point menu")) {
            if (ImGui::MenuItem("Put a point behind it")) changed = with_point_behind(points, i);
            if (ImGui::MenuItem("Take it out")) (changed = points)->erase(changed->begin() + static_cast<std::ptrdiff_t>(i));
            ImGui::EndPopup();
        }
        ImGui::PopID();
    }
    if (alone && small_button(row.theme(), "+ point", "Right-click a point to take it out, or to put one behind it.") && !points.empty())
        changed = with_point_behind(points, points.size() - 1);
    ImGui::EndGroup();
    if (changed) row.set(*changed);
}

}  // namespace pinfield::editor

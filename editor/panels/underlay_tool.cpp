#include "editor/panels/underlay_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/lay_under.h"
#include "editor/panels/fields.h"
#include "editor/typed_number.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

constexpr double grip_pixels = 9;
constexpr double drag_pixels = 3;
constexpr float panel_width = 320, label_width = 92;  // design pixels

ImVec2 im(const Vec2& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

std::string millimetres(double metres) {
    const Shown text = shown(metres, Unit::metre);
    return text.number + " " + text.unit;
}

Box2 box_now(const AppState& state) { return box_of(state.aids.underlay, *underlay_pixels(state)); }

Vec2 pixel_of(const AppState& state, const Vec2& own) { return state.view.pixel_from_world(world_from_picture(box_now(state), own)); }

int point_under_mouse(const AppState& state, const Ui& ui) {
    for (std::size_t i = 0; i < ui.underlay.points.size(); ++i)
        if (length(pixel_of(state, ui.underlay.points[i]) - ui.mouse) < grip_pixels * ui.theme.scale) return static_cast<int>(i);
    return -1;
}

void press(const AppState& state, Ui& ui) {
    UnderlayHand& hand = ui.underlay;
    hand.pressing = true;
    hand.dragging = false;
    hand.before = state.aids.underlay;
    hand.pressed_at = ui.mouse;
    hand.point = point_under_mouse(state, ui);
    if (hand.point >= 0) hand.point_before = at(hand.points, hand.point);
}

void drag(AppState& state, Ui& ui) {
    UnderlayHand& hand = ui.underlay;
    hand.dragging = hand.dragging || length(ui.mouse - hand.pressed_at) > drag_pixels;
    if (!hand.dragging) return;
    Vec2 delta = (ui.mouse - hand.pressed_at) / state.view.pixels_per_metre;
    delta.y() = -delta.y();
    if (hand.point >= 0) {
        at(hand.points, hand.point) = hand.point_before + delta.cwiseQuotient(box_now(state).size());
        return;
    }
    if (state.aids.underlay.locked) return say(state, "The underlay is locked", true);
    if (ImGui::GetIO().KeyShift) delta[std::fabs(delta.x()) < std::fabs(delta.y()) ? 0 : 1] = 0;
    const auto in_reach = [](double x) { return std::clamp(x, -farthest_underlay, farthest_underlay); };
    state.aids.underlay.centre = (hand.before.centre + delta).unaryExpr(in_reach);
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
}

/// The third one begins anew.
void click(AppState& state, Ui& ui) {
    UnderlayHand& hand = ui.underlay;
    const Vec2 own = picture_from_world(box_now(state), ui.mouse_world);
    if (hand.point >= 0) return;
    if (own.minCoeff() < 0 || own.maxCoeff() > 1) return say(state, "Click on the picture", true);
    forget_problem(state);
    if (hand.points.size() == 2) hand.points.clear();
    hand.points.push_back(own);
    hand.wants_distance = hand.points.size() == 2;
}

double distance_now(const AppState& state, const std::vector<Vec2>& points) {
    const Box2 box = box_now(state);
    return length(world_from_picture(box, at(points, 1)) - world_from_picture(box, at(points, 0)));
}

void label(const Theme& theme, const char* words) {
    ImGui::AlignTextToFramePadding();
    text_in(theme.body, palette::quiet, words);
    ImGui::SameLine(theme.px(label_width) + theme.px(12));
}

/// A length to be typed. True when another one was.
bool length_row(AppState& state, const Theme& theme, const char* words, TypedLength& typed, double& value) {
    label(theme, words);
    if (!typed.active) typed.text = shown(value, Unit::metre).number;
    char buffer[64] = {};
    typed.text.copy(buffer, sizeof buffer - 1);
    if (std::exchange(typed.begins, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(theme.px(110));
    const bool entered = ImGui::InputText((std::string("##") + words).c_str(), buffer, sizeof buffer,
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    const bool ended = ImGui::IsItemDeactivated(), edited = ImGui::IsItemDeactivatedAfterEdit();
    typed.active = ImGui::IsItemActive();
    typed.text = buffer;
    const std::string unit = shown(value, Unit::metre).unit;
    ImGui::SameLine(0, theme.px(6));
    text_in(theme.body, palette::quiet, unit);
    if (!entered && (!ended || !edited || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))) return false;
    const Result<double> read = typed_number(typed.text, Unit::metre, unit == "mm" ? "mm" : "");
    if (!read) return tell(state, read.error().message), false;
    if (!(*read > 0)) return say(state, "A length is more than nothing", true), false;
    value = *read;
    return true;
}

void numbers(AppState& state, Ui& ui) {
    const Theme& theme = ui.theme;
    const Vec2 pixels = *underlay_pixels(state);
    Underlay& underlay = state.aids.underlay;
    const Underlay before = underlay;
    double width = underlay.width;
    if (length_row(state, theme, "Width", ui.underlay.width, width)) underlay = with_width(underlay, pixels, width);
    const std::vector<Vec2>& points = ui.underlay.points;
    if (points.size() == 2) {
        double distance = distance_now(state, points);
        ui.underlay.distance.begins = std::exchange(ui.underlay.wants_distance, false);
        if (length_row(state, theme, "Distance", ui.underlay.distance, distance)) {
            underlay = scaled_by_points(before, pixels, at(points, 0), at(points, 1), distance);
            if (underlay == before) say(state, "Between these two points there is no such distance", true);
        }
    }
    if (underlay.locked && !(underlay == before)) {
        underlay = before;
        say(state, "The underlay is locked", true);
    }
    if (points.size() == 2) return;
    ImGui::PushTextWrapPos(0);
    text_in(theme.small, palette::quiet,
            points.empty() ? "Or click two points of the picture whose distance you know; then type that." : "Now the other point.");
    ImGui::PopTextWrapPos();
}

void opacity_row(AppState& state, const Theme& theme) {
    label(theme, "Opacity");
    auto percent = static_cast<int>(std::lround(100 * state.aids.underlay.opacity));
    ImGui::SetNextItemWidth(-1);
    if (ImGui::SliderInt("##opacity", &percent, static_cast<int>(std::lround(100 * least_opacity)), 100, "%d %%",
                         ImGuiSliderFlags_AlwaysClamp))
        state.aids.underlay.opacity = percent / 100.0;
}

/// Words that do something, on one line; a switch that is on is lit.
void buttons(AppState& state, const Theme& theme) {
    struct Button {
        const char* word;
        std::string_view action;
    };
    constexpr Button all[] = {
        {"Turn", "underlay.turn"}, {"Lock", "underlay.lock"}, {"Hide", "underlay.show"}, {"Remove", "underlay.remove"}};
    for (const Button& button : all) {
        const bool on = button.action == "underlay.lock" && is_on(state, button.action), can = enabled(state, button.action);
        ImGui::PushStyleColor(ImGuiCol_Button, on ? palette::accent_deep : palette::field);
        ImGui::PushStyleColor(ImGuiCol_Text, can ? palette::text : palette::faint);
        const char* const word = button.action == "underlay.show" && !state.aids.underlay.shown ? "Show" : button.word;
        if (ImGui::Button(word) && can) run(state, button.action);
        ImGui::PopStyleColor(2);
        tooltip(theme, find_action(button.action)->doc);
        ImGui::SameLine(0, theme.px(4));
    }
    ImGui::PushStyleColor(ImGuiCol_Button, Tint(Role::primary));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, Tint(Role::primary_hot));
    ImGui::PushStyleColor(ImGuiCol_Text, Tint(Role::on_primary));
    if (ImGui::Button("Done")) run(state, "tool.select");
    ImGui::PopStyleColor(3);
}

}  // namespace

void move_underlay(AppState& state, Ui& ui) {
    if (!underlay_pixels(state)) return;
    const bool down = ImGui::GetIO().MouseDown[0];
    if (ImGui::IsItemActivated() && down) press(state, ui);
    if (!ui.underlay.pressing) return;
    if (ImGui::IsItemActive() && down) return drag(state, ui);
    ui.underlay.pressing = false;
    if (!ui.underlay.dragging) click(state, ui);
}

bool cancel_underlay(AppState& state, Ui& ui) {
    if (state.tool != Tool::underlay) return false;
    UnderlayHand& hand = ui.underlay;
    if (std::exchange(hand.pressing, false) && hand.dragging) {
        if (hand.point >= 0)
            at(hand.points, hand.point) = hand.point_before;
        else
            state.aids.underlay.centre = hand.before.centre;
        return true;
    }
    const bool any = !hand.points.empty();
    hand = {};
    return any;
}

void draw_underlay_points(const AppState& state, const Ui& ui, ImDrawList& list) {
    if (state.tool != Tool::underlay || !underlay_pixels(state)) return;
    const Theme& theme = ui.theme;
    const float thin = std::max(1.0f, theme.px(1.5f)), r = theme.px(7);
    const Box2 box = box_now(state);
    const ImVec2 lo = im(state.view.pixel_from_world(box.lo)), hi = im(state.view.pixel_from_world(box.hi));
    list.AddRect({lo.x, hi.y}, {hi.x, lo.y}, ink(palette::accent.faded(0.8f)), 0, 0, thin);
    const std::vector<Vec2>& points = ui.underlay.points;
    if (points.size() == 2) {
        const ImVec2 a = im(pixel_of(state, points[0])), b = im(pixel_of(state, points[1]));
        list.AddLine(a, b, ink(palette::amber), thin);
        const ImVec2 beside{0.5f * (a.x + b.x) + theme.px(10), 0.5f * (a.y + b.y) + theme.px(8)};
        plate(theme, list, beside, millimetres(distance_now(state, points)), palette::amber);
    }
    for (const Vec2& point : points) {
        const ImVec2 c = im(pixel_of(state, point));
        list.AddCircle(c, r, ink(palette::bar), 0, 3 * thin);
        list.AddCircle(c, r, ink(palette::amber), 0, thin);
        list.AddLine({c.x - r, c.y}, {c.x + r, c.y}, ink(palette::amber), thin);
        list.AddLine({c.x, c.y - r}, {c.x, c.y + r}, ink(palette::amber), thin);
    }
}

void underlay_controls(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    if (state.tool != Tool::underlay) {
        ui.underlay = {};
        return;
    }
    const float margin = theme.px(12), width = std::min(theme.px(panel_width), size.x - 2 * margin);
    ImGui::SetCursorScreenPos({position.x + margin, position.y + theme.px(46)});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::panel);
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, theme.px(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(margin, theme.px(10)));
    const float height = 4 * ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing() + theme.px(22);
    ImGui::BeginChild("##underlay", {width, height}, false, ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    const std::string& path = state.aids.underlay.path;
    text_in(theme.strong, palette::text, fitted("Underlay: " + path.substr(path.find_last_of('/') + 1), width - 2 * margin));
    tooltip(theme, path);
    if (underlay_pixels(state)) numbers(state, ui);
    opacity_row(state, theme);
    buttons(state, theme);
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

}  // namespace pinfield::editor

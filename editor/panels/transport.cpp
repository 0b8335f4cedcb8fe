#include <algorithm>

#include "editor/panels/ui.h"
#include "editor/widgets/widgets.h"
#include "engine/core/numbers.h"

namespace pinfield::editor {

namespace {

std::string with_key(std::string_view action) {
    const Action* found = find_action(action);
    return std::string(found->label) + " (" + std::string(found->shortcut) + ")\n" + std::string(found->doc);
}

void play_buttons(AppState& state, const Theme& theme) {
    const auto button = [&](Icon icon, const char* action, bool lit) {
        const IconButton what{icon, action, with_key(action), lit, enabled(state, action)};
        if (icon_button(theme, what, theme.px(34))) run(state, action);
        ImGui::SameLine(0, theme.px(4));
    };
    button(state.session.playing() ? Icon::pause : Icon::play, "play.toggle", state.session.playing());
    button(Icon::step, "play.step", false);
    button(Icon::reset, "play.reset", false);
}

/// Not where only a part of it could be seen.
void speed_menu(AppState& state, const Theme& theme) {
    const float width = theme.px(72);
    if (ImGui::GetItemRectMax().x + theme.px(12) + width > ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) return;
    const auto name = [](int divisor) { return divisor == 1 ? std::string("1\u00d7") : "1/" + std::to_string(divisor); };
    ImGui::SameLine(0, theme.px(12));
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.5f * (theme.px(34) - ImGui::GetFrameHeight()));
    if (begin_combo(theme, "##speed", name(state.session.slow_motion()).c_str(), width)) {
        for (int divisor = 1; divisor <= slowest; divisor *= 2)
            if (ImGui::Selectable(name(divisor).c_str(), divisor == state.session.slow_motion())) state.session.set_slow_motion(divisor);
        ImGui::EndCombo();
    }
    tooltip(theme, "Speed: real time or slow motion.\nSlower [   Faster ]");
}

/// What real time is missed is said, beside the speed that was asked for; returns where it ends.
float missed_time(const AppState& state, const Theme& theme, float left, float right, float y) {
    constexpr double unseen = 0.95;
    if (state.real_time >= unseen || !plays(state)) return left;
    const std::string speed = to_text(state.real_time / state.session.slow_motion(), 2) + "\u00d7";
    const std::string text = speed + ": the computer is too slow";
    const auto width = [](const std::string& t) { return ImGui::CalcTextSize(t.c_str()).x + 1; };
    const std::string& shown = left + width(text) < right ? text : speed;
    if (left + width(shown) >= right) return left;
    ImGui::GetWindowDrawList()->AddText({left, y}, ink(palette::amber), shown.c_str());
    return left + width(shown) + theme.px(16);
}

/// A label over a number, growing to the left from `right`; returns where it begins.
float counter(ImDrawList& list, const Theme& theme, const char* label, const std::string& number, float right, float top,
              const Tint& color) {
    ImGui::PushFont(theme.small);
    const float label_width = ImGui::CalcTextSize(label).x;
    ImGui::PopFont();
    float cell = 0;
    for (const char* d = "0123456789"; *d; ++d)
        cell = std::max(cell, theme.large->CalcTextSizeA(theme.large->FontSize, 1e9f, 0, d, d + 1).x);
    const float width = std::max(label_width, theme.px(6) + static_cast<float>(number.size()) * (cell + 1));
    const float x = std::floor(right - width);
    list.AddText(theme.small, theme.small->FontSize, {x, top}, ink(palette::quiet), label);
    steady_number(list, theme.large, {x, top + theme.small->FontSize - theme.px(1)}, color, number);
    return x;
}

}  // namespace

void transport_bar(AppState& state, Ui& ui, ImVec2 position, ImVec2 size) {
    const Theme& theme = ui.theme;
    begin_region("##transport", position, size, palette::bar, {theme.px(12), theme.px(8)},
                 ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine(position, {position.x + size.x, position.y}, ink(palette::line));
    play_buttons(state, theme);
    speed_menu(state, theme);

    const World& world = state.session.world();
    const float top = position.y + theme.px(6), gap = theme.px(26);
    const std::string time = to_text(world.time(), 2) + " s";
    float right = position.x + size.x - theme.px(16);
    const float after = ImGui::GetItemRectMax().x + theme.px(16), most = right - theme.px(270);
    const float least = missed_time(state, theme, after, most, position.y + 0.5f * (size.y - ImGui::GetFontSize()));
    // Where it gets narrow the clock goes first, the score last.
    const float room = (right - least) / theme.scale;
    const auto show = [&](const char* label, const std::string& number, const Tint& color, float needed) {
        if (room >= needed) right = counter(list, theme, label, number, right, top, color) - gap;
    };
    show("Tick", std::to_string(world.tick()), palette::quiet, 370);
    show("Time", time, palette::quiet, 270);
    show("Drained", std::to_string(state.session.drained()), palette::text, 150);
    show("Bumper hits", std::to_string(state.session.hits()), palette::accent, 70);
    ImGui::End();
}

}  // namespace pinfield::editor

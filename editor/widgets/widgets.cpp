#include "editor/widgets/widgets.h"


#include <algorithm>
#include <cmath>

namespace pinfield::editor {
namespace {

float text_width(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

}  // namespace

void give_keys_to_menus(bool open) {
    ImGuiIO& io = ImGui::GetIO();
    if (!open) {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
        return;
    }
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
#if IMGUI_VERSION_NUM < 18700
    // It takes Space alone for yes.
    if (ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Enter))) io.NavInputs[ImGuiNavInput_Activate] = 1;
#endif
}

bool begin_region(const char* name, ImVec2 position, ImVec2 size, const Tint& background, ImVec2 padding, ImGuiWindowFlags more) {
    ImGui::SetNextWindowPos(position);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, background);
    const bool open = ImGui::Begin(name, nullptr,
                                   ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav | more);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    return open;
}

void splitter(const char* name, ImVec2 position, ImVec2 size, bool vertical, float sign, float scale, float& design_size,
              float least, float most) {
    begin_region(name, position, size, palette::bar, {0, 0});
    ImGui::InvisibleButton("grip", size);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        ImGui::GetWindowDrawList()->AddRectFilled(position, {position.x + size.x, position.y + size.y},
                                                  ink(palette::accent.faded(ImGui::IsItemActive() ? 0.9f : 0.5f)));
    }
    if (ImGui::IsItemActive()) {
        const ImVec2 delta = ImGui::GetIO().MouseDelta;
        design_size = std::clamp(design_size + sign * (vertical ? delta.x : delta.y) / scale, least, std::max(least, most));
    }
    ImGui::End();
}

bool icon_button(const Theme& theme, const IconButton& button, float size) {
    const ImVec2 place = ImGui::GetCursorScreenPos();
    ImGui::BeginDisabled(!button.enabled);
    const bool clicked = ImGui::InvisibleButton(button.id, {size, size});
    const bool hot = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
    ImGui::EndDisabled();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{place.x + size, place.y + size};
    const float round = theme.px(5);
    if (button.lit) list.AddRectFilled(place, end, ink(palette::accent_deep), round);
    if (hot && button.enabled) list.AddRectFilled(place, end, ink(held ? palette::field_active : palette::field_hot), round);
    const Tint color = !button.enabled ? palette::faint : button.lit ? palette::accent : palette::text;
    draw_icon(list, button.icon, {place.x + 0.5f * size, place.y + 0.5f * size}, std::round(0.46f * size), ink(color));
    tooltip(theme, button.tooltip);
    return clicked;
}

void section(const Theme& theme, const char* title) {
    ImGui::Dummy({0, theme.px(4)});
    text_in(theme.strong, palette::text, title);
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::GetWindowDrawList()->AddLine({place.x, place.y - theme.px(2)}, {place.x + width, place.y - theme.px(2)}, ink(palette::line));
    ImGui::Dummy({0, theme.px(1)});
}

void tooltip(const Theme& theme, std::string_view text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsItemActive()) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(10), theme.px(7)));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(theme.px(300));
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

namespace {

constexpr float pill_pad = 7;

}  // namespace

void pill(const Theme& theme, std::string_view text, const Tint& color, PillStyle style) {
    ImGui::PushFont(theme.small);
    const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
    const ImVec2 place = ImGui::GetCursorScreenPos(), pad{theme.px(pill_pad), theme.px(2)};
    const ImVec2 end{place.x + size.x + 2 * pad.x, place.y + size.y + 2 * pad.y};
    const float round = 0.5f * (end.y - place.y);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (style == PillStyle::filled) list.AddRectFilled(place, end, ink(color.faded(0.16f)), round);
    else list.AddRect(place, end, ink(color.faded(0.5f)), round);
    list.AddText({place.x + pad.x, place.y + pad.y}, ink(color), text.data(), text.data() + text.size());
    ImGui::Dummy({end.x - place.x, end.y - place.y});
    ImGui::PopFont();
}

float pill_width(const Theme& theme, std::string_view text) {
    ImGui::PushFont(theme.small);
    const float width = text_width(text);
    ImGui::PopFont();
    return width + 2 * theme.px(pill_pad);
}

void plate(const Theme& theme, ImDrawList& list, ImVec2 place, std::string_view text, const Tint& color) {
    const char *const begin = text.data(), *const end = begin + text.size();
    const ImVec2 size = ImGui::CalcTextSize(begin, end), pad{theme.px(7), theme.px(3)};
    place = {std::round(place.x), std::round(place.y)};
    list.AddRectFilled({place.x - pad.x, place.y - pad.y}, {place.x + size.x + pad.x, place.y + size.y + pad.y}, ink(palette::bar.faded(0.92f)), theme.px(4));
    list.AddText(place, ink(color), begin, end);
}

std::string fitted(std::string_view text, float width) {
    if (text_width(text) <= width) return std::string(text);
    std::size_t length = text.size();
    while (length > 0) {
        --length;
        while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xc0u) == 0x80u) --length;  // whole characters
        const std::string shorter = std::string(text.substr(0, length)) + "\u2026";
        if (text_width(shorter) <= width) return shorter;
    }
    return "";
}

void text_in(ImFont* font, const Tint& color, std::string_view text) {
    ImGui::PushFont(font);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

float steady_number(ImDrawList& list, ImFont* font, ImVec2 place, const Tint& color, std::string_view text) {
    const float size = font->FontSize;
    float cell = 0;
    for (const char* digit = "0123456789"; *digit; ++digit)
        cell = std::max(cell, font->CalcTextSizeA(size, 1e9f, 0, digit, digit + 1).x);
    cell = std::ceil(cell);
    float x = place.x;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t n = 1;
        while (i + n < text.size() && (static_cast<unsigned char>(text[i + n]) & 0xc0u) == 0x80u) ++n;
        const char* begin = text.data() + i;
        const float width = font->CalcTextSizeA(size, 1e9f, 0, begin, begin + n).x;
        const bool digit = *begin >= '0' && *begin <= '9';
        const float step = digit ? cell : std::ceil(width);
        list.AddText(font, size, {std::round(x + 0.5f * (step - width)), place.y}, ink(color), begin, begin + n);
        x += step;
        i += n;
    }
    return x - place.x;
}

float segmented_width(const Theme& theme, std::span<const std::string_view> words) {
    float total = 0;
    for (const std::string_view word : words) total += std::ceil(text_width(word)) + 2 * theme.px(10);
    return total;
}

int segmented(const Theme& theme, const char* id, std::span<const std::string_view> words, int chosen) {
    ImGui::PushID(id);
    int clicked = -1, index = 0;
    const ImVec2 pad{theme.px(10), theme.px(4)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec2 place = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFontSize() + 2 * pad.y, round = theme.px(5);
    list.AddRectFilled(place, {place.x + segmented_width(theme, words), place.y + height}, ink(palette::field.faded(0.92f)), round);
    for (const std::string_view word : words) {
        const float width = std::ceil(text_width(word)) + 2 * pad.x;
        ImGui::SetCursorScreenPos(place);
        ImGui::PushID(index);
        if (ImGui::InvisibleButton("word", {width, height})) clicked = index;
        ImGui::PopID();
        const bool lit = index == chosen, hot = ImGui::IsItemHovered();
        if (lit) list.AddRectFilled(place, {place.x + width, place.y + height}, ink(palette::accent_deep), round);
        list.AddText({place.x + pad.x, place.y + pad.y}, ink(lit || hot ? palette::text : palette::quiet), word.data(), word.data() + word.size());
        place.x += width;
        ++index;
    }
    ImGui::PopID();
    return clicked;
}

bool small_button(const Theme& theme, const char* label, std::string_view tip) {
    ImGui::PushStyleColor(ImGuiCol_Button, palette::field);
    ImGui::PushStyleColor(ImGuiCol_Text, palette::quiet);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(theme.px(8), theme.px(2)));
    const bool clicked = ImGui::Button(label);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    tooltip(theme, tip);
    return clicked;
}

bool begin_combo(const Theme& theme, const char* id, const char* preview, float width) {
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(6), theme.px(6)));
    const ImVec2 place = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool open = ImGui::BeginCombo(id, preview, ImGuiComboFlags_NoArrowButton);
    ImGui::PopStyleVar();
    const float s = theme.px(3.5f), y = place.y + 0.5f * ImGui::GetFrameHeight();
    const ImVec2 c{place.x + width - theme.px(13), y};
    const ImU32 color = ink(palette::quiet);
    const float thick = std::max(1.0f, 1.4f * theme.scale);
    list.AddLine({c.x - s, c.y - 0.5f * s}, {c.x, c.y + 0.5f * s}, color, thick);
    list.AddLine({c.x, c.y + 0.5f * s}, {c.x + s, c.y - 0.5f * s}, color, thick);
    return open;
}

float dialog_button_width(const Theme& theme, const char* label) {
    return std::max(theme.px(92), ImGui::CalcTextSize(label).x + theme.px(28));
}

bool dialog_button(const Theme& theme, const char* label, bool primary) {
    ImGui::PushStyleColor(ImGuiCol_Button, primary ? Role::primary : palette::field);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, primary ? Role::primary_hot : palette::field_hot);
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, primary ? Role::primary_active : palette::field_active);
    ImGui::PushStyleColor(ImGuiCol_Text, primary ? Role::on_primary : palette::text);
    const bool clicked = ImGui::Button(label, {dialog_button_width(theme, label), theme.px(30)});
    ImGui::PopStyleColor(4);
    return clicked;
}

}  // namespace pinfield::editor

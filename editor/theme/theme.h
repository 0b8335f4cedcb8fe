// How the editor looks: one palette, three sizes of one font, spacing in multiples of one unit.
#pragma once
#include <imgui.h>

#include "editor/render/gl_objects.h"
#include "engine/program/program.h"

namespace pinfield::editor {

/// A color that can be a constant, which ImVec4 cannot.
struct Tint {
    float r = 0, g = 0, b = 0, a = 1;
    operator ImVec4() const { return {r, g, b, a}; }
    constexpr Tint faded(float alpha) const { return {r, g, b, a * alpha}; }
    constexpr Rgb rgb() const { return {r, g, b}; }
};
inline ImU32 ink(const Tint& color) { return ImGui::ColorConvertFloat4ToU32(color); }

namespace palette {

constexpr Tint hex(unsigned rgb) {
    return {static_cast<float>(rgb >> 16 & 255u) / 255, static_cast<float>(rgb >> 8 & 255u) / 255,
            static_cast<float>(rgb & 255u) / 255, 1};
}

// Blue against amber can be told apart with every kind of color vision; meaning never rests on color alone.
inline constexpr Tint backdrop = hex(0x14161a);  ///< behind the table
inline constexpr Tint panel = hex(0x1c1f25);
inline constexpr Tint bar = hex(0x181a1f);       ///< menu, transport, status
inline constexpr Tint field = hex(0x272b33);     ///< what can be edited
inline constexpr Tint field_hot = hex(0x313742);
inline constexpr Tint field_active = hex(0x39414e);
inline constexpr Tint line = hex(0x2c3038);      ///< borders
inline constexpr Tint text = hex(0xe3e6eb);
inline constexpr Tint quiet = hex(0x99a1ae);     ///< labels, units; 6.4 : 1 on a panel
inline constexpr Tint faint = hex(0x676f7c);     ///< disabled
inline constexpr Tint accent = hex(0x5db1f2);    ///< selection, focus
inline constexpr Tint accent_deep = hex(0x1f4a6d);
inline constexpr Tint amber = hex(0xf0b04a);     ///< warnings, operations
inline constexpr Tint coral = hex(0xf07f5f);     ///< errors
inline constexpr Tint teal = hex(0x55c7b0);      ///< mechanisms

}  // namespace palette

struct Theme {
    float scale = 1;  ///< screen pixels per design pixel
    ImFont* body = nullptr;
    ImFont* strong = nullptr;  ///< headings
    ImFont* small = nullptr;   ///< units, hints
    ImFont* large = nullptr;   ///< counters
    ImFont* mono = nullptr;    ///< YAML: every character as wide as every other

    float px(float design_pixels) const;  ///< whole screen pixels
};

/// Sets up fonts and style of the current ImGui context. `font_size` in design pixels at scale 1.
Theme make_theme(float scale, float font_size);

/// Colors of a program's materials: the author's, where the text is one, else a calm rotation of the theme's.
std::vector<Rgb> material_colors(const Program& program);

}  // namespace pinfield::editor

// How the editor looks: one palette, three sizes of one font, spacing in multiples of one unit.
#pragma once
#include <imgui.h>

#include "editor/render/gl_objects.h"
#include "engine/program/program.h"

namespace pinfield::editor {

namespace palette {

constexpr ImVec4 hex(unsigned rgb, float alpha = 1) {
    return {static_cast<float>(rgb >> 16 & 255u) / 255, static_cast<float>(rgb >> 8 & 255u) / 255,
            static_cast<float>(rgb & 255u) / 255, alpha};
}

// Blue against amber is told apart with every kind of colour vision; meaning never rests on colour alone.
inline constexpr ImVec4 backdrop = hex(0x14161a);  ///< behind the table
inline constexpr ImVec4 panel = hex(0x1c1f25);
inline constexpr ImVec4 bar = hex(0x181a1f);       ///< menu, transport, status
inline constexpr ImVec4 field = hex(0x272b33);     ///< what can be edited
inline constexpr ImVec4 field_hot = hex(0x313742);
inline constexpr ImVec4 field_active = hex(0x39414e);
inline constexpr ImVec4 line = hex(0x2c3038);      ///< borders
inline constexpr ImVec4 text = hex(0xe3e6eb);
inline constexpr ImVec4 quiet = hex(0x99a1ae);     ///< labels, units; 6.4 : 1 on a panel
inline constexpr ImVec4 faint = hex(0x676f7c);     ///< disabled
inline constexpr ImVec4 accent = hex(0x5db1f2);    ///< selection, focus
inline constexpr ImVec4 accent_deep = hex(0x1f4a6d);
inline constexpr ImVec4 amber = hex(0xf0b04a);     ///< warnings, operations
inline constexpr ImVec4 coral = hex(0xf07f5f);     ///< errors
inline constexpr ImVec4 teal = hex(0x55c7b0);      ///< mechanisms

}  // namespace palette

inline ImU32 ink(const ImVec4& color) { return ImGui::ColorConvertFloat4ToU32(color); }
inline ImVec4 faded(ImVec4 color, float alpha) {
    color.w *= alpha;
    return color;
}
inline Rgb rgb(const ImVec4& color) { return {color.x, color.y, color.z}; }

struct Theme {
    float scale = 1;  ///< screen pixels per design pixel
    ImFont* body = nullptr;
    ImFont* strong = nullptr;  ///< headings
    ImFont* small = nullptr;   ///< units, hints
    ImFont* large = nullptr;   ///< counters

    float px(float design_pixels) const;  ///< whole screen pixels
};

/// Sets up fonts and style of the current ImGui context. `font_size` in design pixels at scale 1.
Theme make_theme(float scale, float font_size);

/// Colours of a program's materials: the author's, where the text is one, else a calm rotation of the theme's.
std::vector<Rgb> material_colors(const Program& program);

}  // namespace pinfield::editor

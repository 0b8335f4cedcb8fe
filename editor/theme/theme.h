// How the editor looks: its colors, three sizes of one font, spacing in multiples of one unit.
#pragma once
#include <imgui.h>

#include "editor/theme/colors.h"
#include "engine/program/program.h"

namespace pinfield::editor {

struct Theme {
    float scale = 1;  ///< screen pixels per design pixel
    ImFont* body = nullptr;
    ImFont* strong = nullptr;  ///< headings
    ImFont* small = nullptr;   ///< units, hints
    ImFont* large = nullptr;   ///< counters
    ImFont* mono = nullptr;    ///< YAML: every character as wide as every other

    float px(float design_pixels) const;  ///< whole screen pixels
};

/// Sets up fonts, colors and style of the current ImGui context. `font_size` in design pixels at scale 1.
Theme make_theme(float scale, float font_size, ThemeChoice choice = ThemeChoice::dark);

/// Colors of a program's materials: the author's, where the text is one, else a calm rotation of the theme's, which the context knows.
std::vector<Rgb> material_colors(const Program& program);

}  // namespace pinfield::editor

// What a person would read on the screen: the texts of a Dear ImGui frame, taken back from the triangles it would draw.
#pragma once
#include <imgui.h>

#include <string>
#include <vector>

namespace pinfield::editor {

/// Neighbouring characters on one line, and where they are, in pixels.
struct ScreenText {
    std::string text;  ///< characters beyond ASCII as '?'
    ImVec2 at{0, 0};
    std::string window{};  ///< that it is drawn in
};

/// Call after ImGui::Render(). A character is the textured rectangle whose texture coordinates are one glyph's of the atlas.
std::vector<ScreenText> screen_texts();

}  // namespace pinfield::editor

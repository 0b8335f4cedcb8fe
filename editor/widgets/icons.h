// Small pictures drawn with lines: sharp at every scale, no image files.
#pragma once
#include <imgui.h>

namespace pinfield::editor {

enum class Icon : unsigned char {
    play, pause, step, reset, shape, operation, part, group, table, physics, material, seen, hidden, locked, unlocked, error, warning, fine,
    search, folder, file, frame, point, star, star_outline
};

/// Within a square of this size about `centre`.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 color);

}  // namespace pinfield::editor

// What dialogs are made of: a window that holds everything else up, and a row of answers.
#pragma once
#include <span>
#include <string_view>

#include "editor/theme/theme.h"

namespace pinfield::editor {

/// Centred, as wide as asked (design pixels), dimming what is behind; end with ImGui::EndPopup() when true.
bool begin_modal(const Theme& theme, const char* title, float width);

/// Moves the next items so that they end at the right edge.
void align_right(float width);

bool escape_pressed();

struct Answer {
    const char* label;
    std::string_view action;
};

/// A row of buttons that ends at the right edge: the action of the one that was clicked, or chosen by Tab or arrows and then Enter or Space;
/// Esc gives `on_escape`. `preferred` is chosen at first, `chosen` is the one that is. A key that opened the dialog does not answer it.
std::string_view answered(const Theme& theme, std::span<const Answer> answers, int preferred, int& chosen, std::string_view on_escape);

}  // namespace pinfield::editor

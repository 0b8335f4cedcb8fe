// The few widgets that Dear ImGui does not have, in the theme's manner.
#pragma once
#include <imgui.h>

#include <span>
#include <string>
#include <string_view>

#include "editor/theme/theme.h"
#include "editor/widgets/icons.h"

namespace pinfield::editor {

/// Just before a frame: while a menu, or a list of choices, is open, its keys are its own: arrows, Enter, Space and Esc.
void give_keys_to_menus(bool open);

/// A part of the window with a fixed place; end with ImGui::End().
bool begin_region(const char* name, ImVec2 position, ImVec2 size, const Tint& background, ImVec2 padding, ImGuiWindowFlags more = 0);

/// A thin strip between regions that changes `size` while it is dragged; `sign`: which way grows it. Draws its own window.
void splitter(const char* name, ImVec2 position, ImVec2 size, bool vertical, float sign, float scale, float& design_size,
              float least, float most);

struct IconButton {
    Icon icon = Icon::play;
    const char* id = "";
    std::string tooltip;
    bool lit = false;
    bool enabled = true;
};
bool icon_button(const Theme& theme, const IconButton& button, float size);

/// A heading over a part of a panel.
void section(const Theme& theme, const char* title);

/// A tooltip of at most a comfortable width, for the item before.
void tooltip(const Theme& theme, std::string_view text);

/// A small rounded label on a tint of its color, or within a line of it.
enum class PillStyle : unsigned char { filled, bare };
void pill(const Theme& theme, std::string_view text, const Tint& color, PillStyle style);
float pill_width(const Theme& theme, std::string_view text);

/// Words on a plate of their own over a picture; `place`: where they begin.
void plate(const Theme& theme, ImDrawList& list, ImVec2 place, std::string_view text, const Tint& color);

/// Text shortened with an ellipsis to a width.
std::string fitted(std::string_view text, float width);

void text_in(ImFont* font, const Tint& color, std::string_view text);

/// Digits in cells of one width, so that a running counter does not shiver. Returns the width drawn.
float steady_number(ImDrawList& list, ImFont* font, ImVec2 place, const Tint& color, std::string_view text);

/// One of several words, side by side; `chosen` -1: none. Returns the index chosen now, or -1.
int segmented(const Theme& theme, const char* id, std::span<const std::string_view> words, int chosen);
float segmented_width(const Theme& theme, std::span<const std::string_view> words);

/// A word that does something, no larger than what stands beside it.
bool small_button(const Theme& theme, const char* label, std::string_view tip);

/// Like ImGui::BeginCombo(), with a chevron in the theme's manner; end with ImGui::EndCombo() when true.
bool begin_combo(const Theme& theme, const char* id, const char* preview, float width);

/// A blue or a plain button of a dialog.
float dialog_button_width(const Theme& theme, const char* label);
bool dialog_button(const Theme& theme, const char* label, bool primary);

}  // namespace pinfield::editor

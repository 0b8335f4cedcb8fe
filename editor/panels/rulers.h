// Rulers and guides over the table.
#pragma once
#include <optional>

#include "editor/panels/ui.h"

namespace pinfield::editor {

/// Draws the rulers, where they are to be seen, and takes their room from the view's.
void rulers(AppState& state, Ui& ui, ImVec2& position, ImVec2& size);

// A guide: under the mouse; taken hold of; dragged; let go, over its ruler to be removed; put back.
std::optional<std::size_t> guide_under_mouse(const AppState& state, const Ui& ui);
bool press_guide(AppState& state, Ui& ui);
void drag_guide(AppState& state, Ui& ui);
void release_guide(AppState& state, Ui& ui);
bool cancel_guide(AppState& state, Ui& ui);
void draw_guides(const AppState& state, const Ui& ui, ImDrawList& list);

}  // namespace pinfield::editor

// The measure tool, and warnings of gaps that are too narrow for a ball.
#pragma once
#include "editor/panels/ui.h"

namespace pinfield::editor {

/// The left mouse button over the table, with the measure tool.
void measure(AppState& state, Ui& ui);
/// What is measured, over the table.
void draw_measure(const AppState& state, const Ui& ui, ImDrawList& list);
/// The narrowest gap beside what is dragged, where a ball does not fit.
void draw_gap_warning(const AppState& state, const Ui& ui, ImDrawList& list);

}  // namespace pinfield::editor

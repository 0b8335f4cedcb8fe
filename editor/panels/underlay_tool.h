// Bringing the picture beneath the table to its place and size.
#pragma once
#include "editor/panels/ui.h"

namespace pinfield::editor {

/// The left mouse button over the table, with the tool: a drag moves the picture or one of the two points, a click sets these.
void move_underlay(AppState& state, Ui& ui);
/// What was done to it since the button went down is taken back; else the points go. Whether there was anything.
bool cancel_underlay(AppState& state, Ui& ui);
/// The points and what lies between them.
void draw_underlay_points(const AppState& state, const Ui& ui, ImDrawList& list);
/// Its numbers and switches, in the corner of the view.
void underlay_controls(AppState& state, Ui& ui, ImVec2 position, ImVec2 size);

}  // namespace pinfield::editor

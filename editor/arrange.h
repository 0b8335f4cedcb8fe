// Putting several nodes in order, each as one undo step: in line, evenly apart, mirrored. No window, no ImGui.
#pragma once
#include "editor/app_state.h"

namespace pinfield::editor {

/// Which lines of the nodes' boxes come together, at the outermost of them (the middle: of all).
enum class Align : unsigned char { left, middle, right, top, centre, bottom };
void align(AppState& state, Align how);

/// Equal gaps between neighbours along an axis (0: x, 1: y); the outermost two stay. Three nodes at least.
void distribute(AppState& state, int axis);

/// Mirrors the selection in the vertical (axis 0) or horizontal line through its middle.
void flip_selection(AppState& state, int axis);

}  // namespace pinfield::editor

// Where a param's slider stands, and the value it gives where it is put. No window, no ImGui.
#pragma once
#include <optional>

#include "engine/scene/authored.h"

namespace pinfield::editor {

/// What one step of the slider is: the author's, else a two-hundredth of the range, else a hundredth of the value; a round number then.
double step_of(const Param& param);

/// How far along its range a value is, from 0 to 1; nothing where there is no range.
std::optional<double> share_of(const Param& param, double value);

/// The value at this share of the range, on the nearest step, within the range.
double value_at(const Param& param, double share);

/// The value so many steps from another, within the range.
double stepped(const Param& param, double from, double steps);

}  // namespace pinfield::editor

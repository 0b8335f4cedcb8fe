// One row of the inspector: a label and a control for a field, chosen by the kind of its value and nothing else.
#pragma once
#include "editor/panels/ui.h"

namespace pinfield::editor {

void field_row(AppState& state, Ui& ui, const Node& node, int field);

/// How a number of this unit is shown: lengths in millimetres.
struct Shown {
    std::string number, unit;
};
Shown shown(double value, Unit unit);

}  // namespace pinfield::editor

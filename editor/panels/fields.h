// One row of the inspector: a label and a control for a field of one node or several, chosen by the kind of its value and nothing else.
#pragma once
#include "editor/panels/ui.h"

namespace pinfield::editor {

/// `field`: of the nodes that are changed together; the first of them is shown, and `node` is a copy of it.
void field_row(AppState& state, Ui& ui, const Node& node, const SharedField& field);

/// How a number of this unit is shown: lengths in millimetres.
struct Shown {
    std::string number, unit;
};
Shown shown(double value, Unit unit);

}  // namespace pinfield::editor

// Putting Fields together: solids are compiled one by one, each as a Field of its own, and joined.
#pragma once
#include "engine/program/program.h"

namespace pinfield {

/// Is the op an outline that was found of the tree below it? Its only child is then asked for nothing but whose surface is whose.
bool is_found_outline(const Op& op);

/// Appends the solids of `fragment` with all they refer to.
void append(Field& field, const Field& fragment);

/// Puts the only solid of `fragment` in the place of solid `index`: the same as if it had been appended there.
void replace_solid(Field& field, int index, const Field& fragment);

/// Lists the tree solids and builds the hierarchy; call when the solids are complete.
void index(Field& field);

}  // namespace pinfield

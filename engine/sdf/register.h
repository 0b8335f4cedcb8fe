// Puts the built-in shapes and operations into a Catalogue.
#pragma once
#include "engine/reflect/catalogue.h"

namespace pinfield::sdf {

/// Adds every node of catalog.h, in its order, with packet kernels for each instruction set that was built.
void add_built_in(Catalogue& catalogue);

}  // namespace pinfield::sdf

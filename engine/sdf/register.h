// Puts the built-in shapes and operations into a Catalog.
#pragma once
#include <string_view>

#include "engine/reflect/catalog.h"
#include "engine/sdf/kernels.h"

namespace pinfield::sdf {

/// Adds every node of catalog.h, in its order, with packet kernels for each instruction set that was built.
void add_built_in(Catalog& catalog);

/// The built-in node of this name, which there must be.
const NodeType& built_in_type(std::string_view key);

/// Of found_outline.h, which is no node of any table.
const Kernels& found_outline_kernels();

}  // namespace pinfield::sdf

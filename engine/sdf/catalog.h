// Shapes and operations in families, each a list in families/<family>.h; THE list of families stands in CMakeLists.txt. To add a node:
// write its header, name it in the list of its family, give it a scene in scenes/nodes/. Every family is compiled in two units of its own,
// made from families/*.in, and this header includes no node: touching a shape recompiles its family, not the catalog.
#pragma once
#include <span>
#include <vector>

#include "engine/reflect/node_type.h"
#include "engine/sdf/kernels.h"

namespace pinfield::sdf {

/// Appends the family's node types, and their kernels but for what the function below fills in, in the order of its list.
using AddFamily = void(std::vector<NodeType>& types, std::vector<Kernels>& kernels);

/// Writes the family's packet kernels for AVX2, in the order of its list. Run them only where best_isa() allows.
using FillPackets = void(PacketKernels* out);

struct Family {
    AddFamily* add;
    FillPackets* fill_avx2;  ///< null where nothing is compiled for AVX2
};
/// In the order of the catalog.
std::span<const Family> families();

}  // namespace pinfield::sdf

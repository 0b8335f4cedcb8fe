#include "engine/sdf/families/operations.h"

#include "engine/sdf/catalog.h"
#include "engine/sdf/make_kernels.h"

namespace pinfield::sdf {

void add_operations(std::vector<NodeType>& types, std::vector<Kernels>& kernels) { add_nodes(Operations{}, types, kernels); }

}  // namespace pinfield::sdf

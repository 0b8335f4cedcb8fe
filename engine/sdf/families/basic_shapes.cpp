#include "engine/sdf/families/basic_shapes.h"

#include "engine/sdf/catalog.h"
#include "engine/sdf/make_kernels.h"

namespace pinfield::sdf {

void add_basic_shapes(std::vector<NodeType>& types, std::vector<Kernels>& kernels) { add_nodes(BasicShapes{}, types, kernels); }

}  // namespace pinfield::sdf

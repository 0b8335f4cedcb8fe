#include "engine/sdf/families/shapes_of_lines.h"

#include "engine/sdf/catalog.h"
#include "engine/sdf/make_kernels.h"

namespace pinfield::sdf {

void add_shapes_of_lines(std::vector<NodeType>& types, std::vector<Kernels>& kernels) { add_nodes(ShapesOfLines{}, types, kernels); }

}  // namespace pinfield::sdf

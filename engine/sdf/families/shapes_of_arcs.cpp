#include "engine/sdf/families/shapes_of_arcs.h"

#include "engine/sdf/catalog.h"
#include "engine/sdf/make_kernels.h"

namespace pinfield::sdf {

void add_shapes_of_arcs(std::vector<NodeType>& types, std::vector<Kernels>& kernels) { add_nodes(ShapesOfArcs{}, types, kernels); }

}  // namespace pinfield::sdf

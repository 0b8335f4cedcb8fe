#include "engine/sdf/families/shapes_of_curves.h"

#include "engine/sdf/catalog.h"
#include "engine/sdf/make_kernels.h"

namespace pinfield::sdf {

void add_shapes_of_curves(std::vector<NodeType>& types, std::vector<Kernels>& kernels) { add_nodes(ShapesOfCurves{}, types, kernels); }

}  // namespace pinfield::sdf

#include "engine/sdf/catalog.h"
#include "engine/sdf/families/shapes_of_arcs.h"
#include "engine/sdf/make_enclosures.h"

namespace pinfield::sdf {

void fill_shapes_of_arcs_enclosures(Enclosures* out) { fill_enclosures(ShapesOfArcs{}, out); }

}  // namespace pinfield::sdf

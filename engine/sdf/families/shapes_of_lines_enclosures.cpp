#include "engine/sdf/catalog.h"
#include "engine/sdf/families/shapes_of_lines.h"
#include "engine/sdf/make_enclosures.h"

namespace pinfield::sdf {

void fill_shapes_of_lines_enclosures(Enclosures* out) { fill_enclosures(ShapesOfLines{}, out); }

}  // namespace pinfield::sdf

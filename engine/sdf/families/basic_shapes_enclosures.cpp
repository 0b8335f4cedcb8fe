#include "engine/sdf/catalog.h"
#include "engine/sdf/families/basic_shapes.h"
#include "engine/sdf/make_enclosures.h"

namespace pinfield::sdf {

void fill_basic_shapes_enclosures(Enclosures* out) { fill_enclosures(BasicShapes{}, out); }

}  // namespace pinfield::sdf

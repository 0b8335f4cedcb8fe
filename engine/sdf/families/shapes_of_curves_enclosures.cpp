#include "engine/sdf/catalog.h"
#include "engine/sdf/families/shapes_of_curves.h"
#include "engine/sdf/make_enclosures.h"

namespace pinfield::sdf {

void fill_shapes_of_curves_enclosures(Enclosures* out) { fill_enclosures(ShapesOfCurves{}, out); }

}  // namespace pinfield::sdf

#include "engine/sdf/catalog.h"
#include "engine/sdf/families/operations.h"
#include "engine/sdf/make_enclosures.h"

namespace pinfield::sdf {

void fill_operations_enclosures(Enclosures* out) { fill_enclosures(Operations{}, out); }

}  // namespace pinfield::sdf

// Whether a closed chain of edges bounds a region without crossing itself.
#pragma once

namespace pinfield::sdf {

/// No two edges of the chain x0 y0 x1 y1 ... cross, and none runs along another; edges may touch at a point, vertices may coincide.
/// About n log n for ordinary chains, n^2 where most edges overlap in x.
bool is_simple_chain(const double* xy, int count);

}  // namespace pinfield::sdf

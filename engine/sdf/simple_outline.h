// Whether an outline of lines and arcs bounds a region without crossing itself.
#pragma once
#include "engine/sdf/outline.h"

namespace pinfield::sdf {

/// No two pieces meet but where one follows the other, to within 1e-10 of the outline's size, and no place is come by twice. About n log n
/// for ordinary outlines, n^2 where most pieces overlap in x.
bool is_simple_outline(const Outline& outline);

/// Area to the left of closed loops, right side counted negative, m^2.
double signed_area(const Outline& outline);

/// The same loops walked the other way round.
Outline reversed(const Outline& outline);

}  // namespace pinfield::sdf

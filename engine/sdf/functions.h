// What expressions have beyond the operations of scalar.h, for double: core's own. The same for the other scalars stands beside them, in
// dual_functions.h, packet_functions.h and interval_functions.h.
#pragma once
#include "engine/core/trig.h"

namespace pinfield::sdf {

using pinfield::arc_tangent;
using pinfield::cosine_degrees;
using pinfield::exponential;
using pinfield::logarithm;
using pinfield::sine_degrees;

}  // namespace pinfield::sdf

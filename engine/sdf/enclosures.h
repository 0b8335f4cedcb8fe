// What a node's formula can be over a box, behind function pointers: the part of kernels.h that is computed with interval.h. The types are
// only named here, so that interval.h reaches no more than the units that compute with it; interval_box.h is for those.
#pragma once
#include "engine/core/point.h"

namespace pinfield::sdf {

struct Interval;
struct IntervalSample;
struct IntervalWarped;
/// A box of points, in the frame it is asked in.
using IntervalBox = Point<Interval>;

/// Each holds all that the kernel of the same kind returns anywhere in the boxes and intervals it is given; null where the node has no such
/// kernel.
struct Enclosures {
    // shape
    Interval (*distance)(const double* params, const IntervalBox& p) = nullptr;
    IntervalSample (*sample)(const double* params, const IntervalBox& p) = nullptr;
    // fold: dx and dy are the derivatives by a and by b
    IntervalSample (*combine)(const double* params, const Interval& a, const Interval& b) = nullptr;
    // modify: dx is the derivative by d, dy is 0
    IntervalSample (*modify)(const double* params, const Interval& d) = nullptr;
    // warp
    IntervalWarped (*warped)(const double* params, const IntervalBox& p) = nullptr;
};

}  // namespace pinfield::sdf

// What a subject can be over a box: Subject::sample() once more, each number an interval.
#pragma once
#include "engine/sdf/interval_box.h"
#include "tests/conformance/subject.h"

namespace pinfield::conformance {

/// Holds the values of every point of the box, all in the parent's frame, and the gradients except across jumps.
sdf::IntervalSample enclosure(const Subject& subject, const sdf::IntervalBox& p);

}  // namespace pinfield::conformance

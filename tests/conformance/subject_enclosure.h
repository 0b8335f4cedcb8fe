// What a subject can be over a box: Subject::sample() once more, each number an interval.
#pragma once
#include "tests/conformance/interval_box.h"
#include "tests/conformance/subject.h"
#include "tests/conformance/witness.h"

namespace pinfield::conformance {

/// Holds the values of every point of the box, all in the parent's frame, and the gradients except across jumps. `witness` is of the
/// subject's own type; its children are built-in nodes.
sdf::IntervalSample enclosure(const Subject& subject, const Witness& witness, const sdf::IntervalBox& p);

}  // namespace pinfield::conformance

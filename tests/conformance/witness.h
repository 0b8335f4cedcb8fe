// What the laws know of a node beside its kernels: its formula over boxes, and its outline from another definition than its distance.
#pragma once
#include <vector>

#include "engine/sdf/kernels.h"
#include "tests/conformance/enclosures.h"

namespace pinfield::conformance {

/// Points of a shape's outline from its parametric definition, in order, the solid on the left, about `points` of them for each of its
/// parts: for shapes that are not of lines and arcs. May give none.
using ParametricOutline = void (*)(const double* params, int points, std::vector<Vec2>& out);

struct Witness {
    sdf::Enclosures enclosures;
    ParametricOutline parametric_outline = nullptr;  ///< null: none is known
};

/// Of a built-in node; of others nothing.
const Witness& witness_of(const sdf::Kernels& kernels);

}  // namespace pinfield::conformance

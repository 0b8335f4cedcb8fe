// The outlines of the built-in shapes that are not of lines and arcs, each from its parametric definition.
#pragma once
#include <string_view>
#include <vector>

#include "tests/conformance/witness.h"

namespace pinfield::conformance {

struct NamedOutline {
    std::string_view key;  ///< of the shape
    ParametricOutline outline;
};
std::vector<NamedOutline> parametric_outlines();

}  // namespace pinfield::conformance

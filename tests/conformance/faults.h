// The planted faults, and whether the laws see them: what a test demands and what conformance_faults tells.
#pragma once
#include <string_view>
#include <vector>

#include "tests/conformance/check.h"

namespace pinfield::conformance {

/// A node with one fault, and the law that it is planted for.
struct PlantedFault {
    std::string_view what;
    std::string_view law;
    Report (*check)();
};
const std::vector<PlantedFault>& planted_faults();

}  // namespace pinfield::conformance

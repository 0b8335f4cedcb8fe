// What every node of an expression measures: for those within this layer.
#pragma once
#include <vector>

#include "engine/expression/expression.h"

namespace pinfield {

/// measure_of(), for each node.
tl::expected<std::vector<Measure>, ExpressionError> measures_of(const Expression& expression, std::span<const Measure> names);

}  // namespace pinfield

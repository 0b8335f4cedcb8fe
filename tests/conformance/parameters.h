// Parameter sets for a node: its defaults, random ones within ranges and contracts, and degenerate ones.
#pragma once
#include <vector>

#include "engine/core/rng.h"
#include "tests/conformance/subject.h"

namespace pinfield::conformance {

using Values = std::vector<Value>;

Values defaults_of(const NodeType& type);
/// Random values that ranges and contracts accept; the defaults where no draw was accepted in many tries.
Values random_values(const NodeType& type, CounterRng& rng);
/// One field at a time set to nothing, to next to nothing, to the huge, to either end of its range, and to what its partners
/// hold, whatever of that is accepted.
std::vector<Values> degenerate_values(const NodeType& type);

/// Subjects of a type with these values: a shape by itself, an operation over several sets of children.
std::vector<Subject> subjects_of(const Catalog& catalog, const NodeType& type, const Values& values);

}  // namespace pinfield::conformance

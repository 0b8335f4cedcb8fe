// Random tables in random styles of YAML, and random edits of every kind: what no list of examples thinks of.
#pragma once
#include <optional>
#include <string>

#include "engine/core/rng.h"
#include "engine/io/table_reader.h"
#include "engine/scene/edit.h"

namespace pinfield::test {

/// A table that reads, with nodes, materials and inputs of all types: block and flow style, any indentation, quotes, units, comments
/// wherever YAML lets them stand (each with a number of its own), anchors, CRLF, a byte order mark.
std::string random_table(CounterRng& rng);

/// Any edit but SetField, of any node, material or input, that the scene lets pass; or nothing after a few tries.
std::optional<Edit> some_structural_edit(const Scene& scene, CounterRng& rng);

}  // namespace pinfield::test

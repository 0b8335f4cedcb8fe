// A table that says at random some of its things once: params, templates, copies, pairs and expressions.
#pragma once
#include <string>

#include "engine/core/rng.h"

namespace pinfield::test {

/// The table with up to `tries` numbers made params or expressions, neighbours made templates, and nodes given copies or twins. It reads.
std::string with_reuse(std::string table, CounterRng& rng, int tries = 8);

}  // namespace pinfield::test

// JSON Schema of the table format, for text editors that complete and check YAML.
#pragma once
#include <string>

#include "engine/reflect/catalog.h"

namespace pinfield {

/// Draft-07. Whatever the reader accepts is valid, but for the spellings only YAML has; what needs more than one value
/// to judge (contracts, references, ranges of numbers with a unit) is left to the reader.
std::string json_schema(const Catalog& catalog);

}  // namespace pinfield

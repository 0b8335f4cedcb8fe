// JSON Schema (draft-07) of the table format, generated from the catalogue, for editors that complete and check YAML.
#pragma once
#include <string>

#include "engine/reflect/catalogue.h"

namespace pinfield {

std::string json_schema(const Catalogue& catalogue);

}  // namespace pinfield

#include "tests/places.h"

namespace pinfield::test {

std::string source_dir() { return PINFIELD_SOURCE_DIR; }
std::string bin_dir() { return PINFIELD_BIN_DIR; }

}  // namespace pinfield::test

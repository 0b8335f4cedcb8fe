// Where the tests find the files they read and the executables they run. The only unit that knows: all others compile to the same
// object in any folder, so that a compiler cache serves a fresh clone.
#pragma once
#include <string>

namespace pinfield::test {

std::string source_dir();  ///< the project's top folder
std::string bin_dir();     ///< of the executables of this build

}  // namespace pinfield::test

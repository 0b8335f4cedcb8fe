// What a table file may cost: counted while reading, so that a hostile file is refused before it has cost more.
#pragma once
#include <cstddef>

namespace pinfield {

struct Limits {
    std::size_t file_bytes = 8 << 20;
    std::size_t depth = 64;          ///< of nested YAML maps and sequences, aliases expanded
    std::size_t events = 1'000'000;  ///< YAML nodes and keys, aliases expanded
    std::size_t scalar_bytes = 64 << 10;
    std::size_t nodes = 100'000;   ///< scene nodes, aliases expanded
    std::size_t points = 4096;     ///< of one polygon
    std::size_t repeats = 10'000;  ///< copies that one operation makes
    std::size_t errors = 500;      ///< after which reading gives up telling
};

}  // namespace pinfield

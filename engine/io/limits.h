// What a table file may cost: counted while reading, so that a hostile file is refused before it has cost more.
#pragma once
#include <cstddef>

namespace pinfield {

struct Limits {
    std::size_t file_bytes = 2 << 20;  ///< twice what the events take at the shipped tables' 7 to 10 bytes each
    std::size_t table_bytes = 32 << 20;  ///< of all files of a table; what is counted below is counted over all of them, too
    std::size_t includes = 64;           ///< files that a table names
    std::size_t depth = 64;            ///< of nested YAML maps and sequences, aliases expanded
    std::size_t events = 150'000;      ///< YAML nodes and keys, aliases expanded: 0.35 s of the parser (DECISIONS 13)
    std::size_t scalar_bytes = 64 << 10;
    std::size_t nodes = 30'000;    ///< scene nodes, aliases expanded: one with a single field is five events
    std::size_t points = 4096;     ///< of one polygon
    std::size_t repeats = 10'000;  ///< copies that one operation makes
    std::size_t params = 1000;     ///< of a table; arguments of a template
    std::size_t errors = 100;      ///< after which reading stops
    std::size_t events_before = 0;  ///< of the table's files that have been read already
};

}  // namespace pinfield

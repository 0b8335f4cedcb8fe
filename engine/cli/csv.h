// Comma-separated values as the commands read them: a header that must be as expected, then one record a line.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace pinfield::cli {

struct CsvRecord {
    int line = 0;  ///< 1-based, for messages
    std::vector<std::string> cells;
};

/// The records of a CSV file whose first line must be `header`. Blanks round a cell, CRLF, a byte-order mark and empty lines do
/// not count. Fails, naming file and line, on another header or another number of cells.
Result<std::vector<CsvRecord>> read_csv(const std::string& path, std::string_view header);

/// A cell as a number; fails naming file and line.
Result<double> csv_number(const std::string& path, const CsvRecord& record, std::size_t cell);

}  // namespace pinfield::cli

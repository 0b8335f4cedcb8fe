// Comma-separated values as the commands read them: a header that must be as expected, then one record a line.
#pragma once
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace pinfield::cli {

struct CsvRecord {
    int line = 0;  ///< 1-based, for messages
    std::vector<std::string> cells;
};

/// Reads a CSV file record by record: it may be a pipe, and as long as it likes, but for its lines. Blanks round a cell, CRLF, a byte-order
/// mark and empty lines do not count.
class CsvReader {
public:
    /// Fails, naming file and line, when the first line is not `header`.
    static Result<CsvReader> open(const std::string& path, std::string_view header);
    /// The next record, or false after the last. Fails, naming file and line, on another number of cells, a line that is longer than any
    /// record is, and 2^31 lines.
    Result<bool> next(CsvRecord& record);

private:
    CsvReader(const std::string& path, std::string_view header);
    /// The next line that has something in it; false at the end.
    Result<bool> next_line(std::string& content);

    std::string path_, header_;
    std::size_t columns_ = 0;
    std::ifstream file_;
    int line_ = 0;
};

/// A cell as a number; fails naming file and line.
Result<double> csv_number(const std::string& path, const CsvRecord& record, std::size_t cell);

}  // namespace pinfield::cli

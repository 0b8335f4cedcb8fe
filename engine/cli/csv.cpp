#include "engine/cli/csv.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "engine/core/numbers.h"

namespace pinfield::cli {
namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> split(std::string_view line) {
    std::vector<std::string> cells;
    for (std::size_t begin = 0;;) {
        const std::size_t comma = line.find(',', begin);
        cells.emplace_back(trimmed(line.substr(begin, comma == line.npos ? line.npos : comma - begin)));
        if (comma == line.npos) return cells;
        begin = comma + 1;
    }
}

}  // namespace

Result<std::vector<CsvRecord>> read_csv(const std::string& path, std::string_view header) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return failure(fmt::format("cannot read {}: {}", path, std::strerror(errno)));

    const std::vector<std::string> columns = split(header);
    std::vector<CsvRecord> records;
    std::string text;
    bool headed = false;
    for (int line = 1; std::getline(file, text); ++line) {
        std::string_view content = text;
        if (line == 1 && content.substr(0, 3) == "\xEF\xBB\xBF") content.remove_prefix(3);
        content = trimmed(content);
        if (content.empty()) continue;
        std::vector<std::string> cells = split(content);
        if (!headed) {
            if (cells != columns) return failure(fmt::format("{}:{}: the first line must be \"{}\"", path, line, header));
            headed = true;
        } else if (cells.size() != columns.size()) {
            return failure(fmt::format("{}:{}: {} values where {} are due: {}", path, line, cells.size(), columns.size(), header));
        } else {
            records.push_back({line, std::move(cells)});
        }
    }
    if (file.bad()) return failure(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
    if (!headed) return failure(fmt::format("{}:1: the first line must be \"{}\"", path, header));
    return records;
}

Result<double> csv_number(const std::string& path, const CsvRecord& record, std::size_t cell) {
    const std::string& text = record.cells[cell];
    if (const auto number = parse_number(text)) return *number;
    return failure(fmt::format("{}:{}: \"{}\" is not a number", path, record.line, text));
}

}  // namespace pinfield::cli

#include "engine/cli/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>

#include "engine/core/numbers.h"

namespace pinfield::cli {
namespace {

constexpr std::size_t longest_line = 4096;  // of three numbers: a few hundred at most

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

CsvReader::CsvReader(const std::string& path, std::string_view header)
    : path_(path), header_(header), columns_(split(header).size()), file_(path, std::ios::binary) {}

Result<CsvReader> CsvReader::open(const std::string& path, std::string_view header) {
    CsvReader reader(path, header);
    if (!reader.file_) return failure(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
    std::string first;
    const Result<bool> found = reader.next_line(first);
    if (!found) return tl::unexpected<Failure>(found.error());
    if (!*found || split(first) != split(header))
        return failure(fmt::format("{}:{}: the first line must be \"{}\"", path, std::max(1, reader.line_), header));
    return reader;
}

Result<bool> CsvReader::next_line(std::string& content) {
    char buffer[longest_line + 1];
    while (file_.getline(buffer, sizeof buffer)) {
        if (line_ == std::numeric_limits<int>::max()) return failure(fmt::format("cannot read {}: it does not end", path_));
        ++line_;
        const auto read = static_cast<std::size_t>(file_.gcount());  // the line break counts, unless the file ends without one
        std::string_view line(buffer, file_.eof() ? read : read - 1);
        if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
        content = trimmed(line);
        if (!content.empty()) return true;
    }
    if (file_.bad()) return failure(fmt::format("cannot read {}: {}", path_, std::strerror(errno)));
    if (!file_.eof()) return failure(fmt::format("{}:{}: the line is longer than {} bytes", path_, line_ + 1, longest_line));
    return false;
}

Result<bool> CsvReader::next(CsvRecord& record) {
    std::string content;
    Result<bool> found = next_line(content);
    if (!found || !*found) return found;
    record = {line_, split(content)};
    if (record.cells.size() != columns_)
        return failure(fmt::format("{}:{}: {} values where {} are due: {}", path_, line_, record.cells.size(), columns_, header_));
    return true;
}

Result<double> csv_number(const std::string& path, const CsvRecord& record, std::size_t cell) {
    const std::string& text = record.cells[cell];
    if (const auto number = parse_number(text)) return *number;
    return failure(fmt::format("{}:{}: \"{}\" is not a number", path, record.line, text));
}

}  // namespace pinfield::cli

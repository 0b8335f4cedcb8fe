#include "engine/core/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace pinfield {

namespace {

/// What is shown of a source line, and how many characters stand before the caret.
struct Excerpt {
    std::string text;
    int caret = 0;
};

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0u) != 0x80u; }

/// A whole line, or, of one that no terminal shows whole, what is about the column.
Excerpt excerpt_of(std::string_view line, int column) {
    constexpr int longest = 200, about = 60;  // characters: of a line shown whole, and to either side of the column
    std::vector<std::size_t> starts;  // of characters, in bytes
    for (std::size_t i = 0; i < line.size(); ++i)
        if (starts_character(line[i])) starts.push_back(i);
    const int count = static_cast<int>(starts.size());
    if (count <= longest) return {std::string(line), column - 1};
    const int first = std::clamp(column - 1 - about, 0, count), last = std::clamp(column - 1 + about, first, count);
    const auto byte = [&](int character) { return character < count ? starts[static_cast<std::size_t>(character)] : line.size(); };
    const std::string before = first > 0 ? "..." : "", after = last < count ? "..." : "";
    return {before + std::string(line.substr(byte(first), byte(last) - byte(first))) + after, column - 1 - first + static_cast<int>(before.size())};
}

}  // namespace

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string format(const Diagnostic& diagnostic, const SourceText& source) {
    const LineColumn at = source.place(diagnostic.where.begin);
    const char* severity = diagnostic.severity == Severity::error ? "error" : "warning";
    std::string out = fmt::format("{}:{}:{}: {}: {} [{}]\n", source.name(), at.line, at.column, severity,
                                  diagnostic.message, diagnostic.code);
    const Excerpt excerpt = excerpt_of(source.line(at.line), at.column);
    if (!excerpt.text.empty()) out += fmt::format("  {}\n  {}^\n", excerpt.text, std::string(static_cast<std::size_t>(excerpt.caret), ' '));
    if (!diagnostic.hint.empty()) out += fmt::format("  hint: {}\n", diagnostic.hint);
    return out;
}

}  // namespace pinfield

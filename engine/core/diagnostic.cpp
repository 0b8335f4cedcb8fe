#include "engine/core/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace pinfield {

namespace {

/// What is shown of a source line, and how many characters stand before the caret.
struct Excerpt {
    std::string text;
    int caret = 0;
};

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0u) != 0x80u; }

/// The byte `count` characters after (before) `at`, as far as the line goes.
std::size_t after(std::string_view line, std::size_t at, int count) {
    while (at < line.size() && count-- > 0) do
            ++at;
        while (at < line.size() && !starts_character(line[at]));
    return at;
}
std::size_t before(std::string_view line, std::size_t at, int count) {
    while (at > 0 && count-- > 0) do
            --at;
        while (at > 0 && !starts_character(line[at]));
    return at;
}

int characters(std::string_view text) {
    return static_cast<int>(std::count_if(text.begin(), text.end(), starts_character));
}

/// A whole line, or, of one that no terminal shows whole, what is about the byte `at`: only that is looked at, as a
/// hostile file has a line of megabytes and a hundred findings in it.
Excerpt excerpt_of(std::string_view line, std::size_t at, int column) {
    constexpr int longest = 200, about = 60;  // characters: of a line shown whole, and to either side of the place
    if (after(line, 0, longest) == line.size()) return {std::string(line), column - 1};
    const std::size_t first = before(line, at, about), last = after(line, at, about);
    const std::string left = first > 0 ? "..." : "", right = last < line.size() ? "..." : "";
    return {left + std::string(line.substr(first, last - first)) + right,
            static_cast<int>(left.size()) + characters(line.substr(first, at - first))};
}

}  // namespace

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string format(const Diagnostic& diagnostic, const Sources& sources) {
    const SourceText* source = sources.find(diagnostic.where);
    const char* severity = diagnostic.severity == Severity::error ? "error" : "warning";
    std::string out = fmt::format("{}: {} [{}]\n", severity, diagnostic.message, diagnostic.code);
    if (source) {
        const std::size_t offset = diagnostic.where.span.begin;
        const LineColumn at = source->line_column(offset);
        out = fmt::format("{}:{}:{}: {}", source->name(), at.line, at.column, out);
        const std::string_view line = source->line(at.line);
        const auto line_begin = static_cast<std::size_t>(line.data() - source->text().data());
        const std::size_t in_line = line.empty() ? 0 : std::min(offset - line_begin, line.size());
        const Excerpt excerpt = excerpt_of(line, in_line, at.column);
        if (!excerpt.text.empty())
            out += fmt::format("  {}\n  {}^\n", excerpt.text, std::string(static_cast<std::size_t>(excerpt.caret), ' '));
    }
    if (!diagnostic.hint.empty()) out += fmt::format("  hint: {}\n", diagnostic.hint);
    return out;
}

}  // namespace pinfield

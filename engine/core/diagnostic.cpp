#include "engine/core/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "engine/core/shown.h"

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
/// hostile file has a line of megabytes and a hundred findings in it. What stands before the caret is counted as it is shown.
Excerpt excerpt_of(std::string_view line, std::size_t at) {
    constexpr int longest = 200, about = 60;  // characters: of a line shown whole, and to either side of the place
    const bool whole = after(line, 0, longest) == line.size();
    const std::size_t first = whole ? 0 : before(line, at, about), last = whole ? line.size() : after(line, at, about);
    const std::string left = (first > 0 ? "..." : "") + shown(line.substr(first, at - first));
    return {left + shown(line.substr(at, last - at)) + (last < line.size() ? "..." : ""), characters(left)};
}

/// A file's first line without the mark that says it is UTF-8: columns do not count it, either.
std::string_view without_mark(std::string_view line) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return line.starts_with(mark) ? line.substr(mark.size()) : line;
}

}  // namespace

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::vector<Via> way_to(const Diagnostic& diagnostic, const Sources& sources) {
    std::vector<Via> out;
    const auto tell_files = [&](FileId file) {
        while (const auto* here = sources.inclusion(file)) {
            out.push_back({fmt::format("the file {}", here->path), here->asked_at, "included"});
            file = here->asked_at.file;
        }
    };
    FileId file = diagnostic.where.file;
    tell_files(file);
    for (const Via& step : diagnostic.via) {
        out.push_back(step);
        if (step.where.file != file) tell_files(file = step.where.file);
    }
    return out;
}

std::string format(const Diagnostic& diagnostic, const Sources& sources) {
    const SourceText* source = sources.find(diagnostic.where);
    const char* severity = diagnostic.severity == Severity::error ? "error" : "warning";
    std::string out = fmt::format("{}: {} [{}]\n", severity, shown(diagnostic.message), shown(diagnostic.code));
    if (source) {
        const std::size_t offset = diagnostic.where.span.begin;
        const LineColumn at = source->line_column(offset);
        out = fmt::format("{}:{}:{}: {}", shown(source->name()), at.line, at.column, out);
        const std::string_view line = at.line == 1 ? without_mark(source->line(1)) : source->line(at.line);
        const auto line_begin = static_cast<std::size_t>(line.data() - source->text().data());
        const std::size_t in_line = line.empty() || offset < line_begin ? 0 : std::min(offset - line_begin, line.size());
        const Excerpt excerpt = excerpt_of(line, in_line);
        if (!excerpt.text.empty())
            out += fmt::format("  {}\n  {}^\n", excerpt.text, std::string(static_cast<std::size_t>(excerpt.caret), ' '));
    }
    for (const Via& step : way_to(diagnostic, sources)) {
        const LineColumn asked = sources.line_column(step.where);
        const SourceText* in = sources.find(step.where);
        out += fmt::format("  in {}, {} at {}:{}:{}\n", shown(step.what), step.how, shown(in ? in->name() : ""), asked.line, asked.column);
    }
    if (!diagnostic.hint.empty()) out += fmt::format("  hint: {}\n", shown(diagnostic.hint));
    return out;
}

}  // namespace pinfield

#include "engine/core/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

namespace pinfield {

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string format(const Diagnostic& diagnostic, const SourceText& source) {
    const LineColumn at = source.place(diagnostic.where.begin);
    const char* severity = diagnostic.severity == Severity::error ? "error" : "warning";
    std::string out = fmt::format("{}:{}:{}: {}: {} [{}]\n", source.name(), at.line, at.column, severity,
                                  diagnostic.message, diagnostic.code);
    // A line that a person would not read (a scalar of 64 KiB) says nothing with a caret under it.
    const std::string_view line = source.line(at.line);
    if (!line.empty() && line.size() <= 400) {
        std::string caret;
        for (int i = 1; i < at.column; ++i) caret += ' ';
        out += fmt::format("  {}\n  {}^\n", line, caret);
    }
    if (!diagnostic.hint.empty()) out += fmt::format("  hint: {}\n", diagnostic.hint);
    return out;
}

}  // namespace pinfield

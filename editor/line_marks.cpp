#include "editor/line_marks.h"

#include <limits>

#include "editor/line_diff.h"

namespace pinfield::editor {

LineMarks line_marks(std::string_view before, std::string_view after) {
    if (before == after) return {};
    const LineDiff diff = line_diff(before, after, std::numeric_limits<int>::max());
    LineMarks marks{{}, diff.added, diff.removed};
    int next = 1;  // line of the later text
    const auto mark = [&]() -> LineMark& {
        if (marks.lines.empty() || marks.lines.back().line != next) marks.lines.push_back({next});
        return marks.lines.back();
    };
    for (const DiffLine& line : diff.lines) {
        if (line.kind == DiffLine::Kind::removed) {
            mark().removed += line.text + "\n";
            continue;
        }
        next = line.number;
        if (line.kind == DiffLine::Kind::added) mark().added = true;
        ++next;
    }
    return marks;
}

}  // namespace pinfield::editor

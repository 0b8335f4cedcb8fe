// What a margin can say of lines that changed: which are new, and what went before them.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pinfield::editor {

struct LineMark {
    int line = 0;           ///< of the later text, from 1; one more than it has for what went from its end
    bool added = false;     ///< the line is new, or other than it was
    std::string removed{};  ///< lines of the earlier text that stood before it, each with a line break

    bool operator==(const LineMark&) const = default;
};

struct LineMarks {
    std::vector<LineMark> lines{};  ///< in order
    int added = 0, removed = 0;     ///< lines, in all
};

LineMarks line_marks(std::string_view before, std::string_view after);

}  // namespace pinfield::editor

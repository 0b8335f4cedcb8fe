// What differs between two texts, line by line, for people to read.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pinfield::editor {

/// A line of a unified diff. Hunks are apart where the numbers of the lines are.
struct DiffLine {
    enum class Kind : unsigned char { kept, removed, added };
    Kind kind = Kind::kept;
    int number = 0;  ///< 1-based: in the new text; of a removed line, in the old one
    std::string text{};
    bool begins_hunk = false;

    bool operator==(const DiffLine&) const = default;
};

struct LineDiff {
    std::vector<DiffLine> lines;  ///< at most as many as asked for
    int removed = 0, added = 0;   ///< in all
    int left_out = 0;             ///< removed and added ones that are not in `lines`
};

/// By the longest common subsequence of lines (texts that differ in more than 4 million pairs of lines are not compared but shown as
/// exchanged), with `context` lines about each change.
LineDiff line_diff(std::string_view before, std::string_view after, int most_lines, int context = 1);

}  // namespace pinfield::editor

#include "editor/line_diff.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

using Lines = std::vector<std::string_view>;
constexpr std::size_t most_pairs = 4'000'000;

Lines lines_of(std::string_view text) {
    Lines lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        lines.push_back(line);
    }
    return lines;
}

/// The lines of both texts in the order of a unified diff.
class Comparison {
public:
    Comparison(std::string_view before, std::string_view after) : a_(lines_of(before)), b_(lines_of(after)) {
        std::size_t head = 0, tail = 0;
        const std::size_t shorter = std::min(a_.size(), b_.size());
        while (head < shorter && a_[head] == b_[head]) ++head;
        while (tail < shorter - head && a_[a_.size() - 1 - tail] == b_[b_.size() - 1 - tail]) ++tail;
        for (std::size_t i = 0; i < head; ++i) keep(i, i);
        compare(head, a_.size() - tail, head, b_.size() - tail);
        for (std::size_t i = tail; i > 0; --i) keep(a_.size() - i, b_.size() - i);
    }
    const std::vector<DiffLine>& lines() const { return lines_; }

private:
    void keep(std::size_t, std::size_t j) { lines_.push_back({DiffLine::Kind::kept, static_cast<int>(j + 1), std::string(b_[j])}); }
    void remove(std::size_t i) { lines_.push_back({DiffLine::Kind::removed, static_cast<int>(i + 1), std::string(a_[i])}); }
    void add(std::size_t j) { lines_.push_back({DiffLine::Kind::added, static_cast<int>(j + 1), std::string(b_[j])}); }

    /// Half-open ranges of lines of either text. common[i][j]: the longest common subsequence of what is left from i and j on.
    void compare(std::size_t i, std::size_t end_i, std::size_t j, std::size_t end_j) {
        const std::size_t rows = end_i - i, columns = end_j - j, begin_i = i, begin_j = j;
        const bool small = rows == 0 || columns == 0 || rows <= most_pairs / columns;
        std::vector<std::uint32_t> common(small ? (rows + 1) * (columns + 1) : 0);
        const auto length = [&](std::size_t r, std::size_t c) -> std::uint32_t& { return common[r * (columns + 1) + c]; };
        if (small)
            for (std::size_t r = rows; r-- > 0;)
                for (std::size_t c = columns; c-- > 0;)
                    length(r, c) = a_[i + r] == b_[j + c] ? length(r + 1, c + 1) + 1 : std::max(length(r + 1, c), length(r, c + 1));
        while (small && i < end_i && j < end_j) {
            if (a_[i] == b_[j]) keep(i++, j++);
            else if (length(i + 1 - begin_i, j - begin_j) >= length(i - begin_i, j + 1 - begin_j)) remove(i++);
            else add(j++);
        }
        while (i < end_i) remove(i++);
        while (j < end_j) add(j++);
    }

    Lines a_, b_;
    std::vector<DiffLine> lines_;
};

}  // namespace

LineDiff line_diff(std::string_view before, std::string_view after, int most_lines, int context) {
    const Comparison comparison(before, after);
    const std::vector<DiffLine>& all = comparison.lines();
    const int count = static_cast<int>(all.size());
    std::vector<bool> shown(all.size(), false);
    LineDiff diff;
    for (int i = 0; i < count; ++i) {
        const DiffLine::Kind kind = at(all, i).kind;
        if (kind == DiffLine::Kind::kept) continue;
        ++(kind == DiffLine::Kind::added ? diff.added : diff.removed);
        for (int k = std::max(i - context, 0); k <= std::min(i + context, count - 1); ++k) shown[static_cast<std::size_t>(k)] = true;
    }
    for (int i = 0; i < count; ++i) {
        if (!shown[static_cast<std::size_t>(i)]) continue;
        if (static_cast<int>(diff.lines.size()) < most_lines) {
            diff.lines.push_back(at(all, i));
            diff.lines.back().begins_hunk = i == 0 || !shown[static_cast<std::size_t>(i) - 1];
        } else if (at(all, i).kind != DiffLine::Kind::kept) ++diff.left_out;
    }
    return diff;
}

}  // namespace pinfield::editor

#include "engine/io/merge_lines.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/core/common_sequence.h"

namespace pinfield {
namespace {

using Lines = std::vector<std::string_view>;

/// With their breaks.
Lines lines_of(std::string_view text) {
    Lines out;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        out.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return out;
}

/// Lines of the base that a side has otherwise; none: it has put some in before `begin`.
struct Change {
    std::size_t begin = 0, end = 0;
    Lines lines;
};

Lines part(const Lines& lines, std::size_t begin, std::size_t end) {
    return {lines.begin() + static_cast<std::ptrdiff_t>(begin), lines.begin() + static_cast<std::ptrdiff_t>(end)};
}

std::vector<Change> changes(const Lines& base, const Lines& side) {
    auto pairs = common_sequence(base.size(), side.size(), [&](std::size_t a, std::size_t b) { return base[a] == side[b]; });
    pairs.emplace_back(base.size(), side.size());
    std::vector<Change> out;
    std::size_t i = 0, j = 0;
    for (const auto& [to_i, to_j] : pairs) {
        if (i < to_i || j < to_j) out.push_back({i, to_i, part(side, j, to_j)});
        i = to_i + 1;
        j = to_j + 1;
    }
    return out;
}

bool meet(const Change& a, const Change& b) {
    if (a.begin == a.end && b.begin == b.end) return a.begin == b.begin;
    return a.begin < b.end && b.begin < a.end;
}

/// Both changes of the same lines: one by one where each side has as many as there were, else theirs.
Change one_of(const Lines& base, const Change& mine, Change theirs) {
    const bool one_by_one = mine.begin == theirs.begin && mine.end == theirs.end && mine.lines.size() == theirs.lines.size() &&
                            mine.lines.size() == mine.end - mine.begin;
    for (std::size_t i = 0; one_by_one && i < theirs.lines.size(); ++i)
        if (theirs.lines[i] == base[theirs.begin + i]) theirs.lines[i] = mine.lines[i];
    return theirs;
}

}  // namespace

std::string merge_lines(std::string_view base, std::string_view mine, std::string_view theirs) {
    const Lines lines = lines_of(base);
    const std::vector<Change> others = changes(lines, lines_of(theirs));
    std::vector<Change> all;
    std::vector<bool> met(others.size(), false);
    for (const Change& own : changes(lines, lines_of(mine))) {
        bool alone = true;
        for (std::size_t i = 0; i < others.size(); ++i)
            if (meet(own, others[i])) alone = false, all.push_back(one_of(lines, own, others[i])), met[i] = true;
        if (alone) all.push_back(own);
    }
    for (std::size_t i = 0; i < others.size(); ++i)
        if (!met[i]) all.push_back(others[i]);
    std::stable_sort(all.begin(), all.end(),
                     [](const Change& a, const Change& b) { return std::pair(a.begin, a.end) < std::pair(b.begin, b.end); });
    std::string out;
    std::size_t next = 0;
    for (const Change& change : all) {
        if (change.begin < next) continue;  // theirs, which several of mine have met
        for (; next < change.begin; ++next) out += lines[next];
        for (const std::string_view line : change.lines) out += line;
        next = change.end;
    }
    for (; next < lines.size(); ++next) out += lines[next];
    return out;
}

}  // namespace pinfield

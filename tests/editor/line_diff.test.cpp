#include "editor/line_diff.h"

#include <catch2/catch.hpp>

using namespace pinfield::editor;

namespace {

/// "-2 old" for a removed line, "+3 new" for an added, " 1 both" for a kept one; "@" before a hunk.
std::string written(const LineDiff& diff) {
    std::string text;
    for (const DiffLine& line : diff.lines) {
        if (line.begins_hunk) text += "@\n";
        text += " -+"[static_cast<int>(line.kind)];
        text += std::to_string(line.number) + " " + line.text + "\n";
    }
    return text;
}

}  // namespace

TEST_CASE("a changed line is shown between its neighbours, with its number in either text") {
    const LineDiff diff = line_diff("a\nb\nc\nd\ne\n", "a\nb\nC\nd\ne\n", 20);
    CHECK(written(diff) == "@\n 2 b\n-3 c\n+3 C\n 4 d\n");
    CHECK(diff.added == 1);
    CHECK(diff.removed == 1);
    CHECK(diff.left_out == 0);
}

TEST_CASE("changes that are far apart are hunks of their own, and lines that moved along are no changes") {
    const LineDiff diff = line_diff("a\nb\nc\nd\ne\nf\n", "0\na\nb\nc\nd\ne\n", 20);
    CHECK(written(diff) == "@\n+1 0\n 2 a\n@\n 6 e\n-6 f\n");
}

TEST_CASE("equal texts have no difference, and an empty one is added or removed whole") {
    CHECK(line_diff("a\nb\n", "a\nb\n", 20).lines.empty());
    CHECK(line_diff("", "", 20).lines.empty());
    CHECK(written(line_diff("", "a\nb", 20)) == "@\n+1 a\n+2 b\n");
    CHECK(written(line_diff("a\nb", "", 20)) == "@\n-1 a\n-2 b\n");
}

TEST_CASE("no more lines are shown than asked for, and the changes left out are counted") {
    const LineDiff diff = line_diff("a\n", "a\n1\n2\n3\n4\n", 3);
    CHECK(written(diff) == "@\n 1 a\n+2 1\n+3 2\n");
    CHECK(diff.added == 4);
    CHECK(diff.left_out == 2);
}

TEST_CASE("texts too long to compare line by line are shown as exchanged") {
    std::string before, after;
    for (int i = 0; i < 3000; ++i) {
        before += "a" + std::to_string(i) + "\n";
        after += "b" + std::to_string(i) + "\n";
    }
    const LineDiff diff = line_diff("head\n" + before, "head\n" + after, 20);
    CHECK(diff.removed == 3000);
    CHECK(diff.added == 3000);
    CHECK(diff.lines.size() == 20);
    CHECK(diff.left_out == 6000 - 19);
}

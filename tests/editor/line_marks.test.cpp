#include "editor/line_marks.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

using namespace pinfield::editor;

namespace {

using Marks = std::vector<LineMark>;

/// The later text without its new lines and with what had gone.
std::string undone(const std::string& after, const LineMarks& marks) {
    std::string out;
    int number = 1;
    std::size_t next = 0;
    const auto mark = [&]() -> const LineMark* { return next < marks.lines.size() && marks.lines[next].line == number ? &marks.lines[next++] : nullptr; };
    for (std::size_t at = 0; at < after.size(); ++number) {
        const std::size_t end = after.find('\n', at) + 1;
        const LineMark* here = mark();
        if (here) out += here->removed;
        if (!here || !here->added) out += after.substr(at, end - at);
        at = end;
    }
    if (const LineMark* here = mark()) out += here->removed;
    return out;
}

}  // namespace

TEST_CASE("a changed line is new and has an old one before it; what only went leaves its mark on the next line") {
    CHECK(line_marks("a\nb\nc\n", "a\nx\nc\n").lines == Marks{{2, true, "b\n"}});
    CHECK(line_marks("a\nb\nc\n", "a\nc\n").lines == Marks{{2, false, "b\n"}});
    CHECK(line_marks("a\nc\n", "a\nb\nc\n").lines == Marks{{2, true, ""}});
    CHECK(line_marks("a\nb\n", "a\n").lines == Marks{{2, false, "b\n"}});
    CHECK(line_marks("a\nb\n", "b\n").lines == Marks{{1, false, "a\n"}});
    CHECK(line_marks("a\n", "a\n").lines.empty());
    const LineMarks marks = line_marks("1\n2\n3\n4\n5\n6\n7\n8\n", "1\nx\n3\n4\n5\n6\ny\nz\n8\n");
    CHECK(marks.lines == Marks{{2, true, "2\n"}, {7, true, "7\n"}, {8, true, ""}});
    CHECK(marks.added == 3);
    CHECK(marks.removed == 2);
}

TEST_CASE("marks say all there is to say: the earlier text comes back from them") {
    const auto lines = rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(std::vector<std::string>{"a\n", "b\n", "c\n", "\n"}));
    CHECK(rc::check("line marks", [&] {
        std::string before, after;
        for (const std::string& line : *lines) before += line;
        for (const std::string& line : *lines) after += line;
        RC_ASSERT(undone(after, line_marks(before, after)) == before);
    }));
}

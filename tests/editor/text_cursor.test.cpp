#include "editor/text_cursor.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

using namespace pinfield;
using namespace pinfield::editor;

namespace {

/// A text in which | is the caret and ^ the anchor where they differ.
struct Marked {
    std::string text;
    TextCursor cursor;
};
Marked marked(const std::string& drawn) {
    Marked out;
    bool anchored = false;
    for (const char c : drawn) {
        if (c == '|') out.cursor.caret = out.text.size();
        else if (c == '^') out.cursor.anchor = out.text.size(), anchored = true;
        else out.text += c;
    }
    if (!anchored) out.cursor.anchor = out.cursor.caret;
    return out;
}
std::string drawn(std::string text, const TextCursor& cursor) {
    const bool first = cursor.caret > cursor.anchor;  // the later one first, so that the other's place stays
    if (first) text.insert(cursor.caret, "|");
    if (cursor.selects()) text.insert(cursor.anchor, "^");
    if (!first) text.insert(cursor.caret, "|");
    return text;
}
std::string after(const std::string& before, Motion motion, bool selecting = false, int page = 1) {
    const Marked m = marked(before);
    return drawn(m.text, moved(m.text, m.cursor, motion, selecting, page));
}
std::string with(const std::string& text, const Splice& splice) { return drawn(spliced(text, splice), cursor_at(splice.end())); }

}  // namespace

TEST_CASE("arrows go by characters, whatever bytes these are made of") {
    CHECK(after("a|\xC3\xA4" "b", Motion::right) == "a\xC3\xA4|b");
    CHECK(after("a\xE2\x86\x92|b", Motion::left) == "a|\xE2\x86\x92" "b");
    CHECK(after("a|\r\nb", Motion::right) == "a\r\n|b");
    CHECK(after("a\r\n|b", Motion::left) == "a|\r\nb");
    CHECK(after("\xEF\xBB\xBF|a", Motion::left) == "\xEF\xBB\xBF|a");
    CHECK(after("ab|", Motion::right) == "ab|");
    CHECK(after("a|bc", Motion::right, true) == "a^b|c");
    CHECK(after("a^bc|d", Motion::left) == "a|bcd");
    CHECK(after("a^bc|d", Motion::right) == "abc|d");
}

TEST_CASE("up and down keep to their column over shorter lines") {
    const Marked m = marked("abc\xC3\xA4" "d|e\r\nx\r\nabcdef");
    const TextCursor short_line = moved(m.text, m.cursor, Motion::down, false);
    CHECK(drawn(m.text, short_line) == "abc\xC3\xA4" "de\r\nx|\r\nabcdef");
    CHECK(drawn(m.text, moved(m.text, short_line, Motion::down, false)) == "abc\xC3\xA4" "de\r\nx\r\nabcde|f");
    CHECK(after("a\nb|c", Motion::up) == "a|\nbc");
    CHECK(after("a|b\nc", Motion::up) == "|ab\nc");
    CHECK(after("ab\nc|d", Motion::down) == "ab\ncd|");
    CHECK(after("1\n2\n3\n4|\n5", Motion::page_up, false, 3) == "1|\n2\n3\n4\n5");
}

TEST_CASE("the start of a line is first that of its words, and Ctrl goes by words") {
    CHECK(after("  ab|c", Motion::line_start) == "  |abc");
    CHECK(after("  |abc", Motion::line_start) == "|  abc");
    CHECK(after("a|bc\r\nd", Motion::line_end) == "abc|\r\nd");
    CHECK(after("|at: [0.3, 40mm]", Motion::word_right) == "at|: [0.3, 40mm]");
    CHECK(after("at: [0.3, 40mm|]", Motion::word_left) == "at: [0.3, |40mm]");
    CHECK(after("a|b", Motion::text_end) == "ab|");
    CHECK(after("\xEF\xBB\xBF" "ab|", Motion::text_start) == "\xEF\xBB\xBF|ab");
    const std::string text = "x: {id: pop_left, a: 1}";
    CHECK(drawn(text, word_at(text, 11)) == "x: {id: ^pop_left|, a: 1}");
}

TEST_CASE("new lines are spelled as the text spells them, and begin where the line began") {
    Marked m = marked("a: 1\r\n  b: 2|\r\n");
    CHECK(with(m.text, new_line(m.text, m.cursor)) == "a: 1\r\n  b: 2\r\n  |\r\n");
    CHECK(with(m.text, typed(m.text, m.cursor, "x\ny\r\nz")) == "a: 1\r\n  b: 2x\r\ny\r\nz|\r\n");
    m = marked("scene:\n  - union:|");
    CHECK(with(m.text, new_line(m.text, m.cursor)) == "scene:\n  - union:\n      |");
    m = marked("scene:|");
    CHECK(with(m.text, new_line(m.text, m.cursor)) == "scene:\n  |");
    m = marked("  |- a");
    CHECK(with(m.text, new_line(m.text, m.cursor)) == "  \n  |- a");
}

TEST_CASE("what is selected is erased or replaced, else a character or a word") {
    Marked m = marked("ab^cd|ef");
    CHECK(with(m.text, erased(m.text, m.cursor, Motion::left)) == "ab|ef");
    CHECK(with(m.text, typed(m.text, m.cursor, "x")) == "abx|ef");
    m = marked("a\r\n|b");
    CHECK(with(m.text, erased(m.text, m.cursor, Motion::left)) == "a|b");
    m = marked("one two|");
    CHECK(with(m.text, erased(m.text, m.cursor, Motion::word_left)) == "one |");
}

TEST_CASE("Tab indents the lines that are selected, or goes to the next even column") {
    Marked m = marked("abc|");
    CHECK(with(m.text, indented(m.text, m.cursor, false)) == "abc |");
    m = marked("a\n b^c\r\n\r\nd|e\nf");
    CHECK(spliced(m.text, indented(m.text, m.cursor, false)) == "a\n   bc\r\n\r\n  de\nf");
    CHECK(spliced(m.text, indented(m.text, m.cursor, true)) == "a\nbc\r\n\r\nde\nf");
    m = marked("   a|");
    CHECK(spliced(m.text, indented(m.text, m.cursor, true)) == " a");
    m = marked("^a\n|b");
    CHECK(spliced(m.text, indented(m.text, m.cursor, false)) == "  a\nb");
}

TEST_CASE("a difference makes one text of the other, its inverse takes it back, and places are carried along") {
    CHECK(difference("radius: 40mm", "radius: 45mm") == Splice{{9, 10}, "5"});
    CHECK(difference("aa", "aaa") == Splice{{2, 2}, "a"});
    CHECK(carried(3, {{5, 7}, "x"}) == 3);
    CHECK(carried(7, {{5, 7}, "x"}) == 6);
    CHECK(carried(6, {{5, 7}, "x"}) == 6);
    const auto text = rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab\n")));
    CHECK(rc::check("difference", [&] {
        const std::string a = *text, b = *text;
        const Splice splice = difference(a, b);
        RC_ASSERT(spliced(a, splice) == b);
        RC_ASSERT(spliced(b, inverse(a, splice)) == a);
    }));
}

TEST_CASE("no key leads into the middle of a character or out of the text") {
    const auto text = rc::gen::container<std::vector<std::string>>(
        rc::gen::elementOf(std::vector<std::string>{"a", " ", "\n", "\r\n", "\xC3\xA4", "\xE2\x86\x92", ":", "- "}));
    CHECK(rc::check("motions", [&] {
        std::string whole;
        for (const std::string& piece : *text) whole += piece;
        TextCursor cursor = cursor_at(snapped(whole, *rc::gen::inRange<std::size_t>(0, whole.size() + 1)));
        for (int i = 0; i < 8; ++i) {
            const auto motion = static_cast<Motion>(*rc::gen::inRange(0, 12));
            cursor = moved(whole, cursor, motion, *rc::gen::arbitrary<bool>(), 3);
            RC_ASSERT(cursor.caret <= whole.size());
            RC_ASSERT(snapped(whole, cursor.caret) == cursor.caret);
        }
        RC_ASSERT(word_at(whole, cursor.caret).anchor <= word_at(whole, cursor.caret).caret);
    }));
}

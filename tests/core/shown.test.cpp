#include "engine/core/shown.h"

#include <catch2/catch.hpp>
#include <string>

#include "engine/core/diagnostic.h"
#include "engine/core/rng.h"

using namespace pinfield;

namespace {

/// What a terminal might obey, told without any of the code under test: bytes below 32 and 127, and U+0080 to U+009F as UTF-8.
bool is_harmless(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 'x');
        if (c < 0x20 || c == 0x7f || (c == 0xc2 && next < 0xa0)) return false;
        for (const char* turning : {"\u061c", "\u200e", "\u200f", "\u202a", "\u202b", "\u202c", "\u202d", "\u202e", "\u2066", "\u2067", "\u2068",
                                    "\u2069", "\u2028", "\u2029", "\ufeff", "\U000e0041"})
            if (text.compare(i, std::char_traits<char>::length(turning), turning) == 0) return false;
    }
    for (std::size_t i = 0; i < text.size(); i += utf8_length(text, i))
        if (utf8_length(text, i) == 0) return false;
    return true;
}

}  // namespace

TEST_CASE("whatever the bytes, what is shown of them is harmless UTF-8 on one line, and what is harmless stays as it is") {
    CounterRng rng(7);
    for (int round = 0; round < 20'000; ++round) {
        std::string text;
        const auto length = rng.next_u64() % 12;
        for (std::uint64_t i = 0; i < length; ++i) {
            const auto bits = rng.next_u64();
            constexpr unsigned char likely[] = {0xe2, 0x80, 0xae, 0xc2, 0x9b, 0x1b, 0xf3, 0xa0, 0x81, 0xef, 0xbb, 0xbf};
            text += static_cast<char>(bits % 2 ? likely[bits / 2 % sizeof likely] : bits / 2 % 256);
        }
        const std::string out = shown(text);
        INFO(out);
        REQUIRE(is_harmless(out));
        REQUIRE(shown(out) == out);
        if (is_harmless(text)) REQUIRE(out == text);
    }
}

TEST_CASE("controls, turning characters and broken bytes are named") {
    CHECK(shown("a\x1b[31m\a\n\t\r\x7f") == "a\\x1b[31m\\x07\\n\\t\\r\\x7f");
    CHECK(shown("\u0085\u009b\u202e\U000e0041\ufeff") == "\\x85\\x9b\\u202e\\ue0041\\ufeff");
    CHECK(shown("\xff\xc0\x80\xed\xa0\x80") == "\\xff\\xc0\\x80\\xed\\xa0\\x80");
    CHECK(shown(std::string_view("a\0b", 3)) == "a\\x00b");
    CHECK(shown("Bällchen \u65e5\u672c \u05d0\u05d1 \\n") == "Bällchen \u65e5\u672c \u05d0\u05d1 \\n");
    CHECK(shown_lines("a\n\x1b\r\n") == "a\n\\x1b\\r\n");
}

TEST_CASE("a diagnostic shows nothing of a file or its name raw, and its caret stands under what is meant") {
    for (const std::string before : {"", "\xEF\xBB\xBF", "\x1b[2Jab\t", "\u202e\u202e", "\xff\xfe", "ä\u009b"}) {
        const std::string line = before + "@rest\a";
        const Sources sources(SourceText("n\n\x1b.yaml", line + "\nmore\n"));
        const std::string text = format({"E0000", Severity::error, "bad \x1b name", sources.main().place({before.size(), before.size() + 1}), "no\x9b"}, sources);
        INFO(text);
        const std::size_t second = text.find('\n') + 1, third = text.find('\n', second) + 1;
        CHECK(text.starts_with("n\\n\\x1b.yaml:1:"));
        CHECK(text.ends_with("  hint: no\\x9b\n"));
        CHECK(is_harmless(text.substr(0, second - 1)));
        const std::string shown_line = text.substr(second, third - 1 - second);
        CHECK(is_harmless(shown_line));
        int column = 0;  // in characters, up to the @
        for (std::size_t i = 0; shown_line[i] != '@'; i += utf8_length(shown_line, i)) ++column;
        CHECK(text.find('^', third) - third == static_cast<std::size_t>(column));
    }
}

#include "editor/yaml_highlight.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "engine/io/files.h"
#include "tests/places.h"

using namespace pinfield;
using namespace pinfield::editor;

namespace {

/// Every piece with the initial of what it is: "k:radius n:24mm".
std::string spelled(const std::string& text) {
    static constexpr std::string_view letters = "#SktqnwKa.";
    std::string out;
    for (const Token& token : highlight_yaml(text)) {
        if (token.kind == TokenKind::mark) continue;
        if (!out.empty()) out += ' ';
        out += letters[static_cast<std::size_t>(token.kind)];
        out += ':' + text.substr(token.span.begin, token.span.end - token.span.begin);
    }
    return out;
}

/// What is wrong with the pieces of a text: overlaps, blanks at their ends, bytes in none of them.
std::string fault_of(const std::string& text) {
    std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    const auto all_blank = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i)
            if (!blank(text[i])) return false;
        return true;
    };
    for (const Token& token : highlight_yaml(text)) {
        if (token.span.begin < at || token.span.end <= token.span.begin || token.span.end > text.size()) return "at " + std::to_string(at);
        if (!all_blank(at, token.span.begin)) return "left out after " + std::to_string(at);
        at = token.span.end;
    }
    return all_blank(at, text.size()) ? "" : "left out at the end";
}

}  // namespace

TEST_CASE("keys, types, numbers with units, words and comments of a table are told apart") {
    CHECK(spelled("pinfield: 1          # the format\n") == "S:pinfield n:1 #:# the format");
    CHECK(spelled("scene:\n  - circle: {id: a, at: [0.3, 300mm], radius: 40mm, visible: false}   # first\n") ==
          "S:scene t:circle k:id w:a k:at n:0.3 n:300mm k:radius n:40mm k:visible K:false #:# first");
    CHECK(spelled("  - union:\n      id: both\n      children: [box: {size: [1, 2]}, circle: {}]") ==
          "t:union k:id w:both k:children t:box k:size n:1 n:2 t:circle");
    CHECK(spelled("a: 1mm b\nb: 2.5e-3\nc: 12 apples\nd: -3deg\ne: 4furlong") == "S:a w:1mm b S:b n:2.5e-3 S:c w:12 apples S:d n:-3deg S:e w:4furlong");
}

TEST_CASE("quotes, anchors, blocks of text and hashes within words are what YAML makes of them") {
    CHECK(spelled("a: {color: \"#31435e\", b: 'it''s # no comment'} # but this") ==
          "S:a k:color q:\"#31435e\" k:b q:'it''s # no comment' #:# but this");
    CHECK(spelled("- &post box: {size: *size}\n- !tag x") == "a:&post t:box k:size a:*size a:!tag w:x");
    CHECK(spelled("a: C#sharp:er\n\"b\": 1") == "S:a w:C#sharp:er S:\"b\" n:1");
    CHECK(spelled("a:\n  text: |  # kept\n    one: two\n\n    # no comment\n  next: 3") == "S:a k:text #:# kept q:one: two q:# no comment k:next n:3");
}

TEST_CASE("what is left open while it is typed ends at the margin at the latest") {
    CHECK(spelled("a: [1, {b: 2\nscene:\n  - box: {}") == "S:a n:1 k:b n:2 S:scene t:box");
    CHECK(spelled("a: \"open\n  more\nscene: 1\nb: \"x\"") == "S:a q:\"open w:more S:scene n:1 S:b q:\"x\"");
    CHECK(spelled("]}, a: 1") == "S:]}, a n:1");
}

TEST_CASE("every byte that is no blank is in exactly one piece, of every table there is and of every beginning of one") {
    int tables = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(std::filesystem::path(test::source_dir()) / "scenes")) {
        if (entry.path().extension() != ".yaml") continue;
        ++tables;
        INFO(entry.path());
        CHECK(fault_of(*read_file(entry.path().string())) == "");
    }
    CHECK(tables > 100);
    const std::string text = *read_file((std::filesystem::path(test::source_dir()) / "scenes/tables/first_table.yaml").string());
    std::string faults;
    for (std::size_t length = 0; length < 3000; ++length)
        if (const std::string fault = fault_of(text.substr(0, length)); !fault.empty()) faults += std::to_string(length) + ": " + fault + "\n";
    CHECK(faults.empty());
}

TEST_CASE("line breaks of two bytes and a byte order mark are in no piece") {
    CHECK(fault_of("\xEF\xBB\xBF" "a: 1 # x\r\nb: |\r\n  text\r\nc: \"q\"\r\n").empty());
    CHECK(spelled("\xEF\xBB\xBF" "a: 1 # x\r\nb: |\r\n  text\r\nc: \"q\"\r\n") == "S:a n:1 #:# x S:b q:text S:c q:\"q\"");
}

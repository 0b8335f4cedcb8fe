#include "engine/io/yaml_tree.h"

#include <catch2/catch.hpp>

using namespace pinfield;

namespace {

struct Read {
    SourceText source;
    YamlTree tree;
    explicit Read(const std::string& text) : source("t", text), tree(read_yaml(source)) {}
    std::string_view slice(const YamlNode& node) const { return source.slice(node.span); }
    const YamlNode& at(std::string_view key) const {
        const YamlNode* found = tree.root ? tree.root->find(key) : nullptr;
        REQUIRE(found);
        return *found;
    }
    std::string code() const { return tree.diagnostics.empty() ? "" : tree.diagnostics.front().code; }
};

}  // namespace

TEST_CASE("a span holds exactly the bytes of the value as written") {
    const std::string body =
        "a: 24mm  # c\nb: \"x \\\" y\" \nc: 'it''s' # d\nd: {x: 1, y: [2, {z: 3,}] }  # e\ne: two\n  lines\nf: |\n  "
        "text\n   more\n\ng: [1,\n  2  # c\n ]\nh: &anchor  7\ni:\n  - 1\n  - x: 2 # c\n    y: 3  # c\nj: ~\n";
    for (const bool crlf : {false, true})
        for (const bool mark : {false, true}) {
            std::string text = mark ? "\xEF\xBB\xBF" : "";
            for (const char c : body) text += crlf && c == '\n' ? std::string("\r\n") : std::string(1, c);
            const Read read(text);
            REQUIRE(read.tree.root);
            const std::string nl = crlf ? "\r\n" : "\n";
            CHECK(read.slice(read.at("a")) == "24mm");
            CHECK(read.slice(read.at("b")) == "\"x \\\" y\"");
            CHECK(read.at("b").text == "x \" y");
            CHECK(read.slice(read.at("c")) == "'it''s'");
            CHECK(read.slice(read.at("d")) == "{x: 1, y: [2, {z: 3,}] }");
            CHECK(read.slice(read.at("e")) == "two" + nl + "  lines");
            CHECK(read.slice(read.at("f")) == "|" + nl + "  text" + nl + "   more");
            CHECK(read.slice(read.at("g")) == "[1," + nl + "  2  # c" + nl + " ]");
            CHECK(read.slice(read.at("h")) == "7");
            CHECK(read.slice(read.at("i")) == "- 1" + nl + "  - x: 2 # c" + nl + "    y: 3");
            CHECK(read.slice(read.at("j")) == "~");
        }
}

TEST_CASE("every escape of a double-quoted text is the UTF-8 of its character") {
    const Read read(R"(a: "\_\N\L\P\x85\u00e9\U0001F3B1 \\ \" \/ä")" "\n");
    REQUIRE(read.tree.root);
    CHECK(read.at("a").text == "\u00a0\xC2\x85\u2028\u2029\xC2\x85\u00e9\U0001F3B1 \\ \" /\u00e4");
}

TEST_CASE("a missing value has its place after the colon") {
    const Read read("a:   # c\nb: {c, d: }\n");
    CHECK(read.at("a").span == Span{2, 2});
    CHECK(read.at("a").kind == YamlKind::null);
    const YamlNode& map = read.at("b");
    CHECK(map.value(0).span.begin == map.key(0).span.end);
    CHECK(read.source.slice({map.value(1).span.begin - 1, map.value(1).span.begin}) == ":");
}

TEST_CASE("aliases are resolved and counted") {
    const Read read("a: &x {b: 1}\nc: [*x, *x]\n");
    REQUIRE(read.tree.root);
    const YamlNode& list = read.at("c");
    CHECK(list.items[0]->kind == YamlKind::alias);
    CHECK(read.slice(*list.items[0]) == "*x");
    CHECK(&list.items[0]->resolved() == &read.at("a"));
    CHECK(read.at("a").references == 2);
    CHECK(list.weight == 7);
    CHECK(list.height == 3);
}

TEST_CASE("a quote that is never closed is an error, also where the parser says nothing") {
    CHECK(Read("a: \"x").code() == "E0105");
    CHECK(Read("a: \"\n\n\n\n").code() == "E0105");
    CHECK(Read("a: 'x''").code() == "E0105");
}

TEST_CASE("a second colon in an entry of flow style is told as that, and quoted") {
    for (const char* text : {"a: {name: a: b}", "a: {name: a: b, d: e}", "a: {x: {name: a: b}}", "a: [name: a: b]"}) {
        INFO(text);
        const Read read(text);
        REQUIRE(read.tree.diagnostics.size() == 1);
        CHECK(read.tree.diagnostics[0].message == "a second colon in one entry: a: b");
        CHECK(read.tree.diagnostics[0].hint.ends_with("\"a: b\""));
        CHECK(read.source.slice(read.tree.diagnostics[0].where.span) == "a");
    }
    CHECK(Read("a: {b: c").tree.diagnostics[0].message == "this { is never closed");
}

TEST_CASE("a bracket closed by another is told of where it stands") {
    const Read read("a: {b: [1, c: [2, 3]}\n");
    REQUIRE(read.tree.diagnostics.size() == 1);
    CHECK(read.tree.diagnostics[0].message == "this [ is not closed: a } comes first");
    CHECK(read.tree.diagnostics[0].where.span.begin == 7);
    CHECK(Read("a: ]\n").tree.diagnostics[0].message == "this ] closes nothing");
}

TEST_CASE("a null key and the words for null are told from a missing value") {
    CHECK(Read("a:\nnull: 3\n").code() == "E0121");
    CHECK(Read("a: null\n").at("a").text == "null");
    CHECK(Read("a: [~, 1]\n").at("a").items[0]->text == "~");
}

#include "editor/section_tools.h"

#include <catch2/catch.hpp>

#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

/// The pen with another word for its inputs and what follows them.
std::string pen_with(const std::string& end) { return pen.substr(0, pen.find("inputs:")) + end; }

using Keys = std::vector<std::string>;

}  // namespace

TEST_CASE("keys are typed with commas, blanks or brackets between them") {
    CHECK(keys_in("[Z, LeftShift]") == Keys{"Z", "LeftShift"});
    CHECK(keys_in("  Z  X ") == Keys{"Z", "X"});
    CHECK(keys_in(" ,").empty());
}

TEST_CASE("an input is added, bound, renamed and taken out, each as one step that changes its line alone") {
    const Folder folder;
    Document document = opened(folder);
    REQUIRE_FALSE(add_input(document, "right", {"Slash"}));
    CHECK(document.source().text() == pen_with("inputs: {left: [Z, LeftShift], right: [Slash]}\n"));
    REQUIRE_FALSE(bind_input(document, 1, {"X", "Right"}));
    CHECK(document.source().text() == pen_with("inputs: {left: [Z, LeftShift], right: [X, Right]}\n"));
    REQUIRE_FALSE(rename_input(document, 0, "west"));
    CHECK(document.scene().find("bat")->get<std::vector<std::string>>("input") == Keys{"west"});
    REQUIRE_FALSE(remove_input(document, 1));
    CHECK(document.scene().inputs.size() == 1);
    CHECK(document.undo_steps() == 4);
    document.go_to(0);
    CHECK(document.source().text() == pen);
}

TEST_CASE("an input that something is moved by, a taken name, a key that there is none of and no key at all are refused") {
    const Folder folder;
    Document document = opened(folder);
    CHECK_THAT(*remove_input(document, 0), Catch::Contains("bat is moved by left"));
    CHECK_THAT(*add_input(document, "pop", {"X"}), Catch::Contains("taken"));
    CHECK_THAT(*add_input(document, "Right", {"X"}), Catch::Contains("not a valid id"));
    CHECK_THAT(*add_input(document, "right", {"Handle"}), Catch::Contains("Handle"));
    CHECK_THAT(*bind_input(document, 0, {}), Catch::Contains("needs a key"));
    CHECK(document.source().text() == pen);
    CHECK_FALSE(document.can_undo());
}

TEST_CASE("a first entry of a section that says nothing stands in a line of its own, whatever the section says nothing with") {
    const Folder folder;
    for (const std::string nothing : {"", " {}", " ~", " null"}) {
        INFO("inputs:" << nothing);
        std::string text = pen_with("inputs:" + nothing + "   # the keys\n");
        text.replace(text.find(", input: [left]"), 15, "");
        Document document = opened(folder, text);
        REQUIRE(document.reading().ok());
        REQUIRE_FALSE(add_input(document, "left", {"Z"}));
        std::string expected = text;
        expected.replace(expected.find("inputs:") + 7, nothing.size(), "");
        CHECK(document.source().text() == expected + "  left: [Z]\n");
        REQUIRE_FALSE(remove_input(document, 0));
        CHECK(document.reading().ok());
    }
    for (const std::string nothing : {"", " []", " ~", " null"}) {
        INFO("tests:" << nothing);
        Document document = opened(folder, pen + "tests:" + nothing + "\n# the end\n");
        REQUIRE_FALSE(add_test(document, "calm"));
        CHECK(document.source().text() == pen + "tests:\n  - {name: calm, run: 10, expect: [escaped == 0]}\n# the end\n");
    }
}

TEST_CASE("a section that the text has not is put in its place among the others, and none of their comments is parted from them") {
    const Folder folder;
    const std::string bare =
        "pinfield: 1\nscene:\n  - circle: {radius: 1cm}\n    # still the circle's\n# of the tests\ntests:\n  - {expect: [escaped == 0]}\n";
    Document document = opened(folder, bare);
    REQUIRE(document.reading().ok());
    REQUIRE_FALSE(add_input(document, "left", {"Z"}));
    CHECK(document.source().text() ==
          "pinfield: 1\nscene:\n  - circle: {radius: 1cm}\n    # still the circle's\ninputs:\n  left: [Z]\n# of the tests\ntests:\n  - "
          "{expect: [escaped == 0]}\n");
    REQUIRE_FALSE(add_test(document, "second"));
    CHECK(document.scene().tests.size() == 2);
    Document crlf = opened(folder, "pinfield: 1\r\nscene: []");
    REQUIRE_FALSE(add_test(crlf, "calm"));
    CHECK(crlf.source().text() == "pinfield: 1\r\nscene: []\r\ntests:\r\n  - {name: calm, run: 10, expect: [escaped == 0]}");
}

TEST_CASE("a test is added behind the others, renamed, left without a name and taken out") {
    const Folder folder;
    Document document = opened(folder, pen + "tests:\n  - name: 'one'   # the first\n    expect: pop.hits >= 0\n");
    REQUIRE_FALSE(add_test(document, "two"));
    REQUIRE_FALSE(rename_test(document, 0, "uno"));
    CHECK_THAT(
        document.source().text(),
        Catch::Contains("  - name: 'uno'   # the first\n    expect: pop.hits >= 0\n  - {name: two, run: 10, expect: [escaped == 0]}\n"));
    REQUIRE_FALSE(rename_test(document, 1, ""));
    CHECK(document.scene().tests[1].name.empty());
    REQUIRE_FALSE(rename_test(document, 1, "due"));
    CHECK_THAT(document.source().text(), Catch::Contains("  - {name: due, run: 10"));
    REQUIRE_FALSE(remove_test(document, 0));
    REQUIRE_FALSE(remove_test(document, 0));
    CHECK(document.scene().tests.empty());
    CHECK(document.reading().ok());
    document.go_to(0);
    CHECK(document.scene().tests.size() == 1);
}

TEST_CASE("a first material of a table stands in a line of its own") {
    const Folder folder;
    const std::string end = "scene:\n  - circle: {radius: 1cm}\n";
    for (const std::string nothing : {"", " {}", " ~"}) {
        Document document = opened(folder, "pinfield: 1\nmaterials:" + nothing + "\n" + end);
        REQUIRE_FALSE(new_material(document).refusal);
        CHECK(document.source().text() ==
              "pinfield: 1\nmaterials:\n  " + document.scene().find(document.scene().materials()[0])->name + ": {}\n" + end);
    }
}

#include "editor/fuzzy_match.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include <cctype>
#include <string>

using namespace pinfield::editor;

namespace {

/// The text with the letters found in capitals, the others small; "-" where nothing is found.
std::string found(std::string text, std::string_view query) {
    const auto match = fuzzy_match(text, query);
    if (!match) return "-";
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const std::size_t place : match->places) text[place] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[place])));
    return text;
}
int score(std::string_view text, std::string_view query) { return fuzzy_match(text, query)->score; }

}  // namespace

TEST_CASE("letters are found in their order, at beginnings of words first") {
    CHECK(found("Select all of this type", "saty") == "Select All of this TYpe");
    CHECK(found("Select all of this type", "sat") == "Select All of This type");
    CHECK(found("Move up", "mu") == "Move Up");
    CHECK(found("pop_left", "pl") == "Pop_Left");
    CHECK(found("Frame the table", "table") == "frame the TABLE");
    CHECK(found("attach", "tac") == "atTACh");
    CHECK(found("Undo", "udno") == "-");
    CHECK(found("Undo", "undoo") == "-");
}

TEST_CASE("case and blanks do not count, and no letters find everything") {
    CHECK(found("Move up", "MOVE UP") == "MOVE UP");
    CHECK(found("Zoom in", "zo in") == "ZOom IN");
    CHECK(fuzzy_match("Undo", "")->places.empty());
    CHECK(fuzzy_match("", "")->score == 0);
    CHECK_FALSE(fuzzy_match("", "a"));
}

TEST_CASE("a word's beginning beats its middle, a run beats scattered letters, the text's beginning beats all") {
    CHECK(score("Save", "sa") > score("Paste as", "sa"));
    CHECK(score("red post", "po") > score("red compost", "po"));
    CHECK(score("abcxyz", "abc") > score("axbxcx", "abc"));
    CHECK(score("axb", "ab") > score("axxxb", "ab"));
}

TEST_CASE("every match spells the query, whatever the text") {
    const auto letters = rc::gen::container<std::string>(rc::gen::elementOf(std::string("abAB_ ")));
    CHECK(rc::check("fuzzy match", [&] {
        const std::string text = *letters, query = *letters;
        std::string wanted, rest;
        for (const char c : query)
            if (c != ' ') wanted += static_cast<char>(std::tolower(c));
        rest = wanted;
        for (const char c : text)
            if (!rest.empty() && std::tolower(c) == rest.front()) rest.erase(0, 1);
        const auto match = fuzzy_match(text, query);
        RC_ASSERT(match.has_value() == rest.empty());
        if (!match) return;
        std::string spelled;
        for (std::size_t i = 0; i < match->places.size(); ++i) {
            RC_ASSERT(i == 0 || match->places[i] > match->places[i - 1]);
            spelled += static_cast<char>(std::tolower(text[match->places[i]]));
        }
        RC_ASSERT(spelled == wanted);
    }));
}

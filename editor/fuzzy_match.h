// Finding what somebody means by a few of its letters.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

namespace pinfield::editor {

struct FuzzyMatch {
    int score = 0;                    ///< more is better
    std::vector<std::size_t> places;  ///< of the letters in the text, one for each of the query's
};

/// The best way to find the query's letters in the text, in their order, whatever their case; blanks of the query stand for nothing. Letters
/// that begin words count most, then those that follow each other. Nothing where one is missing.
std::optional<FuzzyMatch> fuzzy_match(std::string_view text, std::string_view query);

}  // namespace pinfield::editor

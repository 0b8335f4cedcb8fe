#include "editor/fuzzy_match.h"

#include <algorithm>
#include <string>

namespace pinfield::editor {
namespace {

constexpr int letter = 1, begins_word = 8, begins_text = 4, follows = 5, most_gap = 3;
constexpr int none = -1'000'000;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool in_word(char c) { return (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80; }

int worth(std::string_view text, std::size_t at) {
    if (at == 0) return letter + begins_word + begins_text;
    return letter + (in_word(text[at]) && !in_word(text[at - 1]) ? begins_word : 0);
}

bool holds(std::string_view text, std::string_view wanted) {
    std::size_t found = 0;
    for (const char c : text)
        if (found < wanted.size() && lower(c) == wanted[found]) ++found;
    return found == wanted.size();
}

std::string letters_of(std::string_view query) {
    std::string out;
    for (const char c : query)
        if (c != ' ') out += lower(c);
    return out;
}

}  // namespace

std::optional<FuzzyMatch> fuzzy_match(std::string_view text, std::string_view query) {
    const std::string wanted = letters_of(query);
    if (wanted.empty()) return FuzzyMatch{};
    if (!holds(text, wanted)) return {};
    // best[i][j]: of ways that find letter i at place j; from[i][j]: where its letter before stands then.
    std::vector<std::vector<int>> best(wanted.size(), std::vector<int>(text.size(), none));
    std::vector<std::vector<std::size_t>> from(wanted.size(), std::vector<std::size_t>(text.size(), 0));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        for (std::size_t j = i; j < text.size(); ++j) {
            if (lower(text[j]) != wanted[i]) continue;
            if (i == 0) best[i][j] = worth(text, j);
            for (std::size_t k = i == 0 ? j : i - 1; k < j; ++k) {
                if (best[i - 1][k] == none) continue;
                const int gap = static_cast<int>(j - k) - 1, link = gap == 0 ? follows : -std::min(gap, most_gap);
                const int score = best[i - 1][k] + link + worth(text, j);
                if (score <= best[i][j]) continue;
                best[i][j] = score;
                from[i][j] = k;
            }
        }
    }
    const auto end = std::max_element(best.back().begin(), best.back().end());
    FuzzyMatch match{*end, std::vector<std::size_t>(wanted.size())};
    auto at = static_cast<std::size_t>(end - best.back().begin());
    for (std::size_t i = wanted.size(); i-- > 0; at = from[i][at]) match.places[i] = at;
    return match;
}

}  // namespace pinfield::editor

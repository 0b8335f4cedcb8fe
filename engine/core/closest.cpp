#include "engine/core/closest.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace pinfield {
namespace {

template <class Text>
std::optional<std::string> closest_of(std::string_view word, std::span<const Text> candidates) {
    // Beyond this no name of a node is misspelt; it keeps a hostile file's words from costing anything.
    constexpr std::size_t longest_word = 64;
    if (word.size() > longest_word) return std::nullopt;
    std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
    std::optional<std::string> best;
    for (const Text& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        // A word as short as its number of errors has nothing in common with the candidate.
        if (distance < best_distance && distance < std::max(word.size(), std::string_view(candidate).size())) {
            best_distance = distance;
            best = std::string(candidate);
        }
    }
    return best;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
    // Rows of the dynamic programme: costs from the first i letters of a to every beginning of b.
    std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last.swap(last);
        last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::optional<std::string> closest_match(std::string_view word, std::span<const std::string> candidates) {
    return closest_of(word, candidates);
}

std::optional<std::string> closest_match(std::string_view word, std::span<const std::string_view> candidates) {
    return closest_of(word, candidates);
}

std::string suggestion(std::string_view word, std::span<const std::string_view> candidates) {
    // A hostile file has as many names as it likes; a table has fewer than this.
    constexpr std::size_t most_compared = 500;
    if (const auto close = closest_match(word, candidates.first(std::min(candidates.size(), most_compared)))) return fmt::format("did you mean {}?", *close);
    if (candidates.empty() || candidates.size() > 12) return {};
    return fmt::format("one of: {}", fmt::join(candidates, ", "));
}

}  // namespace pinfield

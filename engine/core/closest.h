// "Did you mean ...?"
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pinfield {

/// Fewest letters to insert, delete, replace or swap with their neighbour to turn `a` into `b` (optimal string
/// alignment: Damerau, "A technique for computer detection and correction of spelling errors", 1964).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that a misspelt `word` most likely meant: at most a third of its letters wrong (at least one may be).
/// The first of equals.
std::optional<std::string> closest_match(std::string_view word, std::span<const std::string> candidates);
std::optional<std::string> closest_match(std::string_view word, std::span<const std::string_view> candidates);

/// "did you mean radius?", or "one of: a, b, c" when there are few and none is close, or nothing. Of very many candidates only the first
/// are compared.
std::string suggestion(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace pinfield

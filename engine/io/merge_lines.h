// Two texts that were made of one, made one again line by line.
#pragma once
#include <string>
#include <string_view>

namespace pinfield {

/// `theirs` with the lines that `mine` has otherwise than `base`; where both have changed the same lines, those of `theirs`.
std::string merge_lines(std::string_view base, std::string_view mine, std::string_view theirs);

}  // namespace pinfield

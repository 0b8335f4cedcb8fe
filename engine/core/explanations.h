// What a code means at length, with an example of wrong and of right: for `pinfield explain`.
#pragma once
#include <span>
#include <string_view>

#include "engine/core/error_codes.h"

namespace pinfield {

/// The text beside an ErrorCode's one line. Tests read every `wrong` and find exactly its code, once, and every `right` and find nothing.
struct Explanation {
    Code code;
    std::string_view text;   ///< why this is told and what to do about it: sentences on one line, to be wrapped
    /// Lines of YAML. Those that begin with "- " are nodes of a `scene:` (of E0601: steps of a script), all others are a whole table. Both are
    /// empty where no few lines can show it; then the text says what does.
    std::string_view wrong, right;
};

/// One for every code (a test sees to it); null for a code that nobody has explained yet.
const Explanation* explanation(Code code);

/// The families, in the order of their codes; each is a file of explanations/.
std::span<const Explanation> text_explanations();       ///< E01xx
std::span<const Explanation> structure_explanations();  ///< E02xx
std::span<const Explanation> reference_explanations();  ///< E03xx, E04xx
std::span<const Explanation> doubt_explanations();      ///< W05xx, E06xx

}  // namespace pinfield

// Text from strangers as people may see it: names, keys and paths can hold what a terminal obeys, or what turns a line round.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace pinfield {

/// Length in bytes of the well-formed UTF-8 sequence at `at` (no overlong forms, no surrogates: RFC 3629), or 0.
std::size_t utf8_length(std::string_view text, std::size_t at);

/// What stands at a byte of any text: a well-formed character, or else the byte alone.
struct CharacterAt {
    unsigned code = 0;      ///< the code point, or the byte
    std::size_t bytes = 1;
    bool is_utf8 = true;
    bool is_harmless = true;  ///< no control, and nothing that turns, breaks or hides what stands about it
};
CharacterAt character_at(std::string_view text, std::size_t at);

/// The text on one line, harmless and telling: controls (C0, DEL, C1) as \n, \t, \r, \x1b or \x9b, what turns, breaks or hides text (BiDi
/// controls, line separators, byte order marks, tags: UAX 9, UTR 36) as \u202e, bytes that are no UTF-8 as \xff. All else stays, backslashes too:
/// it is for people and is not read back.
std::string shown(std::string_view text);

/// Lines that were made of such text, or need to be: as shown(), but line breaks stay.
std::string shown_lines(std::string_view text);

}  // namespace pinfield

// What the pieces of a table's text are, for eyes: by their look alone, so that a text that does not read has colors too.
#pragma once
#include <string_view>
#include <vector>

#include "engine/core/source_text.h"

namespace pinfield::editor {

enum class TokenKind : unsigned char {
    comment,
    section,  ///< a key at the margin: `scene`
    key,
    type,     ///< the key of an item, which names its type: `circle`
    quoted,   ///< a text in quotes, or under | or >
    number,   ///< with its unit
    word,     ///< any other value
    keyword,  ///< true, false, null
    anchor,   ///< &name, *name, !tag
    mark      ///< brackets, commas, colons, dashes
};

struct Token {
    Span span;
    TokenKind kind = TokenKind::word;
    bool operator==(const Token&) const = default;
};

/// In order; everything but blanks, line breaks and a byte order mark is in exactly one of them.
std::vector<Token> highlight_yaml(std::string_view text);

}  // namespace pinfield::editor

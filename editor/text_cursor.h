// Where somebody types in a text, how keys move it, and what they change. No window: the source panel's hands, as values.
#pragma once
#include "editor/splice.h"

namespace pinfield::editor {

/// Byte offsets at the beginnings of characters; a line break of two bytes is one character, and a byte order mark none.
struct TextCursor {
    std::size_t caret = 0, anchor = 0;  ///< what lies between them is selected
    int column = -1;                    ///< that up and down keep to, in code points; -1: the caret's own

    Span selected() const { return caret < anchor ? Span{caret, anchor} : Span{anchor, caret}; }
    bool selects() const { return caret != anchor; }
    bool operator==(const TextCursor&) const = default;
};
/// Nothing selected.
inline TextCursor cursor_at(std::size_t offset) { return {offset, offset}; }

enum class Motion : unsigned char {
    left, right, word_left, word_right, up, down, page_up, page_down, line_start, line_end, text_start, text_end
};

/// `selecting`: the anchor stays. A page is so many lines. The start of a line is first that of its words, then its own.
TextCursor moved(std::string_view text, TextCursor cursor, Motion motion, bool selecting, int page = 1);
/// The word about a place, or the blanks.
TextCursor word_at(std::string_view text, std::size_t offset);
/// The nearest beginning of a character at or before a place.
std::size_t snapped(std::string_view text, std::size_t offset);
/// The place of a column of a line, both from 1 and in code points; of the line's end where it is shorter.
std::size_t offset_at(const SourceText& text, int line, int column);

/// Characters in place of what is selected; line breaks among them become those that the text has.
Splice typed(std::string_view text, const TextCursor& cursor, std::string_view characters);
/// A line break, and as many blanks as the line begins with: after a dash or an open key, as many as what belongs to it needs.
Splice new_line(std::string_view text, const TextCursor& cursor);
/// Takes out what is selected, else what lies between the caret and where a motion leads.
Splice erased(std::string_view text, const TextCursor& cursor, Motion motion);
/// Two blanks more (or fewer) before each line that is selected; without a selection, blanks to the next even column.
Splice indented(std::string_view text, const TextCursor& cursor, bool outwards);

}  // namespace pinfield::editor

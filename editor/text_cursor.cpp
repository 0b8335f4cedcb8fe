#include "editor/text_cursor.h"

#include <algorithm>

namespace pinfield::editor {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t indent_width = 2;

std::size_t text_start(std::string_view text) { return text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0; }

/// A byte that continues a character, or the second of a line break.
bool continues(std::string_view text, std::size_t at) {
    if (at >= text.size()) return false;
    return (static_cast<unsigned char>(text[at]) & 0xc0u) == 0x80u || (at > 0 && text[at] == '\n' && text[at - 1] == '\r');
}

std::size_t after(std::string_view text, std::size_t at) {
    if (at >= text.size()) return text.size();
    ++at;
    while (continues(text, at)) ++at;
    return at;
}

std::size_t before(std::string_view text, std::size_t at) {
    if (at <= text_start(text)) return text_start(text);
    --at;
    while (at > 0 && continues(text, at)) --at;
    return at;
}

std::size_t line_start(std::string_view text, std::size_t at) {
    const std::size_t found = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    return found == std::string_view::npos ? text_start(text) : found + 1;
}

/// Before the line's break.
std::size_t line_end(std::string_view text, std::size_t at) {
    std::size_t end = std::min(text.find('\n', at), text.size());
    if (end > at && end < text.size() && text[end - 1] == '\r') --end;
    return end;
}

std::size_t blanks_end(std::string_view text, std::size_t at) {
    while (at < text.size() && (text[at] == ' ' || text[at] == '\t')) ++at;
    return at;
}

int column_of(std::string_view text, std::size_t at) {
    int column = 0;
    for (std::size_t i = line_start(text, at); i < at; i = after(text, i)) ++column;
    return column;
}

std::size_t place_in_line(std::string_view text, std::size_t start, int column) {
    const std::size_t end = line_end(text, start);
    while (column-- > 0 && start < end) start = after(text, start);
    return start;
}

enum class Sort : unsigned char { blank, word, other };
Sort sort_of(char c) {
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') return Sort::blank;
    const auto byte = static_cast<unsigned char>(c);
    const bool word = byte >= 0x80 || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.';
    return word ? Sort::word : Sort::other;
}

std::size_t word_left(std::string_view text, std::size_t at) {
    while (at > text_start(text) && sort_of(text[before(text, at)]) == Sort::blank) at = before(text, at);
    if (at == text_start(text)) return at;
    const Sort sort = sort_of(text[before(text, at)]);
    while (at > text_start(text) && sort_of(text[before(text, at)]) == sort) at = before(text, at);
    return at;
}

std::size_t word_right(std::string_view text, std::size_t at) {
    if (at >= text.size()) return text.size();
    const Sort sort = sort_of(text[at]);
    while (at < text.size() && sort_of(text[at]) == sort) at = after(text, at);
    while (at < text.size() && sort_of(text[at]) == Sort::blank) at = after(text, at);
    return at;
}

std::size_t lines_away(std::string_view text, std::size_t at, int column, int lines) {
    for (; lines < 0; ++lines) {
        const std::size_t start = line_start(text, at);
        if (start <= text_start(text)) return text_start(text);
        at = line_start(text, start - 1);
    }
    for (; lines > 0; --lines) {
        const std::size_t next = text.find('\n', at);
        if (next == std::string_view::npos) return text.size();
        at = next + 1;
    }
    return place_in_line(text, line_start(text, at), column);
}

std::size_t home(std::string_view text, std::size_t at) {
    const std::size_t start = line_start(text, at), words = std::min(blanks_end(text, start), line_end(text, at));
    return at == words ? start : words;
}

std::size_t led_to(std::string_view text, const TextCursor& cursor, Motion motion, int page) {
    const std::size_t at = cursor.caret;
    switch (motion) {
        case Motion::left: return before(text, at);
        case Motion::right: return after(text, at);
        case Motion::word_left: return word_left(text, at);
        case Motion::word_right: return word_right(text, at);
        case Motion::up: return lines_away(text, at, cursor.column, -1);
        case Motion::down: return lines_away(text, at, cursor.column, 1);
        case Motion::page_up: return lines_away(text, at, cursor.column, -page);
        case Motion::page_down: return lines_away(text, at, cursor.column, page);
        case Motion::line_start: return home(text, at);
        case Motion::line_end: return line_end(text, at);
        case Motion::text_start: return text_start(text);
        case Motion::text_end: return text.size();
    }
    return at;
}

/// As the line before ends, else the first line.
std::string_view line_break_at(std::string_view text, std::size_t at) {
    std::size_t found = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    if (found == std::string_view::npos) found = text.find('\n');
    return found != std::string_view::npos && found > 0 && text[found - 1] == '\r' ? "\r\n" : "\n";
}

}  // namespace

TextCursor moved(std::string_view text, TextCursor cursor, Motion motion, bool selecting, int page) {
    const bool vertical = motion == Motion::up || motion == Motion::down || motion == Motion::page_up || motion == Motion::page_down;
    if (vertical && cursor.column < 0) cursor.column = column_of(text, cursor.caret);
    if (!vertical) cursor.column = -1;
    const bool steps = motion == Motion::left || motion == Motion::right;
    if (steps && cursor.selects() && !selecting)  // a step out of a selection ends at its edge
        return cursor_at(motion == Motion::left ? cursor.selected().begin : cursor.selected().end);
    cursor.caret = led_to(text, cursor, motion, page);
    if (!selecting) cursor.anchor = cursor.caret;
    return cursor;
}

TextCursor word_at(std::string_view text, std::size_t offset) {
    const std::size_t start = line_start(text, offset), end = line_end(text, offset);
    if (start >= end) return cursor_at(start);
    const std::size_t on = offset >= end ? before(text, end) : offset;
    const Sort sort = sort_of(text[on]);
    TextCursor word{after(text, on), on};
    while (word.anchor > start && sort_of(text[before(text, word.anchor)]) == sort) word.anchor = before(text, word.anchor);
    while (word.caret < end && sort_of(text[word.caret]) == sort) word.caret = after(text, word.caret);
    return word;
}

std::size_t snapped(std::string_view text, std::size_t offset) {
    offset = std::min(offset, text.size());
    while (offset > 0 && continues(text, offset)) --offset;
    return std::max(offset, text_start(text));
}

std::size_t offset_at(const SourceText& text, int line, int column) {
    line = std::clamp(line, 1, text.line_count());
    const auto start = static_cast<std::size_t>(text.line(line).data() - text.text().data());
    return place_in_line(text.text(), std::max(start, text_start(text.text())), column - 1);
}

Splice typed(std::string_view text, const TextCursor& cursor, std::string_view characters) {
    const std::string_view line_break = line_break_at(text, cursor.selected().begin);
    Splice splice{cursor.selected(), {}};
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const bool pair = characters.substr(i, 2) == "\r\n";
        if (pair) ++i;
        if (pair || characters[i] == '\n' || characters[i] == '\r') splice.inserted += line_break;
        else splice.inserted += characters[i];
    }
    return splice;
}

Splice new_line(std::string_view text, const TextCursor& cursor) {
    const std::size_t at = cursor.selected().begin, start = line_start(text, at), words = std::min(blanks_end(text, start), at);
    std::string blanks(text.substr(start, words - start));
    const std::string_view line = text.substr(words, at - words);
    if (line.ends_with(':')) blanks.append(indent_width * (line.starts_with("- ") ? 2 : 1), ' ');
    return typed(text, cursor, "\n" + blanks);
}

Splice erased(std::string_view text, const TextCursor& cursor, Motion motion) {
    return {cursor.selects() ? cursor.selected() : moved(text, cursor, motion, true).selected(), {}};
}

Splice indented(std::string_view text, const TextCursor& cursor, bool outwards) {
    if (!cursor.selects() && !outwards)
        return {cursor.selected(), std::string(indent_width - static_cast<std::size_t>(column_of(text, cursor.caret)) % indent_width, ' ')};
    const std::size_t from = line_start(text, cursor.selected().begin), last = std::max(cursor.selected().end, from + 1) - 1;
    Splice splice{{from, std::max(line_end(text, std::min(last, text.size())), cursor.selected().end)}, {}};
    for (std::size_t at = from; at < splice.removed.end;) {
        const std::size_t next = std::min(text.find('\n', at), splice.removed.end - 1) + 1;
        std::size_t words = at;
        while (outwards && words < next && words - at < indent_width && text[words] == ' ') ++words;
        const bool empty = blanks_end(text, at) >= line_end(text, at);
        if (!outwards && !empty) splice.inserted.append(indent_width, ' ');
        splice.inserted.append(text.substr(words, next - words));
        at = next;
    }
    return splice;
}

}  // namespace pinfield::editor

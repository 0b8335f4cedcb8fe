#include "engine/io/yaml_edit.h"

#include <fmt/format.h>

#include "engine/io/yaml_text.h"

namespace pinfield {
namespace {

std::string_view slice(std::string_view text, std::size_t begin, std::size_t end) {
    return text.substr(begin, end - begin);
}

bool only_blanks(std::string_view text, std::size_t begin, std::size_t end) { return skip_spaces(text, begin) >= end; }

/// Nothing but blanks and a comment from here to the end of the line.
bool line_is_over(std::string_view text, std::size_t at) {
    const std::size_t content = skip_spaces(text, at);
    return content >= line_end(text, at) || (text[content] == '#' && content > at);
}

/// The comma after `at` on the same line, or npos.
std::size_t comma_after(std::string_view text, std::size_t at) {
    const std::size_t next = skip_spaces(text, at);
    return next < text.size() && text[next] == ',' ? next : std::string_view::npos;
}

Splice insert(std::size_t at, std::string text) { return {{at, at}, std::move(text)}; }

/// Every line after the first moved to the right.
std::string indented(std::string_view entry, std::size_t column) {
    std::string out;
    for (const char c : entry) {
        out += c;
        if (c == '\n') out.append(column, ' ');
    }
    return out;
}

std::vector<Span> pieces_of(const YamlNode& map) {
    std::vector<Span> out;
    for (std::size_t i = 0; i < map.entries(); ++i)
        out.push_back({map.key(i).span.begin, std::max(map.key(i).span.end, map.value(i).span.end)});
    return out;
}

Splice insert_block(std::string_view text, const YamlNode& map, std::size_t index, std::string_view entry) {
    const std::size_t first = map.key(0).span.begin, column = first - line_begin(text, first);
    const std::string line = std::string(line_break(text)) + std::string(column, ' ');
    if (index == 0) return insert(first, indented(entry, column) + line);
    return insert(line_end(text, map.value(index - 1).span.end), line + indented(entry, column));
}

Splice remove_block(std::string_view text, const YamlNode& map, std::size_t index) {
    const Span key = map.key(index).span, value = map.value(index).span;
    const std::size_t end = std::max(key.end, value.end);
    if (begins_its_line(text, key.begin)) return remove_lines(text, key.begin, end);
    if (index + 1 < map.entries()) return {{key.begin, map.key(index + 1).span.begin}, ""};
    return {{key.begin, end}, ""};
}

}  // namespace

std::string_view line_break(std::string_view text) {
    const std::size_t first = text.find('\n');
    return first != std::string_view::npos && first > 0 && text[first - 1] == '\r' ? "\r\n" : "\n";
}

std::size_t next_line(std::string_view text, std::size_t at) {
    const std::size_t end = text.find('\n', at);
    return end == std::string_view::npos ? text.size() : end + 1;
}

bool begins_its_line(std::string_view text, std::size_t at) { return only_blanks(text, line_begin(text, at), at); }

Splice remove_lines(std::string_view text, std::size_t begin, std::size_t last) {
    const std::size_t from = line_begin(text, begin), to = next_line(text, last);
    if (to < text.size() || from == 0 || (to > 0 && text[to - 1] == '\n')) return {{from, to}, ""};
    const std::size_t before = from - (from >= 2 && text[from - 2] == '\r' ? 2 : 1);  // the last line has no break of its own
    return {{before, to}, ""};
}

Splice insert_flow(std::string_view text, Span brackets, const std::vector<Span>& pieces, std::size_t index, std::string_view piece) {
    if (pieces.empty()) return insert(brackets.begin + 1, std::string(piece));
    if (index == 0) return insert(pieces[0].begin, fmt::format("{}, ", piece));
    const Span before = pieces[index - 1];
    if (!begins_its_line(text, before.begin)) return insert(before.end, fmt::format(", {}", piece));
    // One entry a line: the new one gets its own, after the comment that belongs to the one before.
    const std::string line =
        std::string(line_break(text)) + std::string(before.begin - line_begin(text, before.begin), ' ');
    const std::size_t comma = comma_after(text, before.end);
    if (comma != std::string_view::npos) {
        if (!line_is_over(text, comma + 1)) return insert(before.end, fmt::format(", {}", piece));
        return insert(line_end(text, comma), fmt::format("{}{},", line, piece));
    }
    if (!line_is_over(text, before.end)) return insert(before.end, fmt::format(",{}{}", line, piece));
    const std::size_t stop = line_end(text, before.end);
    return {{before.end, stop}, fmt::format(",{}{}{}", slice(text, before.end, stop), line, piece)};
}

Splice remove_flow(std::string_view text, Span brackets, const std::vector<Span>& pieces, std::size_t index) {
    const auto [begin, end] = pieces[index];
    const std::size_t comma = comma_after(text, end), after = comma == std::string_view::npos ? end : comma + 1;
    if (pieces.size() == 1) {
        const bool nothing_else = only_blanks(text, brackets.begin + 1, begin) && only_blanks(text, after, brackets.end - 1);
        return nothing_else ? Splice{{brackets.begin + 1, brackets.end - 1}, ""} : Splice{{begin, after}, ""};
    }
    if (begins_its_line(text, begin) && line_is_over(text, after)) return remove_lines(text, begin, after);
    if (index + 1 < pieces.size()) {
        const std::size_t next = pieces[index + 1].begin;
        return {{begin, line_end(text, begin) >= next ? next : after}, ""};
    }
    const std::size_t previous = pieces[index - 1].end;
    if (slice(text, previous, begin).find('#') == std::string_view::npos) return {{previous, end}, ""};
    return {{begin, end}, ""};
}

Splice insert_entry(std::string_view text, const YamlNode& map, std::size_t index, std::string_view entry) {
    return map.style == YamlStyle::block ? insert_block(text, map, index, entry) : insert_flow(text, map.span, pieces_of(map), index, entry);
}

Splice insert_body(std::string_view text, const YamlNode& missing, std::string_view entry) {
    const Span span = missing.span;
    if (missing.kind == YamlKind::scalar) return {span, fmt::format("{{{}}}", entry)};
    const bool colon = span.begin > 0 && text[span.begin - 1] == ':';
    return {span, fmt::format("{} {{{}}}", colon ? "" : ":", entry)};
}

Splice remove_entry(std::string_view text, const YamlNode& map, std::size_t index) {
    return map.style == YamlStyle::block ? remove_block(text, map, index) : remove_flow(text, map.span, pieces_of(map), index);
}

}  // namespace pinfield

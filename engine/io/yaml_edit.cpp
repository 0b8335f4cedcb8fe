#include "engine/io/yaml_edit.h"

#include <fmt/format.h>

#include "engine/io/yaml_text.h"

namespace pinfield {
namespace {

std::string_view slice(std::string_view text, std::size_t begin, std::size_t end) {
    return text.substr(begin, end - begin);
}

std::string_view line_break(std::string_view text) {
    const std::size_t first = text.find('\n');
    return first != std::string_view::npos && first > 0 && text[first - 1] == '\r' ? "\r\n" : "\n";
}

bool only_blanks(std::string_view text, std::size_t begin, std::size_t end) { return skip_spaces(text, begin) >= end; }

/// Nothing but blanks and a comment from here to the end of the line.
bool line_is_over(std::string_view text, std::size_t at) {
    const std::size_t content = skip_spaces(text, at);
    return content >= line_end(text, at) || (text[content] == '#' && content > at);
}

bool begins_its_line(std::string_view text, std::size_t at) { return only_blanks(text, line_begin(text, at), at); }

/// A line break and the indentation of the column where `key` stands.
std::string new_line_like(std::string_view text, const YamlNode& key) {
    return std::string(line_break(text)) + std::string(key.span.begin - line_begin(text, key.span.begin), ' ');
}

std::size_t next_line(std::string_view text, std::size_t at) {
    const std::size_t end = text.find('\n', at);
    return end == std::string_view::npos ? text.size() : end + 1;
}

/// The comma after `at` on the same line, or npos.
std::size_t comma_after(std::string_view text, std::size_t at) {
    const std::size_t next = skip_spaces(text, at);
    return next < text.size() && text[next] == ',' ? next : std::string_view::npos;
}

Splice insert(std::size_t at, std::string text) { return {{at, at}, std::move(text)}; }

Splice insert_block(std::string_view text, const YamlNode& map, std::size_t index, std::string_view entry) {
    const std::string line = new_line_like(text, map.key(0));
    if (index == 0) return insert(map.key(0).span.begin, std::string(entry) + line);
    return insert(line_end(text, map.value(index - 1).span.end), line + std::string(entry));
}

Splice insert_flow(std::string_view text, const YamlNode& map, std::size_t index, std::string_view entry) {
    if (map.entries() == 0) return insert(map.span.begin + 1, std::string(entry));
    if (index == 0) return insert(map.key(0).span.begin, fmt::format("{}, ", entry));
    const YamlNode& before = map.key(index - 1);
    const std::size_t end = map.value(index - 1).span.end;
    if (!begins_its_line(text, before.span.begin)) return insert(end, fmt::format(", {}", entry));
    // One entry a line: the new one gets its own, after the comment that belongs to the one before.
    const std::string line = new_line_like(text, before);
    const std::size_t comma = comma_after(text, end);
    if (comma != std::string_view::npos) {
        if (!line_is_over(text, comma + 1)) return insert(end, fmt::format(", {}", entry));
        return insert(line_end(text, comma), fmt::format("{}{},", line, entry));
    }
    if (!line_is_over(text, end)) return insert(end, fmt::format(",{}{}", line, entry));
    const std::size_t stop = line_end(text, end);
    return {{end, stop}, fmt::format(",{}{}{}", slice(text, end, stop), line, entry)};
}

Splice remove_line(std::string_view text, std::size_t begin, std::size_t last) {
    const std::size_t from = line_begin(text, begin), to = next_line(text, last);
    if (to < text.size() || from == 0 || (to > 0 && text[to - 1] == '\n')) return {{from, to}, ""};
    const std::size_t before =
        from - (from >= 2 && text[from - 2] == '\r' ? 2 : 1);  // the last line has no break of its own
    return {{before, to}, ""};
}

Splice remove_block(std::string_view text, const YamlNode& map, std::size_t index) {
    const Span key = map.key(index).span, value = map.value(index).span;
    const std::size_t end = std::max(key.end, value.end);
    if (begins_its_line(text, key.begin)) return remove_line(text, key.begin, end);
    if (index + 1 < map.entries()) return {{key.begin, map.key(index + 1).span.begin}, ""};
    return {{key.begin, end}, ""};
}

Splice remove_flow(std::string_view text, const YamlNode& map, std::size_t index) {
    const std::size_t begin = map.key(index).span.begin,
                      end = std::max(map.key(index).span.end, map.value(index).span.end);
    const std::size_t comma = comma_after(text, end), after = comma == std::string_view::npos ? end : comma + 1;
    const bool last = index + 1 == map.entries();
    if (map.entries() == 1) {
        const bool nothing_else =
            only_blanks(text, map.span.begin + 1, begin) && only_blanks(text, after, map.span.end - 1);
        return nothing_else ? Splice{{map.span.begin + 1, map.span.end - 1}, ""} : Splice{{begin, after}, ""};
    }
    if (begins_its_line(text, begin) && line_is_over(text, after)) return remove_line(text, begin, after);
    if (!last) {
        const std::size_t next = map.key(index + 1).span.begin;
        return {{begin, line_end(text, begin) >= next ? next : after}, ""};
    }
    const std::size_t previous = map.value(index - 1).span.end;
    if (slice(text, previous, begin).find('#') == std::string_view::npos) return {{previous, end}, ""};
    return {{begin, end}, ""};
}

}  // namespace

Splice insert_entry(std::string_view text, const YamlNode& map, std::size_t index, std::string_view entry) {
    return map.style == YamlStyle::block ? insert_block(text, map, index, entry) : insert_flow(text, map, index, entry);
}

Splice insert_body(std::string_view text, const YamlNode& missing, std::string_view entry) {
    const Span span = missing.span;
    if (missing.kind == YamlKind::scalar) return {span, fmt::format("{{{}}}", entry)};
    const bool colon = span.begin > 0 && text[span.begin - 1] == ':';
    return {span, fmt::format("{} {{{}}}", colon ? "" : ":", entry)};
}

Splice remove_entry(std::string_view text, const YamlNode& map, std::size_t index) {
    return map.style == YamlStyle::block ? remove_block(text, map, index) : remove_flow(text, map, index);
}

}  // namespace pinfield

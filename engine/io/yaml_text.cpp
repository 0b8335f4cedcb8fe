#include "engine/io/yaml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "engine/core/error_codes.h"
#include "engine/core/shown.h"

namespace pinfield {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t'; }
bool is_break(char c) { return c == '\n' || c == '\r'; }

/// The parser would take 0x04 for the end of the file and end a line at a lone carriage return: neither may come so
/// far.
std::optional<Diagnostic> check_characters(const SourceText& source) {
    const std::string_view text = source.text();
    for (std::size_t i = 0; i < text.size();) {
        const auto c = static_cast<unsigned char>(text[i]);
        if (c >= 0x20 && c < 0x7F) {
            ++i;
            continue;
        }
        const Place here = source.place({i, i + 1});
        if (c == 0) return diagnose(Code::control_character, here, "a NUL byte in the text", "is this a binary file?");
        const bool lone_return = c == '\r' && (i + 1 >= text.size() || text[i + 1] != '\n');
        if ((c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7F || lone_return)
            return diagnose(Code::control_character, here, fmt::format("a control character (0x{:02X}) in the text", c),
                            lone_return ? "end lines with a line feed, or carriage return and line feed" : "remove it");
        const std::size_t length = utf8_length(text, i);
        if (length == 0)
            return diagnose(Code::not_utf8, here, fmt::format("byte 0x{:02X} is not UTF-8", c),
                            "save the file as UTF-8");
        i += length;
    }
    return {};
}

void check_tabs(const SourceText& source, Diagnostics& out) {
    const std::string_view text = source.text();
    if (text.find('\t') == std::string_view::npos) return;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = line_end(text, begin), content = std::min(skip_spaces(text, begin), end);
        const std::size_t tab = text.substr(begin, content - begin).find('\t');
        if (tab != std::string_view::npos && content < end && text[content] != '#')
            out.push_back(diagnose(Code::tab_indentation, source.place({begin + tab, begin + tab + 1}), "a tab in the indentation",
                                   "indent with spaces"));
        begin = text.find('\n', end);
        if (begin == std::string_view::npos || out.size() >= 20) return;
        ++begin;
    }
}

/// The parser keeps every open bracket in a queue before it says a word about it: megabytes of them cost a gigabyte.
/// And it copies a scalar of megabytes before its length can be judged. A comma of a list and a dash that begins a
/// line are an event, a colon with a blank is two, unless a text or a comment holds them; whoever writes more than the
/// limit of those is refused before the parser has spent its third of a second on them.
std::optional<Diagnostic> check_costs(const SourceText& source, const Limits& limits) {
    const std::string_view text = source.text();
    const std::size_t most_open = 16 * limits.depth;
    std::array<bool, 256> ends_word{};
    for (const char c : std::string_view(" \n,[]{}:\"'#")) ends_word[static_cast<unsigned char>(c)] = true;
    std::string open;  // brackets
    std::size_t run = 0, separators = 0;
    bool line_begins = true;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        ++run;
        if (c == '[' || c == '{') open.push_back(c);
        if ((c == ']' || c == '}') && !open.empty()) open.pop_back();
        if (open.size() > most_open)
            return diagnose(Code::too_deep, source.place({i, i + 1}), fmt::format("more than {} brackets are open here", most_open),
                            fmt::format("at most {} levels may nest", limits.depth));
        const bool blank_follows =
            i + 1 == text.size() || text[i + 1] == ' ' || text[i + 1] == '\n' || text[i + 1] == '\r';
        if (c == ':' && blank_follows) separators += 2;
        if ((c == ',' && open.ends_with('[')) || (c == '-' && line_begins && blank_follows)) ++separators;
        line_begins = c == '\n' || (line_begins && (c == ' ' || c == '-'));
        if (separators > limits.events)
            return diagnose(Code::too_many_events, source.place({i, i + 1}), fmt::format("more than {} YAML events", limits.events));
        if (ends_word[static_cast<unsigned char>(c)]) run = 0;
        if (run > limits.scalar_bytes)
            return diagnose(Code::scalar_too_long, source.place({i + 1 - run, i + 1}),
                            fmt::format("a word of more than {} bytes", limits.scalar_bytes));
    }
    return {};
}

/// A plain scalar's value is its text with every run of blanks and breaks folded: walk both together.
std::size_t plain_end(std::string_view text, std::size_t at, std::string_view value) {
    std::size_t end = at;
    for (const char c : value) {
        if (c == ' ' || c == '\n' || c == '\t') {
            while (at < text.size() && (is_space(text[at]) || is_break(text[at]))) ++at;
            continue;
        }
        if (at >= text.size()) break;
        end = ++at;
    }
    return end;
}

std::size_t quoted_end(std::string_view text, std::size_t at) {
    const char quote = text[at];
    for (std::size_t i = at + 1; i < text.size(); ++i) {
        if (quote == '"' && text[i] == '\\')
            ++i;
        else if (text[i] == quote) {
            if (quote == '"' || i + 1 >= text.size() || text[i + 1] != quote) return i + 1;
            ++i;
        }
    }
    return text.size();
}

/// Up to the last line that is indented deeper than what the block text belongs to.
std::size_t block_text_end(std::string_view text, std::size_t at, int indent) {
    std::size_t end = line_end(text, at);
    for (std::size_t begin = text.find('\n', end); begin != std::string_view::npos; begin = text.find('\n', begin)) {
        ++begin;
        const std::size_t content = skip_spaces(text, begin), stop = line_end(text, begin);
        if (content >= stop) continue;
        if (static_cast<int>(content - begin) <= indent) break;
        end = stop;
    }
    return end;
}

}  // namespace

Diagnostics check_text(const SourceText& source, const Limits& limits) {
    const std::string& text = source.text();
    if (text.size() > limits.file_bytes)
        return {diagnose(Code::file_too_large, source.place({0, 0}),
                         fmt::format("the file has {} bytes; at most {} are read", text.size(), limits.file_bytes))};
    // Before UTF-16, whose mark is the beginning of this one's.
    if (text.starts_with(std::string_view("\xFF\xFE\0\0", 4)) || text.starts_with(std::string_view("\0\0\xFE\xFF", 4)))
        return {diagnose(Code::not_utf8, source.place({0, 4}), "the file is UTF-32", "save it as UTF-8")};
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        return {diagnose(Code::not_utf8, source.place({0, 2}), "the file is UTF-16", "save it as UTF-8")};
    if (auto found = check_characters(source)) return {*found};
    if (auto found = check_costs(source, limits)) return {*found};
    Diagnostics out;
    check_tabs(source, out);
    return out;
}

std::size_t byte_order_mark(std::string_view text) { return text.starts_with("\xEF\xBB\xBF") ? 3 : 0; }

std::size_t skip_spaces(std::string_view text, std::size_t at) {
    while (at < text.size() && is_space(text[at])) ++at;
    return at;
}

std::size_t skip_blank(std::string_view text, std::size_t at) {
    while (at < text.size()) {
        if (is_space(text[at]) || is_break(text[at]))
            ++at;
        else if (text[at] == '#' && (at == 0 || is_space(text[at - 1]) || is_break(text[at - 1])))
            at = line_end(text, at);
        else
            break;
    }
    return at;
}

std::size_t skip_properties(std::string_view text, std::size_t at) {
    while (at < text.size() && (text[at] == '&' || text[at] == '!')) {
        while (at < text.size() && !is_space(text[at]) && !is_break(text[at])) ++at;
        at = skip_blank(text, at);
    }
    return at;
}

std::size_t line_end(std::string_view text, std::size_t at) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    return end > at && text[end - 1] == '\r' ? end - 1 : end;
}

std::size_t line_begin(std::string_view text, std::size_t at) {
    while (at > 0 && text[at - 1] != '\n') --at;
    return at == 0 ? byte_order_mark(text) : at;
}

YamlStyle scalar_style(std::string_view text, std::size_t at) {
    if (at >= text.size()) return YamlStyle::plain;
    switch (text[at]) {
        case '"': return YamlStyle::double_quoted;
        case '\'': return YamlStyle::single_quoted;
        case '|':
        case '>': return YamlStyle::block_text;
        default: return YamlStyle::plain;
    }
}

std::size_t scalar_end(std::string_view text, std::size_t at, YamlStyle style, std::string_view value, int indent) {
    if (style == YamlStyle::plain) return plain_end(text, at, value);
    if (style == YamlStyle::block_text) return block_text_end(text, at, indent);
    return quoted_end(text, at);
}

std::size_t null_word(std::string_view text, std::size_t at) {
    std::size_t length = 0;
    for (const std::string_view word : {"~", "null", "Null", "NULL"})
        if (text.substr(at).starts_with(word)) length = word.size();
    if (length == 0) return 0;
    std::size_t before = at;
    while (before > 0 && is_space(text[before - 1])) --before;
    const bool follows =
        before > byte_order_mark(text) && std::string_view("-:,[{?").find(text[before - 1]) != std::string_view::npos;
    return follows ? length : 0;
}

Span value_with_colon(std::string_view text, std::size_t at) {
    constexpr std::string_view ends = ",[]{}\"'#\r\n";  // of an entry that is nothing but words
    at = std::min(at, text.size());
    const std::size_t before = at == 0 ? std::string_view::npos : text.find_last_of(ends, at - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1,
                      stop = std::min(text.find_first_of(ends, at), text.size());
    const std::string_view entry = text.substr(begin, stop - begin);
    const std::size_t colon = entry.find(": ");
    if (colon == std::string_view::npos) return {at, at};
    const std::size_t value = skip_spaces(text, begin + colon + 1), last = text.find_last_not_of(" \t", stop - 1);
    const bool second = text.substr(value, stop - value).find(": ") != std::string_view::npos;
    return second ? Span{value, last + 1} : Span{at, at};
}

std::optional<std::size_t> color_in_comment(std::string_view text, std::size_t begin, std::size_t end) {
    const auto is_hex = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    };
    for (std::size_t i = begin; i < end; ++i) {
        if (text[i] != '#' || i == 0 || !is_space(text[i - 1])) continue;
        std::size_t digits = i + 1;
        while (digits < end && is_hex(text[digits])) ++digits;
        const std::size_t count = digits - i - 1;
        const bool word_ends =
            digits >= text.size() || std::string_view(" \t\r\n,]}\"'").find(text[digits]) != std::string_view::npos;
        if ((count == 3 || count == 6) && word_ends) return i;
        i = line_end(text, i);  // the rest of the line is comment
    }
    return {};
}

}  // namespace pinfield

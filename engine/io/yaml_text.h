// Looking at the bytes of a YAML text: the checks before it is parsed, and the ends of what the parser gives only a
// start for.
#pragma once
#include <optional>
#include <string_view>

#include "engine/core/diagnostic.h"
#include "engine/io/limits.h"
#include "engine/io/yaml_tree.h"

namespace pinfield {

/// Whatever makes a text unfit for the parser: size, encoding, control characters, tabs, brackets nested absurdly deep.
/// Stops at the first finding of a kind that makes the rest meaningless.
Diagnostics check_text(const SourceText& source, const Limits& limits);

/// 3 when the text begins with a byte order mark, else 0.
std::size_t byte_order_mark(std::string_view text);

/// Skips blanks, line breaks and comments.
std::size_t skip_blank(std::string_view text, std::size_t at);
/// Skips anchors and tags and the blanks after them.
std::size_t skip_properties(std::string_view text, std::size_t at);
/// Skips blanks within the line.
std::size_t skip_spaces(std::string_view text, std::size_t at);
/// End of the line that holds `at`, before its line break.
std::size_t line_end(std::string_view text, std::size_t at);
std::size_t line_begin(std::string_view text, std::size_t at);

/// How the scalar that begins at `at` is written.
YamlStyle scalar_style(std::string_view text, std::size_t at);
/// End of the scalar that begins at `at` and has this value; `indent` is the column of the key or dash it belongs to
/// (-1: none).
std::size_t scalar_end(std::string_view text, std::size_t at, YamlStyle style, std::string_view value, int indent);

/// The literal words ~ and null at `at`, standing for themselves right after their key or dash: their length, else 0.
std::size_t null_word(std::string_view text, std::size_t at);

/// The value of the entry in flow style about `at` where another colon and blank stand in it ("a: b" of {name: a: b}),
/// else empty.
Span value_with_colon(std::string_view text, std::size_t at);

/// A `#` that begins a comment in [begin, end) and is followed at once by a hex color: its offset.
std::optional<std::size_t> color_in_comment(std::string_view text, std::size_t begin, std::size_t end);

}  // namespace pinfield

// A text and where things are in it.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pinfield {

/// Half-open byte range in a SourceText.
struct Span {
    std::size_t begin = 0, end = 0;
    bool operator==(const Span&) const = default;
};

/// 1-based line and column for people; columns count code points, not bytes.
struct LineColumn {
    int line = 1, column = 1;
    bool operator==(const LineColumn&) const = default;
};

/// An immutable text with a name for messages (usually its path) and an index of its lines.
class SourceText {
public:
    SourceText() : SourceText("", "") {}
    SourceText(std::string name, std::string text);

    const std::string& name() const { return name_; }
    const std::string& text() const { return text_; }
    std::string_view slice(Span span) const { return std::string_view(text_).substr(span.begin, span.end - span.begin); }
    /// Place of a byte offset; an offset past the end is the place just after the last character.
    LineColumn place(std::size_t offset) const;
    /// Line n (1-based) without its line break; empty past the end.
    std::string_view line(int n) const;
    int line_count() const { return static_cast<int>(line_starts_.size()); }

private:
    std::string name_, text_;
    std::vector<std::size_t> line_starts_;
};

}  // namespace pinfield

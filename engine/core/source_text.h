// The texts a table is made of, and where things are in them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/id.h"

namespace pinfield {

/// Half-open byte range in a SourceText.
struct Span {
    std::size_t begin = 0, end = 0;
    bool operator==(const Span&) const = default;
};

/// One of the texts of a table.
using FileId = Id<struct FileTag>;
/// The table's own file; those that it includes are numbered after it.
inline constexpr FileId main_file{1};

/// Where something stands: in which text, and which of its bytes. Without a file: nowhere, as in a scene that no text was read for.
struct Place {
    FileId file;
    Span span;
    explicit operator bool() const { return static_cast<bool>(file); }
    bool operator==(const Place&) const = default;
};

/// 1-based line and column for people; columns count code points, not bytes.
struct LineColumn {
    int line = 1, column = 1;
    bool operator==(const LineColumn&) const = default;
};

/// An immutable text with a name for messages (usually its path), its number among the texts of its table, and an index of its lines.
class SourceText {
public:
    SourceText() : SourceText("", "") {}
    SourceText(std::string name, std::string text, FileId file = main_file);

    const std::string& name() const { return name_; }
    const std::string& text() const { return text_; }
    FileId file() const { return file_; }
    Place place(Span span) const { return {file_, span}; }
    std::string_view slice(Span span) const { return std::string_view(text_).substr(span.begin, span.end - span.begin); }
    /// Of a byte offset; past the end it is that just after the last character.
    LineColumn line_column(std::size_t offset) const;
    /// Line n (1-based) without its line break; empty past the end.
    std::string_view line(int n) const;
    int line_count() const { return static_cast<int>(line_starts_.size()); }

private:
    std::string name_, text_;
    FileId file_;
    std::vector<std::size_t> line_starts_;
};

/// The texts that one table was read from, by their numbers.
class Sources {
public:
    Sources() = default;
    explicit Sources(std::shared_ptr<const SourceText> main) : texts_{std::move(main)} {}
    explicit Sources(SourceText main) : Sources(std::make_shared<const SourceText>(std::move(main))) {}

    /// The table's own file.
    const SourceText& main() const { return *texts_.front(); }
    const std::shared_ptr<const SourceText>& shared_main() const { return texts_.front(); }
    /// All of them, the table's own first.
    const std::vector<std::shared_ptr<const SourceText>>& all() const { return texts_; }

    /// The number of a text that is to be added.
    FileId next_file() const { return FileId{main_file.value + static_cast<std::uint32_t>(texts_.size())}; }
    /// A further text, of that number. `path`: what it is called in the table's folder; `asked_at`: what includes it.
    void add(std::shared_ptr<const SourceText> text, std::string path, const Place& asked_at);
    struct Included {
        std::string path;
        Place asked_at;
    };
    /// How a text comes to be one of the table's; null for the table's own, and for none.
    const Included* inclusion(FileId file) const;

    /// The text a place is in; null for nowhere.
    const SourceText* find(const Place& place) const;
    /// Of where a place begins; {1, 1} for nowhere.
    LineColumn line_column(const Place& place) const;
    /// The bytes of a place; none for nowhere.
    std::string_view slice(const Place& place) const;
    /// Where a place begins, for somebody who looks at another: "line 3" where both are in one text, else "parts/walls.yaml:3".
    std::string line_from(const Place& here, const Place& place) const;

private:
    std::vector<std::shared_ptr<const SourceText>> texts_;  ///< main_file first
    std::vector<Included> included_;                        ///< of each after it
};

/// Does it stand in a text that the table includes?
inline bool is_included(const Place& place) { return place && place.file != main_file; }

}  // namespace pinfield

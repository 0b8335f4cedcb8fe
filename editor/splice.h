// One replacement of bytes in a text: what typing does, and what an edit leaves.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "engine/core/source_text.h"

namespace pinfield::editor {

/// `inserted` stands where `removed` stood.
struct Splice {
    Span removed{};
    std::string inserted{};

    /// Just behind what was put in.
    std::size_t end() const { return removed.begin + inserted.size(); }
    bool operator==(const Splice&) const = default;
};

std::string spliced(std::string_view text, const Splice& splice);
/// What takes spliced(text, splice) back to `text`.
Splice inverse(std::string_view text, const Splice& splice);
/// The smallest one that makes `after` of `before`.
Splice difference(std::string_view before, std::string_view after);
/// Where a place of the text is after the splice; one within what was removed is at the end of what came instead.
std::size_t carried(std::size_t offset, const Splice& splice);

}  // namespace pinfield::editor

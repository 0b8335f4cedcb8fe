#include "editor/splice.h"

#include <algorithm>

namespace pinfield::editor {

std::string spliced(std::string_view text, const Splice& splice) {
    std::string out;
    out.reserve(text.size() + splice.inserted.size());
    out.append(text.substr(0, splice.removed.begin)).append(splice.inserted).append(text.substr(splice.removed.end));
    return out;
}

Splice inverse(std::string_view text, const Splice& splice) {
    return {{splice.removed.begin, splice.end()}, std::string(text.substr(splice.removed.begin, splice.removed.end - splice.removed.begin))};
}

Splice difference(std::string_view before, std::string_view after) {
    const auto first = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
    const auto begin = static_cast<std::size_t>(first.first - before.begin());
    const std::string_view rest_before = before.substr(begin), rest_after = after.substr(begin);
    const auto last = std::mismatch(rest_before.rbegin(), rest_before.rend(), rest_after.rbegin(), rest_after.rend());
    const auto same = static_cast<std::size_t>(last.first - rest_before.rbegin());
    return {{begin, before.size() - same}, std::string(rest_after.substr(0, rest_after.size() - same))};
}

std::size_t carried(std::size_t offset, const Splice& splice) {
    if (offset < splice.removed.begin) return offset;
    if (offset >= splice.removed.end) return offset - splice.removed.end + splice.end();
    return splice.end();
}

}  // namespace pinfield::editor

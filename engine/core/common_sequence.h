// What two lists have in common, in the order that both have it in.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pinfield {

/// Pairs of indices, the longest such sequence: `same(i, j)` says whether item i of the one is item j of the other. What is the same at
/// both ends is found at once; where more than 4 million pairs are left between, none of those is looked at.
template <class Same>
std::vector<std::pair<std::size_t, std::size_t>> common_sequence(std::size_t rows, std::size_t columns, Same same) {
    constexpr std::size_t most_pairs = 4'000'000;
    std::vector<std::pair<std::size_t, std::size_t>> out;
    std::size_t head = 0, tail = 0;
    const std::size_t shorter = std::min(rows, columns);
    while (head < shorter && same(head, head)) out.emplace_back(head, head), ++head;
    while (tail < shorter - head && same(rows - 1 - tail, columns - 1 - tail)) ++tail;
    const std::size_t height = rows - head - tail, width = columns - head - tail;
    if (height > 0 && width > 0 && height <= most_pairs / width) {
        std::vector<std::uint32_t> lengths((height + 1) * (width + 1));
        std::vector<bool> alike(height * width);
        const auto length = [&](std::size_t r, std::size_t c) -> std::uint32_t& { return lengths[r * (width + 1) + c]; };
        for (std::size_t r = height; r-- > 0;)
            for (std::size_t c = width; c-- > 0;) {
                alike[r * width + c] = same(head + r, head + c);
                length(r, c) = alike[r * width + c] ? length(r + 1, c + 1) + 1 : std::max(length(r + 1, c), length(r, c + 1));
            }
        for (std::size_t r = 0, c = 0; r < height && c < width;) {
            if (alike[r * width + c])
                out.emplace_back(head + r++, head + c++);
            else if (length(r + 1, c) >= length(r, c + 1))
                ++r;
            else
                ++c;
        }
    }
    for (; tail > 0; --tail) out.emplace_back(rows - tail, columns - tail);
    return out;
}

}  // namespace pinfield

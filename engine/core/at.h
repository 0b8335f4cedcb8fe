// Elements by int: sizes and indices are int all over Pinfield, and the standard containers want size_t.
#pragma once
#include <cassert>
#include <cstddef>
#include <iterator>
#include <utility>

namespace pinfield {

/// Element i of a vector, array, deque, span, text or C array; i is an int or an enum that counts from 0, and must be in range.
template <class List, class Index>
constexpr decltype(auto) at(List&& list, Index i) {
    assert(static_cast<std::size_t>(i) < std::size(list) && "the index is out of range");
    return std::forward<List>(list)[static_cast<std::size_t>(i)];
}

}  // namespace pinfield

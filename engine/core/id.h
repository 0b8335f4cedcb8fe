// Ids that cannot be mixed up: NodeId is not a BallId is not an index.
#pragma once
#include <compare>
#include <cstdint>

namespace pinfield {

template <class Tag>
struct Id {
    std::uint32_t value = 0;  ///< 0 means "none"
    explicit operator bool() const { return value != 0; }
    auto operator<=>(const Id&) const = default;
};

using NodeId = Id<struct NodeTag>;

}  // namespace pinfield

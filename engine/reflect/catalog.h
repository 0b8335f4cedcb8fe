// The list of node types a program works with: a value, handed to reader, compiler and editor; never a global.
#pragma once
#include <deque>
#include <string_view>
#include <vector>

#include "engine/reflect/node_type.h"

namespace pinfield {

/// Node types in the order they were added; addresses of types are stable for the catalogue's life, so nodes may point at them.
class Catalogue {
public:
    Catalogue() = default;
    Catalogue(const Catalogue&) = delete;
    Catalogue& operator=(const Catalogue&) = delete;
    Catalogue(Catalogue&&) = default;
    Catalogue& operator=(Catalogue&&) = default;

    /// The key must be new.
    const NodeType& add(NodeType type);
    const NodeType* find(std::string_view key) const;
    const std::deque<NodeType>& types() const { return types_; }
    std::vector<std::string_view> keys() const;

private:
    std::deque<NodeType> types_;
};

}  // namespace pinfield

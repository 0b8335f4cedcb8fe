// The list of node types a program works with: a value, handed to reader, compiler and editor; never a global.
#pragma once
#include <deque>
#include <string_view>
#include <vector>

#include "engine/reflect/node_type.h"

namespace pinfield {

/// Node types in the order they were added; addresses of types are stable for the catalog's life, so nodes may point at them.
class Catalog {
public:
    Catalog() = default;
    Catalog(const Catalog&) = delete;
    Catalog& operator=(const Catalog&) = delete;
    Catalog(Catalog&&) = default;
    Catalog& operator=(Catalog&&) = default;

    /// The key must be new.
    const NodeType& add(NodeType type);
    const NodeType* find(std::string_view key) const;
    const std::deque<NodeType>& types() const { return types_; }
    std::vector<std::string_view> keys() const;

private:
    std::deque<NodeType> types_;
};

}  // namespace pinfield

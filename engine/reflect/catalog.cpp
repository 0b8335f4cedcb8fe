#include "engine/reflect/catalog.h"

#include <cassert>

namespace pinfield {

const NodeType& Catalog::add(NodeType type) {
    assert(find(type.key()) == nullptr && "a catalog holds every key once");
    types_.push_back(std::move(type));
    return types_.back();
}

const NodeType* Catalog::find(std::string_view key) const {
    for (const NodeType& type : types_)
        if (type.key() == key) return &type;
    return nullptr;
}

std::vector<std::string_view> Catalog::keys() const {
    std::vector<std::string_view> out;
    for (const NodeType& type : types_) out.push_back(type.key());
    return out;
}

}  // namespace pinfield

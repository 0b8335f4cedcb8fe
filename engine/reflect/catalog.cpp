#include "engine/reflect/catalogue.h"

#include <cassert>

namespace pinfield {

const NodeType& Catalogue::add(NodeType type) {
    assert(find(type.key()) == nullptr && "a catalogue holds every key once");
    types_.push_back(std::move(type));
    return types_.back();
}

const NodeType* Catalogue::find(std::string_view key) const {
    for (const NodeType& type : types_)
        if (type.key() == key) return &type;
    return nullptr;
}

std::vector<std::string_view> Catalogue::keys() const {
    std::vector<std::string_view> out;
    for (const NodeType& type : types_) out.push_back(type.key());
    return out;
}

}  // namespace pinfield

#include "engine/io/names.h"

namespace pinfield {

const NamedValue* Names::find(std::string_view name) const {
    const auto own = own_.find(name);
    if (own == own_.end()) return outer_ ? outer_->find(name) : nullptr;
    used_.emplace(name);
    return &own->second;
}

std::vector<std::string_view> Names::all(NamedValue::Kind kind) const {
    std::vector<std::string_view> out = outer_ ? outer_->all(kind) : std::vector<std::string_view>();
    for (const auto& [name, value] : own_)
        if (value.kind == kind) out.push_back(name);
    return out;
}

}  // namespace pinfield

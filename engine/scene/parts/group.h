#pragma once
#include "engine/reflect/describe.h"
#include "engine/scene/part_traits.h"

namespace pinfield::parts {

/// Scene nodes that move and are named together; not an operator: its children may be parts.
struct Group {
    static constexpr Role role = Role::group;

    static constexpr auto describe() {
        return part<Group>({.key = "group", .children = {0, any_number}, .doc = "Scene nodes that are placed and named together."},
                           fields());
    }
};

}  // namespace pinfield::parts

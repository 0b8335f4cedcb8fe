#pragma once
#include "engine/reflect/describe.h"
#include "engine/scene/part_traits.h"

namespace pinfield::parts {

/// Where balls may be: the union of the children. All of the plane outside it is solid.
struct Domain {
    static constexpr Role role = Role::domain;

    static constexpr auto describe() {
        return part<Domain>({.key = "domain",
                             .children = {1, any_number},
                             .doc = "Where balls may be: the union of its children; everything outside is solid."},
                            fields());
    }
};

}  // namespace pinfield::parts

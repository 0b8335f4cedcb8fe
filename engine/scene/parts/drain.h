#pragma once
#include <array>
#include <string_view>

#include "engine/reflect/describe.h"
#include "engine/scene/part_traits.h"
#include "engine/sdf/forward.h"

namespace pinfield::parts {

/// Takes a ball out of play when its centre enters.
struct Drain {
    Point<double> size{0.1, 0.02};

    static constexpr Role role = Role::sensor;
    static constexpr std::array<std::string_view, 1> only_customary{"size"};
    template <template <class> class Shape = sdf::Box>
    Shape<double> customary_shape() const { return {size, 0.0}; }

    static constexpr auto describe() {
        return part<Drain>({.key = "drain", .children = {0, any_number}, .doc = "Takes a ball out of play when its centre enters."},
                           fields(field("size", &Drain::size,
                                        {.unit = Unit::metre,
                                         .min = above(0),
                                         .step = 0.001,
                                         .doc = "Width and height of the customary box; children replace it."})));
    }
};

}  // namespace pinfield::parts

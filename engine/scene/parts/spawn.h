#pragma once
#include "engine/reflect/describe.h"
#include "engine/scene/part_traits.h"

namespace pinfield::parts {

/// A place where a ball starts.
struct Spawn {
    Point<double> velocity{0, 0};

    static constexpr Role role = Role::sensor;

    static constexpr auto describe() {
        return part<Spawn>({.key = "spawn", .doc = "A place where a ball starts, and where it comes back after a drain."},
                           fields(field("velocity", &Spawn::velocity,
                                        {.unit = Unit::metre_per_second, .step = 0.05, .doc = "Of the ball at the start."})));
    }
};

}  // namespace pinfield::parts

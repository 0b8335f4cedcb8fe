// What the compiler must know of a part's type; filled by catalog.cpp from the part's struct.
#pragma once
#include <string_view>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/sdf/kernels.h"

namespace pinfield {

/// solid: belongs to the static field. domain: the field outside its shape is solid.
/// mover: a solid with a rigid motion of its own, compiled apart. sensor: notices balls, never in the field.
/// group: only a place for the scene nodes in it.
enum class Role : unsigned char { solid, domain, mover, sensor, group };

/// A shape with packed parameters in the part's local frame.
struct CustomaryShape {
    const sdf::Kernels* kernels = nullptr;  ///< null: the part has none (it needs children, or is only a place)
    std::vector<double> params;             ///< derived values included
    Similarity part_from_shape{};
};

struct PartTraits {
    Role role = Role::solid;
    bool slides = false;  ///< of a mover: it slides along its local y axis; false: it turns about its local origin
    /// Fields of nothing but the customary shape: children in its place leave them nothing to do.
    std::vector<std::string_view> only_customary{};
    /// The shape of a part without children, from the part's packed block.
    CustomaryShape (*customary_shape)(const double* params) = nullptr;
};

}  // namespace pinfield

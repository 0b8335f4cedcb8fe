// The zero line of any field, found without knowing its outline: what the distance of an operation, or of a shape without an outline
// of its own, is measured against. It trusts the field's sign alone, and its claimed Lipschitz constant to skip empty places.
#pragma once
#include <functional>

#include "engine/core/geometry.h"
#include "engine/sdf/outline.h"

namespace pinfield::conformance {

struct ZeroLineOptions {
    Box2 window{};         ///< what lies outside is not found
    double leaf = 0;       ///< metres: parts of the solid thinner than this may be missed
    double tolerance = 0;  ///< metres: how far a chord may stray from the line
    double lipschitz = 1;
};

/// Chords of the line, in no order and no direction.
sdf::Outline zero_line(const std::function<double(const Vec2&)>& field, const ZeroLineOptions& options);

}  // namespace pinfield::conformance

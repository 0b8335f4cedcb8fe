// How fast a formula changes, proved by boxes: what makes a bound of the distance of it.
#pragma once
#include <string_view>

#include <tl/expected.hpp>

#include "engine/core/geometry.h"
#include "engine/reflect/text_fault.h"
#include "engine/sdf/steps.h"
#include "engine/sdf/watched.h"

namespace pinfield::sdf {

/// Cut off at `level` above and below, the formula changes by no more than `lipschitz` times the way, everywhere in its window.
struct Steepness {
    double lipschitz = 1;
    double level = 0;  ///< metres; it is nowhere cut where it is 0
};

/// The window: a rectangle about the origin, full size in metres; what is proved holds a hair beyond it, for floats. The level is the one that
/// lets the bound reach farthest: far from its zero line a formula may be steep, or jump. The fault names the part of `text` that is without a
/// value somewhere, or jumps or is without end steep where the zero line may be; the text may be left out, and is then not quoted.
tl::expected<Steepness, TextFault> steepness_of(const Steps& formula, const Vec2& window, std::string_view text);

/// A box that holds where in the window the formula is not above `level` metres, hardly larger; empty where that is nowhere.
Box2 box_below(const Steps& formula, const Vec2& window, double level);

/// What the formula can be over a box within its window.
Watched look(const Steps& formula, const Box2& box);

}  // namespace pinfield::sdf

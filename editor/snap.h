// Snapping: which small push brings the edges and middles of what is moved in line with those of what stands. No window, no ImGui.
#pragma once
#include <span>
#include <vector>

#include "engine/core/geometry.h"

namespace pinfield::editor {

/// A line that shows why something stopped where it did: both boxes touch it.
struct Guide {
    Vec2 a{0, 0}, b{0, 0};
};

struct Snap {
    Vec2 push{0, 0};                ///< to be added to the motion, metres
    bool axis[2] = {false, false};  ///< which of its components are held by a guide
    std::vector<Guide> guides;      ///< for the box after the push
};

/// `moved`: the box of what is moved, where the hand wants it. Its edges and middle come in line with those of `others`, in each axis with
/// the nearest within `reach`, the one that lies closest where several are as near.
Snap snap(const Box2& moved, std::span<const Box2> others, double reach);

}  // namespace pinfield::editor

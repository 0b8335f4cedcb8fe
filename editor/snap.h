// Snapping: which small push brings the edges and middles of what is moved in line with those of what stands, or makes its gaps to its
// neighbours equal. No window, no ImGui.
#pragma once
#include <span>
#include <vector>

#include "engine/core/geometry.h"

namespace pinfield::editor {

/// Why something stopped where it did. line: both boxes touch it. gap: one of several gaps of the same width, across which it lies.
struct SnapLine {
    enum class Kind : unsigned char { line, gap };
    Vec2 a{0, 0}, b{0, 0};
    Kind kind = Kind::line;
};

struct Snap {
    Vec2 push{0, 0};                ///< to be added to the motion, metres
    bool axis[2] = {false, false};  ///< which of its components are held
    std::vector<SnapLine> lines;    ///< for the box after the push
};

/// What snapping is to look for.
struct SnapWish {
    bool along[2] = {true, true};  ///< pushes along x and along y
    bool gaps = true;              ///< equal ones, too
};

/// `moved`: the box of what is moved, where the hand wants it. In each axis the least push within `reach` is taken that brings one of its
/// edges or its middle in line with one of `others`, or that makes two gaps equal: of `moved` to its neighbours on both sides, or to a
/// neighbour and that one's to the next beyond. Neighbours share some of their extent along the other axis with `moved` and with each
/// other, and nothing of that row begins or ends between them. Of equal pushes, lines come before gaps, and of lines those to what is
/// nearest.
Snap snap(const Box2& moved, std::span<const Box2> others, double reach, const SnapWish& wish = {});

}  // namespace pinfield::editor

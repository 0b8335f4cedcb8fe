// How much room there is: between what is moved and what stands about it, and along a line. By the program's own distances. No window, no
// ImGui.
#pragma once
#include <optional>
#include <vector>

#include "editor/app_state.h"

namespace pinfield::editor {

/// Where two solids come nearest to each other.
struct NarrowGap {
    double width = 0;       ///< metres
    Vec2 a{0, 0}, b{0, 0};  ///< on what is moved; on the other
    NodeId other;
};

/// The narrowest place at which a ball of this diameter does not fit between the solids of these nodes (or, of a child, the solid it is
/// part of, near the child) and the other solids, as they stand now. Where they touch is no gap, nor does a corner that leads to such a
/// place count.
std::optional<NarrowGap> narrowest_gap(const AppState& state, const std::vector<NodeId>& moved, double diameter);

/// A part of a line that lies outside of all solids, in metres from its start; `closed`: it ends at a solid on both sides.
struct FreeStretch {
    double begin = 0, end = 0;
    bool closed = false;
    double length() const { return end - begin; }
};
std::vector<FreeStretch> free_stretches(const World& world, const Vec2& from, const Vec2& to);

/// What a hand at this place means to measure from: the middle of a node or of the table within `reach`, else an edge within it, else where
/// the grid says (0: none).
Vec2 measured_place(const AppState& state, const Vec2& hand, double reach, double grid);

}  // namespace pinfield::editor

// Rulers and guides: lines across the table that an author puts there to work by. They are the view's, never the table's text. No window,
// no ImGui.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/geometry.h"

namespace pinfield::editor {

struct Guide {
    int axis = 0;   ///< 0: upright, at an x; 1: level, at a y
    double at = 0;  ///< metres
    bool operator==(const Guide&) const = default;
};

/// The guide nearest to a point of the table, within `reach` metres of it.
std::optional<std::size_t> guide_at(std::span<const Guide> guides, const Vec2& world, double reach);

/// Where a guide in the hand lies: in line with an edge or middle of a box within `reach`, else on the grid (0: none).
double guide_place(double hand, int axis, std::span<const Box2> boxes, double reach, double grid);

/// Guides as boxes without extent, as long as the table: what is moved comes in line with them as with edges.
std::vector<Box2> boxes_of(std::span<const Guide> guides, const Vec2& table);

/// What a ruler shows: a labelled tick every `step` metres, each step parted by `parts` - 1 small ones.
struct RulerScale {
    double step = 0.1;
    int parts = 10;
    /// The label of the i-th labelled tick: metres where steps are whole metres, else millimetres.
    std::string label(long long i) const;
    const char* unit() const { return step >= 1 ? "m" : "mm"; }
};

/// The least round step (1, 2 or 5 of a power of ten) whose labels are at least `least_pixels` apart; small ticks are at least 4 pixels
/// apart.
RulerScale ruler_scale(double pixels_per_metre, double least_pixels);

}  // namespace pinfield::editor

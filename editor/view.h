// What the viewport shows: style, zoom and pan. World metres on one side, window pixels (y down) on the other.
#pragma once
#include "engine/core/geometry.h"

namespace pinfield::editor {

enum class ViewStyle : unsigned char { shaded, isolines };

struct View {
    ViewStyle style = ViewStyle::shaded;
    Vec2 centre{0.26, 0.53};       ///< world point in the middle of the viewport
    double pixels_per_metre = 800;
    Vec2 origin{0, 0}, size{1, 1};  ///< of the viewport in the window, pixels

    Vec2 pixel_from_world(const Vec2& p) const {
        return {origin.x() + 0.5 * size.x() + (p.x() - centre.x()) * pixels_per_metre,
                origin.y() + 0.5 * size.y() - (p.y() - centre.y()) * pixels_per_metre};
    }
    Vec2 world_from_pixel(const Vec2& q) const {
        return {centre.x() + (q.x() - origin.x() - 0.5 * size.x()) / pixels_per_metre,
                centre.y() - (q.y() - origin.y() - 0.5 * size.y()) / pixels_per_metre};
    }
    Box2 window() const {  ///< world box that the viewport shows
        const Vec2 half = 0.5 * size / pixels_per_metre;
        return {centre - half, centre + half};
    }
    double farthest = 10;  ///< pixels a metre that are never gone below: a table stays to be seen

    /// Shows the whole box with a margin.
    void frame(const Box2& world);
    /// Likewise the table, which from now on is never shown smaller than a tenth of that.
    void frame_table(const Box2& table);
    /// The viewport has another size: a table that was shown whole is so still, else as much of the height is seen as before.
    void resize(const Vec2& to, const Box2& table);
    /// Zooms by a factor and keeps the world point under this pixel where it is.
    void zoom_at(const Vec2& pixel, double factor);
};

}  // namespace pinfield::editor

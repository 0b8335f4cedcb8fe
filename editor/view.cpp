#include "editor/view.h"

#include <algorithm>
#include <cmath>

namespace pinfield::editor {
namespace {

constexpr double margin = 0.04;  ///< of the viewport's size, on every side
constexpr double most_pixels_per_metre = 200'000;
constexpr double farthest_share = 0.1;  ///< of the size at which the table fits the view

double kept_in_range(double pixels_per_metre, double least) { return std::clamp(pixels_per_metre, std::min(least, most_pixels_per_metre), most_pixels_per_metre); }

}  // namespace

void View::frame(const Box2& world) {
    if (world.is_empty() || !world.is_finite()) return;
    centre = world.centre();
    const Vec2 room = (1 - 2 * margin) * size;
    const Vec2 wanted = world.size().cwiseMax(Vec2(1e-3, 1e-3));
    pixels_per_metre = kept_in_range(std::min(room.x() / wanted.x(), room.y() / wanted.y()), farthest);
}

void View::frame_table(const Box2& table) {
    farthest = 0;
    frame(table);
    farthest = farthest_share * pixels_per_metre;
}

void View::resize(const Vec2& to, const Box2& table) {
    View framed = *this;
    framed.frame_table(table);
    const bool whole = length(framed.centre - centre) < 1e-9 && std::fabs(framed.pixels_per_metre / pixels_per_metre - 1) < 1e-9;
    const double taller = size.y() > 0 ? to.y() / size.y() : 1;
    size = to;
    if (whole) frame_table(table);
    else pixels_per_metre *= std::min(taller, 1e3);
}

void View::zoom_at(const Vec2& pixel, double factor) {
    const Vec2 kept = world_from_pixel(pixel);
    pixels_per_metre = kept_in_range(pixels_per_metre * factor, farthest);
    centre += kept - world_from_pixel(pixel);
}

}  // namespace pinfield::editor

#include "editor/view.h"

#include <algorithm>

namespace pinfield::editor {
namespace {

constexpr double margin = 0.04;  ///< of the viewport's size, on every side
constexpr double least_pixels_per_metre = 10, most_pixels_per_metre = 200'000;

double kept_in_range(double pixels_per_metre) { return std::clamp(pixels_per_metre, least_pixels_per_metre, most_pixels_per_metre); }

}  // namespace

void View::frame(const Box2& world) {
    if (world.is_empty() || !world.is_finite()) return;
    centre = world.centre();
    const Vec2 room = (1 - 2 * margin) * size;
    const Vec2 wanted = world.size().cwiseMax(Vec2(1e-3, 1e-3));
    pixels_per_metre = kept_in_range(std::min(room.x() / wanted.x(), room.y() / wanted.y()));
}

void View::zoom_at(const Vec2& pixel, double factor) {
    const Vec2 kept = world_from_pixel(pixel);
    pixels_per_metre = kept_in_range(pixels_per_metre * factor);
    centre += kept - world_from_pixel(pixel);
}

}  // namespace pinfield::editor

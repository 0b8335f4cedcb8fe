// A picture of a real playfield beneath the table, to build over: where it lies, and how two points of it are brought to their true
// distance. The picture's own frame runs from (0, 0) in the lower left corner of what is shown to (1, 1). No window, no ImGui.
#pragma once
#include <string>
#include <string_view>

#include "engine/core/geometry.h"

namespace pinfield::editor {

inline constexpr double least_underlay = 0.01, most_underlay = 50;  ///< its width and height, metres
inline constexpr double farthest_underlay = 100;                    ///< of its middle, metres along an axis
inline constexpr double least_opacity = 0.05;

struct Underlay {
    std::string path{};     ///< empty: there is none
    Vec2 centre{0, 0};      ///< metres
    double width = 0;       ///< metres, as it is shown
    int quarter_turns = 0;  ///< to the left, 0 to 3
    double opacity = 0.6;
    bool shown = true;
    bool locked = false;  ///< stays where it is under the mouse
    bool operator==(const Underlay&) const = default;
};

/// Where it lies; `pixels`: the picture's size before it is turned.
Box2 box_of(const Underlay& underlay, const Vec2& pixels);
/// A place in the picture's own frame, and back.
Vec2 picture_from_world(const Box2& box, const Vec2& world);
Vec2 world_from_picture(const Box2& box, const Vec2& own);

/// All of it within the table, as large as that allows, in the middle.
Underlay fitted_to(Underlay underlay, const Vec2& pixels, const Vec2& table);
/// A quarter turn to the left about its middle, as large as before.
Underlay turned_left(Underlay underlay, const Vec2& pixels);
/// So large that the places `a` and `b` of its own frame are `distance` metres apart; `a` stays where it is. As it was where they are the
/// same place, or it would be smaller or larger than can be.
Underlay scaled_by_points(Underlay underlay, const Vec2& pixels, const Vec2& a, const Vec2& b, double distance);
/// So wide, about its middle, within what can be.
Underlay with_width(Underlay underlay, const Vec2& pixels, double width);

/// Lines of `underlay: /path/to/photo.jpg`, `underlay_width: 514mm` and so on; one that is not understood leaves what was there.
void read_underlay_line(std::string_view key, std::string_view value, Underlay& underlay);
/// All of them; nothing where there is none.
std::string write_underlay(const Underlay& underlay);

/// Whether a file is a picture, by its name.
bool is_picture(std::string_view path);

}  // namespace pinfield::editor

#include "editor/underlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/core/numbers.h"
#include "engine/io/quantity.h"

namespace pinfield::editor {
namespace {

/// Height over width, as it is shown.
double aspect_of(const Underlay& underlay, const Vec2& pixels) {
    return underlay.quarter_turns % 2 == 0 ? pixels.y() / pixels.x() : pixels.x() / pixels.y();
}

/// The widths at which neither side is smaller or larger than can be.
std::pair<double, double> widths_of(const Underlay& underlay, const Vec2& pixels) {
    const double aspect = aspect_of(underlay, pixels);
    return {least_underlay / std::min(1.0, aspect), most_underlay / std::max(1.0, aspect)};
}

std::optional<double> length_in(std::string_view text, double least, double most) {
    const QuantityResult read = read_quantity(text, Unit::metre);
    if (!read || !(read->value >= least && read->value <= most)) return {};
    return read->value;
}

/// "257mm 533mm"
void read_place(std::string_view text, Vec2& place) {
    const std::size_t space = text.find(' ');
    if (space == std::string_view::npos) return;
    const auto x = length_in(text.substr(0, space), -farthest_underlay, farthest_underlay),
               y = length_in(text.substr(space + 1), -farthest_underlay, farthest_underlay);
    if (x && y) place = {*x, *y};
}

void read_truth(std::string_view text, bool& truth) {
    if (text == "true" || text == "false") truth = text == "true";
}

}  // namespace

Box2 box_of(const Underlay& underlay, const Vec2& pixels) {
    const Vec2 half = 0.5 * underlay.width * Vec2(1, aspect_of(underlay, pixels));
    return {underlay.centre - half, underlay.centre + half};
}

Vec2 picture_from_world(const Box2& box, const Vec2& world) { return (world - box.lo).cwiseQuotient(box.size()); }
Vec2 world_from_picture(const Box2& box, const Vec2& own) { return box.lo + own.cwiseProduct(box.size()); }

Underlay fitted_to(Underlay underlay, const Vec2& pixels, const Vec2& table) {
    underlay.centre = 0.5 * table;
    return with_width(underlay, pixels, std::min(table.x(), table.y() / aspect_of(underlay, pixels)));
}

Underlay turned_left(Underlay underlay, const Vec2& pixels) {
    underlay.width *= aspect_of(underlay, pixels);
    underlay.quarter_turns = (underlay.quarter_turns + 1) % 4;
    return underlay;
}

Underlay scaled_by_points(Underlay underlay, const Vec2& pixels, const Vec2& a, const Vec2& b, double distance) {
    const Box2 before = box_of(underlay, pixels);
    const double now = length(world_from_picture(before, b) - world_from_picture(before, a)), factor = distance / now;
    const auto [least, most] = widths_of(underlay, pixels);
    if (!(now > 0) || !(factor * underlay.width >= least && factor * underlay.width <= most)) return underlay;
    const Vec2 kept = world_from_picture(before, a);
    underlay.width *= factor;
    underlay.centre = kept + factor * (underlay.centre - kept);
    return underlay;
}

Underlay with_width(Underlay underlay, const Vec2& pixels, double width) {
    const auto [least, most] = widths_of(underlay, pixels);
    underlay.width = std::min(std::max(width, least), most);
    return underlay;
}

void read_underlay_line(std::string_view key, std::string_view value, Underlay& underlay) {
    if (key == "underlay" && !value.empty()) underlay.path = value;
    if (key == "underlay_centre") read_place(value, underlay.centre);
    if (key == "underlay_width") underlay.width = length_in(value, least_underlay, most_underlay).value_or(underlay.width);
    if (key == "underlay_turns" && value.size() == 1 && value[0] >= '0' && value[0] <= '3') underlay.quarter_turns = value[0] - '0';
    if (key == "underlay_opacity")
        if (const auto opacity = parse_number(value); opacity && *opacity >= least_opacity && *opacity <= 1) underlay.opacity = *opacity;
    if (key == "underlay_shown") read_truth(value, underlay.shown);
    if (key == "underlay_locked") read_truth(value, underlay.locked);
}

std::string write_underlay(const Underlay& underlay) {
    if (underlay.path.empty()) return {};
    const auto metres = [](double x) { return write_quantity(x, Unit::metre, "1mm"); };
    return fmt::format(
        "underlay: {}\nunderlay_centre: {} {}\nunderlay_width: {}\nunderlay_turns: {}\nunderlay_opacity: {}\nunderlay_shown: {}\n"
        "underlay_locked: {}\n",
        underlay.path, metres(underlay.centre.x()), metres(underlay.centre.y()), metres(underlay.width), underlay.quarter_turns,
        to_text(underlay.opacity), underlay.shown, underlay.locked);
}

bool is_picture(std::string_view path) {
    std::string ending(path.substr(std::min(path.find_last_of('.'), path.size())));
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

}  // namespace pinfield::editor

// Two arcs between two points with given tangents: how traced outlines are fitted (Bolton, "Biarc curves", 1975).
#pragma once
#include <array>
#include <optional>

#include "engine/sdf/outline.h"

namespace pinfield {

/// The arc from a, where it runs along the unit vector `along`, to b; a segment where it bulges by less than `flat` metres.
inline sdf::Piece arc_along(const Vec2& a, const Vec2& along, const Vec2& b, double flat) {
    const Vec2 chord = b - a;
    const double square = dot(chord, chord), turning = cross(along, chord);
    if (std::fabs(turning) <= 4 * flat) return sdf::Piece::segment(a, b);  // it bulges by a quarter of that
    const double radius = 0.5 * square / turning;  // > 0: it turns left
    return sdf::Piece::arc(a + radius * perpendicular(along), std::fabs(radius), a, b, turning > 0 ? 1 : -1, dot(along, chord) < 0);
}

/// The arc from a to b, where it runs along the unit vector `along`.
inline sdf::Piece arc_arriving(const Vec2& a, const Vec2& b, const Vec2& along, double flat) {
    return reversed(arc_along(b, -along, a, flat));
}

/// The biarc whose middle is as far from both ends along their tangents; nothing where the tangents turn by a right angle or more, or
/// away from the chord.
inline std::optional<std::array<sdf::Piece, 2>> biarc(const Vec2& a, const Vec2& along_a, const Vec2& b, const Vec2& along_b, double flat) {
    const Vec2 chord = b - a;
    const double square = dot(chord, chord), forward = dot(chord, along_a + along_b), turn = 1 - dot(along_a, along_b);
    if (!(turn < 1) || !(forward > 0) || !(dot(chord, along_a) > 0) || !(dot(chord, along_b) > 0)) return std::nullopt;
    const double reach = square / (forward + std::sqrt(forward * forward + 2 * turn * square));
    const Vec2 middle = 0.5 * ((a + reach * along_a) + (b - reach * along_b));
    return std::array{arc_along(a, along_a, middle, flat), arc_arriving(middle, b, along_b, flat)};
}

}  // namespace pinfield

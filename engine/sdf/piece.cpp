#include "engine/sdf/piece.h"

#include <cmath>

#include "engine/core/trig.h"

namespace pinfield::sdf {
namespace {

Vec2 unit(const Vec2& v) {
    const double l = length(v);
    return l > 0 ? Vec2(v / l) : Vec2(0, 0);
}

PieceFoot foot_on_end(const Vec2& end, const Vec2& p, const Vec2& normal) {
    const Vec2 from_end = p - end;
    const double distance = length(from_end);
    if (distance > 0) return {end, distance, false, false, from_end / distance};
    return {end, 0, true, false, normal};
}

PieceFoot foot_on_segment(const Piece& piece, const Vec2& p) {
    const Vec2 half = 0.5 * (piece.b - piece.a), middle = 0.5 * (piece.a + piece.b), q = p - middle;
    const double along = dot(q, half), reach = dot(half, half), half_length = std::sqrt(reach);
    const Vec2 normal = half_length > 0 ? Vec2(half.y() / half_length, -half.x() / half_length) : Vec2(1, 0);
    if (along >= reach) return foot_on_end(piece.b, p, normal);
    if (along <= -reach) return foot_on_end(piece.a, p, normal);
    const double across = cross(half, q);
    return {middle + (along / reach) * half, std::fabs(across) / half_length, true, across > 0, normal};
}

PieceFoot foot_on_arc(const Piece& piece, const Vec2& p) {
    const Vec2 q = p - piece.centre;
    const double rho = length(q), outward = piece.turn > 0 ? 1.0 : -1.0;
    if (in_sweep(piece, q)) {
        const Vec2 ray = rho > 0 ? Vec2(q / rho) : Vec2((piece.a - piece.centre) / piece.radius);
        const double gap = rho - piece.radius;
        return {piece.centre + piece.radius * ray, std::fabs(gap), true, outward * gap < 0, outward * ray};
    }
    const bool at_b = dot(p - piece.b, p - piece.b) < dot(p - piece.a, p - piece.a);
    const Vec2& end = at_b ? piece.b : piece.a;
    return foot_on_end(end, p, outward * (end - piece.centre) / piece.radius);
}

}  // namespace

PieceFoot foot_on_piece(const Piece& piece, const Vec2& p) { return piece.is_arc() ? foot_on_arc(piece, p) : foot_on_segment(piece, p); }

Vec2 direction_at(const Piece& piece, const Vec2& p) {
    if (!piece.is_arc()) return unit(piece.b - piece.a);
    return piece.turn * perpendicular(unit(p - piece.centre));
}

Vec2 point_at_share(const Piece& piece, double share) {
    const Vec2 on_chord = piece.a + share * (piece.b - piece.a);
    if (!piece.is_arc()) return on_chord;
    return piece.centre + (piece.radius / length(on_chord - piece.centre)) * (on_chord - piece.centre);
}

Vec2 middle_of(const Piece& piece) {
    if (!piece.is_arc()) return 0.5 * (piece.a + piece.b);
    const Vec2 from = unit(piece.a - piece.centre), to = unit(piece.b - piece.centre);
    const Vec2 across = from - to;  // vanishes for an arc that is nearly nothing or nearly a full circle
    if (length(across) > 1e-3) return piece.centre + piece.radius * unit(piece.turn * perpendicular(across));
    return piece.centre + piece.radius * unit(piece.reflex ? Vec2(-(from + to)) : Vec2(from + to));
}

double position_along(const Piece& piece, const Vec2& p) {
    if (!piece.is_arc()) return dot(p - piece.a, piece.b - piece.a);
    const Vec2 start = piece.a - piece.centre, here = p - piece.centre;
    const double sine = piece.turn * cross(start, here), cosine = dot(start, here);
    const double share = cosine / (std::fabs(sine) + std::fabs(cosine));  // an angle in all but name: 0 ... 4 round the circle
    return sine >= 0 ? 1 - share : 3 + share;
}

Piece reversed(const Piece& piece) {
    Piece out = piece;
    std::swap(out.a, out.b);
    out.turn = -piece.turn;
    return out;
}

Piece part_of(const Piece& piece, const Vec2& from, const Vec2& to) {
    Piece out = piece;
    out.a = from;
    out.b = to;
    if (piece.is_arc()) out.reflex = piece.turn * cross(from - piece.centre, to - piece.centre) < 0;
    return out;
}

Piece transformed(const Similarity& to_from, const Piece& piece) {
    Piece out = piece;
    out.a = to_from * (to_from.mirrored ? piece.b : piece.a);
    out.b = piece.is_full_circle() ? out.a : Vec2(to_from * (to_from.mirrored ? piece.a : piece.b));
    if (!piece.is_arc()) return out;
    out.centre = to_from * piece.centre;
    out.radius = to_from.scale * piece.radius;
    return out;
}

Box2 bounds_of(const Piece& piece) {
    Box2 box = Box2::of(piece.a, piece.b);
    if (!piece.is_arc()) return box;
    for (const Vec2& ray : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)})
        if (in_sweep(piece, ray)) box = box.including(piece.centre + piece.radius * ray);
    return box;
}

double farthest_from_origin(const Piece& piece) {
    const double ends = std::max(length(piece.a), length(piece.b));
    return piece.is_arc() && in_sweep(piece, piece.centre) ? std::max(ends, length(piece.centre) + piece.radius) : ends;
}

double area_beside_chord(const Piece& arc) {
    const Vec2 from = arc.a - arc.centre, to = arc.b - arc.centre;
    double sweep = arc.turn * arc_tangent(cross(from, to), dot(from, to));
    if (sweep < (arc.reflex ? half_pi : -half_pi)) sweep += two_pi;  // rounding may have it on the other side of 0 or of half a turn
    return 0.5 * arc.turn * arc.radius * arc.radius * (sweep - sine(sweep));
}

}  // namespace pinfield::sdf

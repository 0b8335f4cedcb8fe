#include "engine/sdf/meet.h"

#include "engine/sdf/piece.h"

namespace pinfield::sdf {
namespace {

/// Up to two points.
struct Points {
    Vec2 at[2];
    int count = 0;
    void add(const Vec2& p) { at[count++] = p; }
};

Points cross_lines(const Piece& a, const Piece& b) {
    Points out;
    const Vec2 along_a = a.b - a.a, along_b = b.b - b.a;
    const double area = cross(along_a, along_b);
    // Straighter than this they part by less than the tolerance: they run along each other or not at all.
    if (std::fabs(area) <= 1e-13 * length(along_a) * length(along_b)) return out;
    out.add(a.a + (cross(b.a - a.a, along_b) / area) * along_a);
    return out;
}

/// Near a tangency the two crossings are ill-conditioned along the line and only one point is needed: what lies between
/// them is thinner than the tolerance.
Points cross_line_circle(const Piece& line, const Piece& arc, double tolerance) {
    Points out;
    const double line_length = length(line.b - line.a);
    if (!(line_length > 0)) return out;
    const Vec2 along = (line.b - line.a) / line_length;
    const double offset = cross(along, arc.centre - line.a), depth = arc.radius - std::fabs(offset);
    if (depth < -tolerance) return out;
    const Vec2 foot = line.a + dot(arc.centre - line.a, along) * along;
    if (depth < 0.25 * tolerance) {
        out.add(foot);
        return out;
    }
    const double half_chord = std::sqrt(depth * (arc.radius + std::fabs(offset)));
    out.add(foot - half_chord * along);
    out.add(foot + half_chord * along);
    return out;
}

Points cross_circles(const Piece& a, const Piece& b, double tolerance) {
    Points out;
    const double apart = length(b.centre - a.centre);
    const double beyond = apart - (a.radius + b.radius), within = std::fabs(a.radius - b.radius) - apart;
    if (apart < tolerance || beyond > tolerance || within > tolerance) return out;
    const Vec2 towards_b = (b.centre - a.centre) / apart;
    if (beyond > -0.25 * tolerance || within > -0.25 * tolerance) {
        const bool from_within = within > -0.25 * tolerance && a.radius < b.radius;
        out.add(a.centre + (from_within ? -a.radius : a.radius) * towards_b);
        return out;
    }
    const double forward = 0.5 * (apart + (a.radius - b.radius) * (a.radius + b.radius) / apart);
    const double aside = std::sqrt(std::max((a.radius - forward) * (a.radius + forward), 0.0));
    out.add(a.centre + forward * towards_b - aside * perpendicular(towards_b));
    out.add(a.centre + forward * towards_b + aside * perpendicular(towards_b));
    return out;
}

Points crossings(const Piece& a, const Piece& b, double tolerance) {
    if (a.is_arc()) return b.is_arc() ? cross_circles(a, b, tolerance) : cross_line_circle(b, a, tolerance);
    return b.is_arc() ? cross_line_circle(a, b, tolerance) : cross_lines(a, b);
}

bool close(const Vec2& p, const Vec2& q, double tolerance) { return dot(p - q, p - q) <= tolerance * tolerance; }

void cut(const Piece& piece, const Vec2& at, double tolerance, std::vector<Vec2>& cuts) {
    constexpr double apart = 4;  // tolerances between two cuts: no slivers
    if (!piece.is_full_circle() && (close(at, piece.a, apart * tolerance) || close(at, piece.b, apart * tolerance)))
        return;
    for (const Vec2& other : cuts)
        if (close(at, other, apart * tolerance)) return;
    cuts.push_back(at);
}

void cut_at_ends(const Piece& piece, const Piece& other, double tolerance, std::vector<Vec2>& cuts) {
    if (other.is_full_circle()) return;
    for (const Vec2& end : {other.a, other.b})
        if (squared_distance_to_piece(piece, end) <= tolerance * tolerance) cut(piece, end, tolerance, cuts);
}

}  // namespace

void meet(const Piece& a, const Piece& b, double tolerance, std::vector<Vec2>& cuts_of_a,
          std::vector<Vec2>& cuts_of_b) {
    cut_at_ends(a, b, tolerance, cuts_of_a);
    cut_at_ends(b, a, tolerance, cuts_of_b);
    const Points points = crossings(a, b, tolerance);
    for (int i = 0; i < points.count; ++i) {
        const Vec2& at = points.at[i];
        if (squared_distance_to_piece(a, at) > tolerance * tolerance) continue;
        if (squared_distance_to_piece(b, at) > tolerance * tolerance) continue;
        cut(a, at, tolerance, cuts_of_a);
        cut(b, at, tolerance, cuts_of_b);
    }
}

}  // namespace pinfield::sdf

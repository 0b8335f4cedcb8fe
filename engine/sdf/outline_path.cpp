#include "engine/sdf/outline_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/sdf/outline_distance.h"
#include "engine/sdf/piece.h"

namespace pinfield::sdf {
namespace {

Vec2 unit(const Vec2& v) {
    const double l = length(v);
    return l > 0 ? Vec2(v / l) : Vec2(0, 0);
}
Vec2 right_of(const Vec2& v) { return {v.y(), -v.x()}; }

/// Arcs of more than half a turn cut in two: beside such an arc is not between two half planes.
Outline without_reflex(const Outline& outline) {
    Outline out;
    for (const Piece& piece : outline) {
        if (!piece.is_arc() || !piece.reflex || piece.is_full_circle()) {
            out.push_back(piece);
            continue;
        }
        const Vec2 middle = middle_of(piece);
        out.push_back(Piece::arc(piece.centre, piece.radius, piece.a, middle, piece.turn, false));
        out.push_back(Piece::arc(piece.centre, piece.radius, middle, piece.b, piece.turn, false));
    }
    return out;
}

/// How far to turn counter-clockwise from one unit direction to another: grows with the angle, 0 ... 4.
double turn_between(const Vec2& from, const Vec2& to) {
    const double c = dot(from, to);
    return cross(from, to) >= 0 ? 1 - c : 3 + c;
}

/// The piece that ends where this one starts, to within `tolerance`. Where several do, loops touch there: the solid to the left of this
/// piece is bounded by the one whose way back comes first, counter-clockwise.
const Piece& before(const Outline& pieces, std::size_t i, double tolerance) {
    const Piece& piece = pieces[i];
    const Vec2 leaving = direction_at(piece, piece.a);
    const Piece* found = &piece;
    double least = infinity;
    for (const Piece& other : pieces) {
        if (other.is_full_circle() || length(other.b - piece.a) > tolerance) continue;
        const double turn = turn_between(leaving, -direction_at(other, other.b));
        if (turn < least) least = turn, found = &other;
    }
    return *found;
}

/// Out of the solid, halfway between the normals of the piece that arrives at a corner and the one that leaves it. Where they are
/// opposite the solid is a spike, or so is what surrounds it.
Vec2 corner_direction(const Vec2& arriving, const Vec2& leaving) {
    const Vec2 sum = right_of(arriving) + right_of(leaving);
    if (length(sum) > 1e-9) return unit(sum);
    return cross(arriving, leaving) >= 0 ? arriving : Vec2(-arriving);
}

PackedPiece packed(const Outline& pieces, std::size_t i, double tolerance) {
    const Piece& piece = pieces[i];
    PackedPiece out{};
    out.ax = piece.a.x(), out.ay = piece.a.y(), out.bx = piece.b.x(), out.by = piece.b.y();
    const Vec2 leaving = direction_at(piece, piece.a), normal = right_of(leaving);
    out.apex_x = piece.a.x(), out.apex_y = piece.a.y(), out.normal_x = normal.x(), out.normal_y = normal.y();
    out.curvature = piece.is_arc() ? piece.turn / piece.radius : 0;
    if (piece.is_full_circle()) return out;
    const Vec2 arriving = direction_at(piece, piece.b);
    out.start_x = leaving.x(), out.start_y = leaving.y(), out.end_x = arriving.x(), out.end_y = arriving.y();
    const Piece& last = before(pieces, i, tolerance);
    const Vec2 corner = corner_direction(direction_at(last, last.b), leaving);
    out.corner_x = corner.x(), out.corner_y = corner.y();
    return out;
}

}  // namespace

Box2 bounds_of(const Outline& outline) {
    Box2 box;
    for (const Piece& piece : outline) box = box.merged(bounds_of(piece));
    return box;
}

void pack_outline(const Outline& outline, int most_pieces, double* out) {
    Outline pieces = without_reflex(outline);
    assert(static_cast<int>(pieces.size()) <= 2 * most_pieces && "the shape's most_pieces is too small");
    if (static_cast<int>(pieces.size()) > 2 * most_pieces) pieces.resize(2 * static_cast<std::size_t>(most_pieces));
    const Box2 box = bounds_of(outline);
    *out++ = static_cast<double>(pieces.size());
    const double size = pieces.empty() ? 0 : std::max(box.lo.cwiseAbs().maxCoeff(), box.hi.cwiseAbs().maxCoeff());
    *out++ = size;
    *out++ = 0;  // no boxes
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const PackedPiece c = packed(pieces, i, 1e-11 * size);
        for (const double v : {c.ax, c.ay, c.start_x, c.start_y, c.bx, c.by, c.end_x, c.end_y, c.apex_x, c.apex_y, c.normal_x, c.normal_y,
                               c.curvature, c.corner_x, c.corner_y})
            *out++ = v;
    }
}

Outline unpacked_outline(const double* packed) {
    Outline out;
    for (int i = 0; i < static_cast<int>(packed[0]); ++i) {
        const double* v = packed + packed_head_size + packed_piece_size * i;
        const Vec2 a(v[0], v[1]), start(v[2], v[3]), b(v[4], v[5]), apex(v[8], v[9]), normal(v[10], v[11]);
        const double curvature = v[12];
        if (curvature == 0) {
            out.push_back(Piece::segment(a, b));
            continue;
        }
        const bool is_full_circle = start == Vec2(0, 0);
        out.push_back(Piece::arc(apex - normal / curvature, 1 / std::fabs(curvature), a, b, curvature > 0 ? 1 : -1, is_full_circle));
    }
    return out;
}

std::vector<double> found_outline_block(const Outline& outline) {
    const int most_pieces = static_cast<int>(outline.size());
    std::vector<double> out(static_cast<std::size_t>(packed_outline_size(most_pieces)));
    pack_outline(outline, most_pieces, out.data());
    const Outline pieces = without_reflex(outline);  // as they were packed
    constexpr std::size_t group = pieces_in_a_box;
    out.resize(static_cast<std::size_t>(packed_head_size) + pieces.size() * packed_piece_size);
    if (pieces.size() <= 2 * group) return out;
    out[2] = static_cast<double>(out.size());
    for (std::size_t first = 0; first < pieces.size(); first += group) {
        Box2 box;
        for (std::size_t i = first; i < std::min(first + group, pieces.size()); ++i) box = box.merged(bounds_of(pieces[i]));
        out.insert(out.end(), {box.lo.x(), box.lo.y(), box.hi.x(), box.hi.y()});
    }
    return out;
}

}  // namespace pinfield::sdf

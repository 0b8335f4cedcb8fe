#include "engine/sdf/path_outline.h"

#include <algorithm>
#include <cmath>

#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {
namespace {

Vec2 vec(const Point<double>& p) { return {p.x, p.y}; }

Vec2 centre_of(const ArcThrough& arc) {
    return Vec2(arc.circle.apex_x, arc.circle.apex_y) - Vec2(arc.circle.normal_x, arc.circle.normal_y) / arc.circle.curvature;
}

/// From where the pen is to `to`, along the piece or beside it, on its way (forth = 1) or back (-1).
void draw(const PieceView& piece, const Vec2& to, int forth, OutlinePen& pen) {
    if (!piece.is_arc()) return pen.line_to(to);
    const ArcThrough arc = arc_of<double>(piece);
    if (arc.straight) return pen.line_to(to);
    const int turn = arc.circle.curvature > 0 ? forth : -forth;
    if (arc.closes) return pen.full_circle(centre_of(arc), turn);
    pen.arc_to(to, centre_of(arc), turn, arc.reflex);
}

Box2 bounds_of_bezier(const BezierView& curve) {
    Box2 box = Box2::of(vec(curve[0]), vec(curve.end()));
    const PowerForm c = curve.power_form();
    const auto include_turns = [&](double v1, double v2, double v3) {  // where v1 + 2 v2 t + 3 v3 t^2 is 0
        const double under_root = v2 * v2 - 3 * v3 * v1;
        if (!(under_root >= 0)) return;
        const double far = v2 < 0 ? std::sqrt(under_root) - v2 : -std::sqrt(under_root) - v2;
        for (const double t : {v1 / far, far / (3 * v3)})
            if (t > 0 && t < 1) box = box.including(vec(c.at(t)));
    };
    include_turns(c.v1.x, c.v2.x, c.v3.x);
    include_turns(c.v1.y, c.v2.y, c.v3.y);
    return box;
}

/// Where the circle is farthest out along an axis, if that is on the arc. With the normal n at the apex it is there (1 - n.axis) radii
/// farther out than the apex: half the square of the difference of two unit vectors, which stays true where the arc is flat.
Box2 bounds_of_arc(const ArcThrough& arc) {
    Box2 box = Box2::of(vec(arc.a), vec(arc.b));
    if (arc.straight) return box;
    const PackedPiece& c = arc.circle;
    const Vec2 apex(c.apex_x, c.apex_y), normal(c.normal_x, c.normal_y);
    for (const Vec2& axis : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
        const Vec2 aside = (c.curvature > 0 ? axis : Vec2(-axis)) - normal, farthest = apex + aside / c.curvature;
        const bool after_start = pinfield::dot(farthest - vec(arc.a), Vec2(c.start_x, c.start_y)) >= 0;
        const bool before_end = pinfield::dot(farthest - vec(arc.b), Vec2(c.end_x, c.end_y)) <= 0;
        if (!(arc.reflex ? after_start || before_end : after_start && before_end)) continue;
        const double out = pinfield::dot(apex, axis) + 0.5 * aside.squaredNorm() / std::fabs(c.curvature);
        const int i = axis.x() != 0 ? 0 : 1;
        if (axis[i] > 0) box.hi[i] = std::max(box.hi[i], out);
        else box.lo[i] = std::min(box.lo[i], -out);
    }
    return box;
}

}  // namespace

CurvePoint curve_point(const PieceView& piece, double t) {
    const Passage passage = passage_of<double>(piece, t);
    return {vec(passage.at), vec(passage.velocity).normalized()};
}

double top_speed_of(const PieceView& piece) {
    if (piece.is_arc()) return norm(passage_of<double>(piece, 0).velocity);
    const int degree = points_of(piece.kind);
    double top = 0;
    for (int k = 0; k < degree; ++k) top = std::max(top, degree * norm(piece[k + 1] - piece[k]));
    return top;
}

Box2 bounds_of(const PieceView& piece) { return piece.is_arc() ? bounds_of_arc(arc_of<double>(piece)) : bounds_of_bezier(piece.bezier()); }

bool joins_smoothly(const PieceView& arriving, const PieceView& leaving) {
    const Vec2 in = curve_point(arriving, 1).along, out = curve_point(leaving, 0).along;
    return std::fabs(pinfield::cross(in, out)) <= 1e-9 && pinfield::dot(in, out) > 0;
}

bool is_drawn_well(const PieceView& piece) {
    const Point<double> u = piece[1] - piece[0], v = piece[2] - piece[1];
    const ArcThrough arc = arc_of<double>(piece);
    if (!arc.reflex || arc.closes) return true;
    return !arc.straight && std::fabs(arc.circle.curvature) * std::max(norm(u), norm(v)) >= 2.0 / 100;
}

bool has_parallels(const PieceView& piece) {
    if (!piece.is_arc()) return piece.kind == PathPiece::line;
    const ArcThrough arc = arc_of<double>(piece);
    return arc.straight || arc.closes || std::fabs(arc.circle.curvature) * norm(arc.b - arc.a) > 1e-6;
}

Outline loop_along(const std::vector<PieceView>& pieces) {
    Outline out;
    OutlinePen pen(out, vec(pieces.front()[0]));
    for (const PieceView& piece : pieces) draw(piece, vec(piece.end()), 1, pen);
    pen.close();
    return out;
}

void outline_wall(const std::vector<PieceView>& pieces, double half_thickness, bool closes, Outline& out) {
    const auto beside = [&](const PieceView& piece, double t, int side) {
        const CurvePoint c = curve_point(piece, t);
        return Vec2(c.at + side * half_thickness * perpendicular(c.along));
    };
    OutlinePen right(out, beside(pieces.front(), 0, -1));
    for (const PieceView& piece : pieces) draw(piece, beside(piece, 1, -1), 1, right);
    const Vec2 back = beside(pieces.back(), 1, 1);
    OutlinePen left(out, back);
    if (closes) right.close();
    else right.arc_to(back, vec(pieces.back().end()), 1);
    for (std::size_t i = pieces.size(); i-- > 0;) draw(pieces[i], beside(pieces[i], 0, 1), -1, left);
    if (closes) left.close();
    else left.arc_to(beside(pieces.front(), 0, -1), vec(pieces.front()[0]), 1);
}

}  // namespace pinfield::sdf

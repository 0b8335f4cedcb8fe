#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/bezier_chain.h"
#include "engine/sdf/plain_stroke.h"

namespace pinfield::sdf {

/// What a path's pieces are, by ascending degree.
enum class PathPiece : unsigned char { line, quadratic, cubic };
constexpr std::array<std::string_view, 3> choice_names(PathPiece) { return {"line", "quadratic", "cubic"}; }

/// A chain of Bezier curves, each from where the last one ended: a wall along it with round ends and joints, or what it encloses by the
/// even-odd rule, closed by a straight edge where its end is not its start. A straight piece among curved ones has its middle control
/// points on its ends.
template <class Real>
struct Path {
    static constexpr int max_points = 1024;
    static constexpr double example[] = {-0.06, -0.02, -0.04, 0.05, -0.01, 0.05, 0, 0.01, 0.01, -0.03, 0.04, -0.04, 0.06, 0.02};

    PointList<Real> points{example, 7};
    PathPiece piece = PathPiece::cubic;
    bool fill = false;
    Real thickness = Real(0.01);

    int degree() const { return 1 + static_cast<int>(piece); }
    int pieces() const { return (points.count - 1) / degree(); }
    BezierView view(int i) const { return {points.xy + 2 * degree() * i, degree()}; }
    Point<double> corner(int i) const { return {points.xy[2 * i], points.xy[2 * i + 1]}; }
    /// The straight edge that closes a filled path, as coordinates to view.
    std::array<double, 4> closing_edge() const {
        const Point<double> a = corner(points.count - 1), b = corner(0);
        return {a.x, a.y, b.x, b.y};
    }

    Real distance(const Point<Real>& p) const {
        const Real unsigned_distance = norm(offset_from_foot(p));
        if (!fill) return unsigned_distance - thickness * Real(0.5);
        using Plain = decltype(frozen(Real(0)));
        const Point<Plain> q{frozen(p.x), frozen(p.y)};
        const std::array<double, 4> closing = closing_edge();
        auto inside = crosses_oddly(q, BezierView{closing.data(), 1});
        for (int i = 0; i < pieces(); ++i) inside = exactly_one(inside, crosses_oddly(q, view(i)));
        return select(inside, -unsigned_distance, unsigned_distance) - thickness * Real(0.5);
    }
    Point<Real> offset_from_foot(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        const Point<Plain> q{frozen(p.x), frozen(p.y)};
        Point<Plain> foot{Plain(corner(0).x), Plain(corner(0).y)};
        const auto offer = [&](const BezierView& curve) {
            const Point<Plain> other = nearest_on_bezier(q, curve), now = q - foot, then = q - other;
            foot = select(dot(then, then) < dot(now, now), other, foot);
        };
        for (int i = 0; i < pieces(); ++i) offer(view(i));
        const std::array<double, 4> closing = closing_edge();
        if (fill) offer({closing.data(), 1});
        return {p.x - Real(foot.x), p.y - Real(foot.y)};
    }

    /// By t from 0 to 1 over all pieces.
    CurvePoint curve_at(double t) const {
        const int i = std::min(static_cast<int>(t * pieces()), pieces() - 1);
        const PowerForm c = view(i).power_form();
        const Point<double> at = c.at(t * pieces() - i), velocity = c.velocity(t * pieces() - i);
        return {{at.x, at.y}, Vec2(velocity.x, velocity.y).normalized()};
    }
    /// A wall that overlaps itself nowhere: smooth joints, and see is_plain_stroke().
    bool is_plain_wall() const {
        double top_speed = 0;
        for (int i = 0; i < pieces(); ++i) {
            const BezierView c = view(i);
            for (int k = 0; k < degree(); ++k) top_speed = max(top_speed, degree() * norm(c[k + 1] - c[k]));
            if (i == 0) continue;
            const Point<double> arriving = view(i - 1).power_form().velocity(1), leaving = c.power_form().velocity(0);
            const double speeds = norm(arriving) * norm(leaving);
            if (!(abs(cross(arriving, leaving)) <= 1e-9 * speeds && dot(arriving, leaving) > 0)) return false;
        }
        return is_plain_stroke([this](double t) { return curve_at(t); }, top_speed * pieces(), 0.5 * thickness, [this](const Vec2& p) {
            return norm(Path<double>{{points.xy, points.count}, piece, false, 0}.offset_from_foot({p.x(), p.y()}));
        });
    }
    /// No piece runs along another: inside and outside lie on different sides of every one.
    bool is_clean_edge() const {
        const Box2 box = bounds();
        const double step = 1e-6 * box.size().maxCoeff();
        const auto separates = [&](const Vec2& at, const Vec2& along) {
            const Vec2 aside = step * perpendicular(along);
            const auto inside = [&](const Vec2& p) { return distance({p.x(), p.y()}) + 0.5 * thickness < 0; };
            return along == Vec2(0, 0) || inside(at + aside) != inside(at - aside);
        };
        for (int i = 0; i < pieces(); ++i)
            for (const double t : {0.29, 0.71}) {
                const CurvePoint c = curve_at((i + t) / pieces());
                if (!separates(c.at, c.along)) return false;
            }
        const std::array<double, 4> closing = closing_edge();
        const Vec2 from(closing[0], closing[1]), to(closing[2], closing[3]);
        return separates(0.71 * from + 0.29 * to, (to - from).normalized()) && separates(0.29 * from + 0.71 * to, (to - from).normalized());
    }
    Exactness exactness() const {
        if (!fill) return {.inside = is_plain_wall() ? Side::exact : Side::bound};
        if (!is_clean_edge()) return {.outside = Side::bound, .inside = Side::bound};
        return {.inside = thickness > 0 ? Side::bound : Side::exact};
    }

    Box2 bounds() const {
        Box2 box;
        for (int i = 0; i < pieces(); ++i) {
            const BezierView curve = view(i);
            const PowerForm c = curve.power_form();
            const auto include = [&](const Point<double>& p) { box = box.including({p.x, p.y}); };
            include(curve[0]);
            include(curve.end());
            const auto include_turns = [&](double v1, double v2, double v3) {  // where v1 + 2 v2 t + 3 v3 t^2 is 0
                const double under_root = v2 * v2 - 3 * v3 * v1;
                if (!(under_root >= 0)) return;
                const double far = v2 < 0 ? sqrt(under_root) - v2 : -sqrt(under_root) - v2;
                for (const double t : {v1 / far, far / (3 * v3)})
                    if (t > 0 && t < 1) include(c.at(t));
            };
            include_turns(c.v1.x, c.v2.x, c.v3.x);
            include_turns(c.v1.y, c.v2.y, c.v3.y);
        }
        return box.grown(0.5 * thickness);
    }
    /// Of filled paths without a rim.
    void trace(int points_of_piece, std::vector<Vec2>& out) const {
        if (!fill || thickness > 0 || !is_clean_edge()) return;
        for (int i = 0; i < pieces(); ++i) {
            const PowerForm c = view(i).power_form();
            trace_piece(points_of_piece, [&](double t) { return Vec2(c.at(t).x, c.at(t).y); }, out);
        }
        const std::array<double, 4> closing = closing_edge();
        const Vec2 from(closing[0], closing[1]), to(closing[2], closing[3]);
        if (from != to) trace_piece(points_of_piece, [&](double t) { return Vec2(from + t * (to - from)); }, out);
    }

    static constexpr auto describe() {
        return shape<Path>(
            {.key = "path", .float_error = 5e-6, .doc = "Wall along a chain of lines or Bezier curves, or the region it encloses."},
            fields(field("points", &Path::points,
                         {.unit = Unit::metre,
                          .step = 0.001,
                          .required = true,
                          .doc = "The start, then for each piece its control points and its end: 1 point for a line, 2 for a quadratic, 3 "
                                 "for a cubic piece."}),
                   field("piece", &Path::piece, {.doc = "What the pieces are."}),
                   field("fill", &Path::fill,
                         {.doc = "Solid is what the path encloses, closed by a straight edge, instead of a wall along it."}),
                   field("thickness", &Path::thickness,
                         {.unit = Unit::metre,
                          .min = from(0),
                          .step = 0.0005,
                          .doc = "Full width of the wall, or of a wall along the edge of what is filled."})),
            contract("at least one piece", [](const auto& path) { return path.points.count > path.degree(); }),
            contract("1 point, then as many for each piece as it takes",
                     [](const auto& path) { return (path.points.count - 1) % path.degree() == 0; }),
            contract("at most 1024 points", [](const auto& path) { return path.points.count <= max_points; }),
            contract("a wall has a thickness", [](const auto& path) { return path.fill || path.thickness > 0; }));
    }
};

}  // namespace pinfield::sdf

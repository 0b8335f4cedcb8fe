#pragma once
#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/path_outline.h"
#include "engine/sdf/path_piece.h"
#include "engine/sdf/plain_stroke.h"
#include "engine/sdf/simple_outline.h"

namespace pinfield::sdf {

/// A chain of lines, arcs and Bezier curves, each from where the last one ended: a wall along it with round ends and joints, or what it
/// encloses by the even-odd rule, closed by a straight edge where its end is not its start. Where every piece is a line or an arc, and
/// none meets another but at their joint, its boundary is one of lines and arcs, too.
template <class Real>
struct Path {
    static constexpr int max_points = 1024;
    static constexpr double example[] = {-0.06, -0.02, -0.04, 0.05, -0.01, 0.05, 0, 0.01, 0.01, -0.03, 0.04, -0.04, 0.06, 0.02};
    static constexpr double example_pieces[] = {3};

    PointList<Real> points{example, 7};
    ChoiceList<PathPiece> pieces{example_pieces, 1};
    bool fill = false;
    Real thickness = Real(0.01);

    Point<double> corner(int i) const { return {points.xy[2 * i], points.xy[2 * i + 1]}; }
    /// visit(PieceView) for each piece in order; the index of the last point that was reached.
    template <class Visit>
    int for_each_piece(const Visit& visit) const {
        int at = 0;
        for (int i = 0; pieces.count > 0 && at + points_of(pieces[i]) < points.count; i = i + 1 < pieces.count ? i + 1 : 0) {
            visit(PieceView{points.xy + 2 * at, pieces[i]});
            at += points_of(pieces[i]);
        }
        return at;
    }
    std::vector<PieceView> views() const {
        std::vector<PieceView> out;
        for_each_piece([&](const PieceView& piece) { out.push_back(piece); });
        return out;
    }
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
        auto inside = crosses_oddly(q, PieceView{closing.data(), PathPiece::line});
        for_each_piece([&](const PieceView& piece) { inside = exactly_one(inside, crosses_oddly(q, piece)); });
        const Real distance_to_edge = select(inside, -unsigned_distance, unsigned_distance);
        if constexpr (std::is_same_v<Plain, double> && !std::is_same_v<Real, double>) {
            const double close = 1e-9 * farthest_coordinate(q);
            if (frozen(unsigned_distance) <= close)
                return gradient_across_edge(p, frozen(distance_to_edge), 100 * close) - thickness * Real(0.5);
        }
        return distance_to_edge - thickness * Real(0.5);
    }
    double farthest_coordinate(const Point<double>& p) const {
        double farthest = max(abs(p.x), abs(p.y));
        for (int i = 0; i < 2 * points.count; ++i) farthest = max(farthest, abs(points.xy[i]));
        return farthest;
    }
    /// So near to the edge that rounding is most of the way to the foot, the gradient is the difference of the distances about p.
    Real gradient_across_edge(const Point<Real>& p, double distance_to_edge, double step) const {
        const Path<double> edge{{points.xy, points.count}, pieces, true, 0};
        const Point<double> q{frozen(p.x), frozen(p.y)};
        const Point<double> rise{edge.distance({q.x + step, q.y}) - edge.distance({q.x - step, q.y}),
                                 edge.distance({q.x, q.y + step}) - edge.distance({q.x, q.y - step})};
        const double length = norm(rise), scale = length > 0 ? 1 / length : 0;
        return with_gradient(distance_to_edge, length > 0 ? rise.x * scale : 1, rise.y * scale, p);
    }
    Point<Real> offset_from_foot(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        const Point<Plain> q{frozen(p.x), frozen(p.y)};
        Point<Plain> foot{Plain(corner(0).x), Plain(corner(0).y)};
        const auto offer = [&](const PieceView& piece) {
            const Point<Plain> other = nearest_on_piece(q, piece), now = q - foot, then = q - other;
            foot = select(dot(then, then) < dot(now, now), other, foot);
        };
        for_each_piece(offer);
        const std::array<double, 4> closing = closing_edge();
        if (fill) offer({closing.data(), PathPiece::line});
        return {p.x - Real(foot.x), p.y - Real(foot.y)};
    }

    /// By t from 0 to 1 over all pieces, as long for each.
    static CurvePoint curve_at(const std::vector<PieceView>& all, double t) {
        const double place = t * static_cast<double>(all.size());
        const std::size_t i = std::min(static_cast<std::size_t>(place), all.size() - 1);
        return curve_point(all[i], place - static_cast<double>(i));
    }
    static bool closes_smoothly(const std::vector<PieceView>& all) {
        const Point<double> start = all.front()[0], end = all.back().end();
        return start.x == end.x && start.y == end.y && joins_smoothly(all.back(), all.front());
    }
    /// A wall that overlaps itself nowhere: smooth joints, and see is_plain_stroke().
    bool is_plain_wall() const {
        const std::vector<PieceView> all = views();
        double top_speed = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const PieceView& piece = all[i];
            top_speed = max(top_speed, top_speed_of(piece));
            if (i > 0 && !joins_smoothly(all[i - 1], piece)) return false;
        }
        const Path<double> middle_line{{points.xy, points.count}, pieces, false, 0};
        return is_plain_stroke([&](double t) { return curve_at(all, t); }, top_speed * static_cast<double>(all.size()), 0.5 * thickness,
                               [&](const Vec2& p) {
                                   return norm(middle_line.offset_from_foot({p.x(), p.y()}));
                               },
                               closes_smoothly(all) ? StrokeEnds::joined : StrokeEnds::round);
    }
    /// No piece runs along another: inside and outside lie on different sides of every one.
    bool is_clean_edge() const {
        const double step = 1e-6 * bounds().size().maxCoeff();
        const auto separates = [&](const CurvePoint& c) {
            const Vec2 aside = step * perpendicular(c.along);
            const auto inside = [&](const Vec2& p) { return distance({p.x(), p.y()}) + 0.5 * thickness < 0; };
            return c.along == Vec2(0, 0) || inside(c.at + aside) != inside(c.at - aside);
        };
        const std::array<double, 4> closing = closing_edge();
        std::vector<PieceView> all = views();
        all.push_back({closing.data(), PathPiece::line});
        for (const PieceView& piece : all)
            for (const double t : {0.29, 0.71})
                if (!separates(curve_point(piece, t))) return false;
        return true;
    }
    Exactness exactness() const {
        if (!fill) return {.inside = is_plain_wall() ? Side::exact : Side::bound};
        if (!is_clean_edge()) return {.outside = Side::bound, .inside = Side::bound};
        return {.inside = thickness > 0 ? Side::bound : Side::exact};
    }

    Box2 bounds() const {
        Box2 box;
        for_each_piece([&](const PieceView& piece) { box = box.merged(bounds_of(piece)); });
        return box.grown(0.5 * thickness);
    }
    /// Nothing but where all pieces are lines and arcs that keep apart, and no arc is so flat that its centre would blur it.
    void outline(Outline& out) const {
        const std::vector<PieceView> all = views();
        if (!std::all_of(all.begin(), all.end(), [](const PieceView& piece) { return has_parallels(piece); })) return;
        if (!fill) {
            if (is_plain_wall()) outline_wall(all, 0.5 * thickness, closes_smoothly(all), out);
        } else if (thickness == 0) {
            Outline loop = loop_along(all);
            const double area = is_simple_outline(loop) ? signed_area(loop) : 0;
            if (area != 0) out = area > 0 ? loop : reversed(loop);
        }
    }

    static constexpr auto describe() {
        return shape<Path>(
            {.key = "path", .float_error = 5e-6, .doc = "Wall along a chain of lines, arcs and Bezier curves, or the region it encloses."},
            fields(field("points", &Path::points,
                         {.unit = Unit::metre,
                          .step = 0.001,
                          .required = true,
                          .meaning = Meaning::place,
                          .doc = "The start, then what each piece takes: a line its end; an arc a point on its way and its end; a "
                                 "quadratic piece a control point and its end, a cubic one two of them and its end."}),
                   field("pieces", &Path::pieces,
                         {.doc = "What the pieces are, in order; when the list is through it begins again. One word alone: all alike."}),
                   field("fill", &Path::fill,
                         {.doc = "Solid is what the path encloses, closed by a straight edge, instead of a wall along it."}),
                   field("thickness", &Path::thickness,
                         {.unit = Unit::metre,
                          .min = from(0),
                          .step = 0.0005,
                          .doc = "Full width of the wall, or of a wall along the edge of what is filled."})),
            contract("pieces names at least one", [](const auto& path) { return path.pieces.count > 0; }),
            contract("at least one piece", [](const auto& path) { return path.for_each_piece([](const PieceView&) {}) > 0; }),
            contract("1 point, then as many for each piece as it takes",
                     [](const auto& path) { return path.for_each_piece([](const PieceView&) {}) == path.points.count - 1; }),
            contract("at most 1024 points", [](const auto& path) { return path.points.count <= max_points; }),
            contract("a wall has a thickness", [](const auto& path) { return path.fill || path.thickness > 0; }),
            contract("an arc of more than half a turn is at most 100 times as wide as its three points are apart", [](const auto& path) {
                bool holds = true;
                path.for_each_piece([&](const PieceView& piece) { holds = holds && (!piece.is_arc() || is_drawn_well(piece)); });
                return holds;
            }));
    }
};

}  // namespace pinfield::sdf

#include "tests/conformance/parametric_outlines.h"

#include "engine/core/trig.h"
#include "engine/reflect/load.h"
#include "engine/sdf/nodes/blobby_cross.h"
#include "engine/sdf/nodes/cubic_bezier.h"
#include "engine/sdf/nodes/ellipse.h"
#include "engine/sdf/nodes/formula.h"
#include "engine/sdf/nodes/parabola_segment.h"
#include "engine/sdf/nodes/path.h"
#include "engine/sdf/nodes/quadratic_bezier.h"
#include "engine/sdf/nodes/quadratic_circle.h"
#include "engine/sdf/nodes/spiral.h"

namespace pinfield::conformance {
namespace {

using Points = std::vector<Vec2>;
using sdf::CurvePoint;

/// From 0 at i = 0 to 1 at i = n, in steps that shrink to 35 / n^4 at both ends, so that the curve through neighbouring points follows the
/// outline near corners and joints, too.
double graded(int i, int n) {
    const double u = static_cast<double>(i) / n;
    return u * u * u * u * (35 - u * (84 - u * (70 - 20 * u)));
}

/// The points at(0), at(1) and n - 1 between them, without the last one: it begins the next part.
template <class At>
void add_part(int n, const At& at, Points& out) {
    for (int i = 0; i < n; ++i) out.push_back(at(graded(i, n)));
}

/// Of a wall with round ends about the middle line curve(0) ... curve(1), each a CurvePoint. `points` are those of one end; a side takes
/// twice as many.
template <class Curve>
void add_stroke(const Curve& curve, double half_thickness, int points, Points& out) {
    const auto beside = [&](double t, double side) {
        const CurvePoint c = curve(t);
        return Vec2(c.at + side * half_thickness * perpendicular(c.along));
    };
    const auto round_end = [&](double t, double forth) {
        const CurvePoint c = curve(t);
        const Vec2 along = forth * c.along;
        return [=](double u) {
            const SineCosine turn = sine_cosine(pi * u);
            return Vec2(c.at + half_thickness * (turn.sine * along - turn.cosine * perpendicular(along)));
        };
    };
    const int along_side = 2 * points, along_end = points;
    add_part(along_side, [&](double t) { return beside(t, -1); }, out);
    add_part(along_end, round_end(1, 1), out);
    add_part(along_side, [&](double t) { return beside(1 - t, 1); }, out);
    add_part(along_end, round_end(0, -1), out);
}

void ellipse(const sdf::Ellipse<double>& shape, int points, Points& out) {
    for (int i = 0; i < points; ++i) {
        const SineCosine t = sine_cosine_degrees(360.0 * i / points);
        out.emplace_back(shape.radii.x * t.cosine, shape.radii.y * t.sine);
    }
}

void quadratic_circle(const sdf::QuadraticCircle<double>& shape, int points, Points& out) {
    const int n = points / 4;
    for (int i = 0; i < 4 * n; ++i) {
        const SineCosine quarter = sine_cosine_degrees(90.0 * (i / n));
        const double t = static_cast<double>(i % n) / n, x = shape.radius * (1 - t * t), y = shape.radius * t * (2 - t);
        out.emplace_back(quarter.cosine * x - quarter.sine * y, quarter.sine * x + quarter.cosine * y);
    }
}

void parabola_segment(const sdf::ParabolaSegment<double>& shape, int points, Points& out) {
    add_part(points, [&](double t) { return Vec2((t - 0.5) * shape.width, 0); }, out);
    add_part(points, [&](double t) { return Vec2((0.5 - t) * shape.width, 4 * t * (1 - t) * shape.height); }, out);
}

/// From the tip on +x: half its rounding, the bite, half the next tip's rounding; four times.
void blobby_cross(const sdf::BlobbyCross<double>& shape, int points, Points& out) {
    constexpr double half_root = sdf::BlobbyCross<double>::half_root;
    const auto normal_at = [&](double m) {
        const double x = half_root * (1 - shape.side * m), y = half_root * (1 + shape.side * m);
        return Vec2(Vec2(x, y).normalized());
    };
    const auto bite = [&](double t) {
        const double x = half_root * shape.tip * (1 - 2 * t), m = x / shape.radius, y = shape.top - shape.side * 0.5 * x * m;
        return Vec2(Vec2(0.5 * shape.tip - half_root * (y - x), 0.5 * shape.tip - half_root * (y + x)) + shape.round * normal_at(m));
    };
    const Vec2 first = normal_at(shape.steepest);
    const double opening = arc_tangent(first.y(), first.x());
    for (int quarter = 0; quarter < 4; ++quarter) {
        const SineCosine turn = sine_cosine_degrees(90.0 * quarter);
        const auto turned = [&](const Vec2& v) {
            return Vec2(turn.cosine * v.x() - turn.sine * v.y(), turn.sine * v.x() + turn.cosine * v.y());
        };
        const auto tip_at = [&](double angle) {
            const SineCosine around = sine_cosine(angle);
            return turned(Vec2(shape.tip + shape.round * around.cosine, shape.round * around.sine));
        };
        if (shape.round > 0) add_part(points / 2, [&](double t) { return tip_at(opening * (2 * t - 1)); }, out);
        add_part(points, [&](double t) { return turned(bite(t)); }, out);
    }
}

/// Walls have none where they overlap themselves.
void quadratic_bezier(const sdf::QuadraticBezier<double>& shape, int points, Points& out) {
    const auto curve = [&](double t) { return CurvePoint{shape.point_at(t), shape.velocity_at(t).normalized()}; };
    if (shape.is_plain()) add_stroke(curve, 0.5 * shape.thickness, points, out);
}

void cubic_bezier(const sdf::CubicBezier<double>& shape, int points, Points& out) {
    if (shape.is_plain()) add_stroke([&](double t) { return shape.curve_at(t); }, 0.5 * shape.thickness, points, out);
}

void spiral(const sdf::Spiral<double>& shape, int points, Points& out) {
    const int more_turns = 1 + static_cast<int>(shape.turns) / 3;
    if (shape.is_plain()) add_stroke([&](double t) { return shape.curve_at(t); }, 0.5 * shape.thickness, points * more_turns, out);
}

/// Of filled paths without a rim.
void path(const sdf::Path<double>& shape, int points_of_piece, Points& out) {
    if (!shape.fill || shape.thickness > 0 || !shape.is_clean_edge()) return;
    shape.for_each_piece([&](const sdf::PieceView& piece) {
        add_part(points_of_piece, [&](double t) { return curve_point(piece, t).at; }, out);
    });
    const std::array<double, 4> closing = shape.closing_edge();
    const Vec2 from(closing[0], closing[1]), to(closing[2], closing[3]);
    if (from != to) add_part(points_of_piece, [&](double t) { return Vec2(from + t * (to - from)); }, out);
}

/// Of the default, a bank of waves within its window, where that does not cut their crests and troughs, nor hold too many.
void formula(const sdf::Formula<double>& shape, int points, Points& out) {
    const double x = 0.5 * shape.window.x, y = 0.5 * shape.window.y;
    if (y <= 0.009 || x > 0.2) return;
    const auto wave = [&](double at) { return Vec2(at, 0.008 * cosine_degrees(9e3 * at)); };
    const auto edge = [&](const Vec2& from, const Vec2& to) { add_part(points, [&](double t) { return Vec2(from + t * (to - from)); }, out); };
    edge({-x, -y}, {x, -y});
    edge({x, -y}, wave(x));
    add_part(points * (1 + static_cast<int>(x / 0.02)), [&](double t) { return wave(x - 2 * t * x); }, out);
    edge(wave(-x), {-x, -y});
}

template <template <class> class N, void (*add_points)(const N<double>& shape, int points, Points& out)>
NamedOutline outline_of() {
    return {N<double>::describe().meta.key,
            [](const double* params, int points, Points& out) { add_points(load<N<double>>(params), points, out); }};
}

}  // namespace

std::vector<NamedOutline> parametric_outlines() {
    return {outline_of<sdf::Ellipse, ellipse>(),
            outline_of<sdf::QuadraticCircle, quadratic_circle>(),
            outline_of<sdf::ParabolaSegment, parabola_segment>(),
            outline_of<sdf::BlobbyCross, blobby_cross>(),
            outline_of<sdf::QuadraticBezier, quadratic_bezier>(),
            outline_of<sdf::CubicBezier, cubic_bezier>(),
            outline_of<sdf::Spiral, spiral>(),
            outline_of<sdf::Path, path>(),
            outline_of<sdf::Formula, formula>()};
}

}  // namespace pinfield::conformance

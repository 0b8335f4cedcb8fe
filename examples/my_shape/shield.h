// A shape of one's own: everything Pinfield needs to know of it is in this file.
#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/outline.h"
#include "engine/sdf/scalar.h"

namespace my {

using namespace pinfield;
using sdf::abs, sdf::both, sdf::cross, sdf::max, sdf::min, sdf::norm, sdf::select;  // what formulas are made of: engine/sdf/scalar.h

/// A heater shield, point down: a box above the local x axis and, below it, two arcs that go on from its sides and meet in the point.
/// An arc of radius r = (tip^2 + w^2) / 2w, w half the width, has its centre on the axis and its tangent along the side.
template <class Real>
struct Shield {
    Real width = Real(0.06);
    Real height = Real(0.025);
    Real tip = Real(0.05);

    static constexpr bool convex = true;

    /// By symmetry x >= 0. A side and the arc below it are the points at distance r from an upright segment: one formula for both.
    Real distance(const Point<Real>& p) const {
        const Real w = width * Real(0.5), r = radius(), centre = w - r;
        const Point<Real> q{abs(p.x), p.y}, from_centre{q.x - centre, min(q.y, Real(0))};
        const Point<Real> from_corner{q.x - w, q.y - height}, from_tip{q.x, q.y + tip};
        const Real above = select(q.x > w, norm(from_corner), q.y - height);
        const Real beside = norm(from_centre) - r;
        const auto below_the_tip = cross(Point<Real>{-centre, -tip}, from_centre) < Real(0);
        const Real around = select(q.y > height, above, select(below_the_tip, norm(from_tip), beside));
        return select(both(q.y <= height, beside <= Real(0)), max(q.y - height, beside), around);
    }
    Box2 bounds() const { return {{-0.5 * width, -tip}, {0.5 * width, height}}; }
    /// What the distance is measured to, said a second time; the battery compares the two, and balls are collided with this one.
    void outline(sdf::Outline& out) const {
        const double w = 0.5 * width, r = radius();
        const Vec2 left(-w, 0), point(0, -tip), right(w, 0), upper_right(w, height), upper_left(-w, height);
        out.push_back(sdf::Piece::arc({r - w, 0}, r, left, point, 1, false));
        out.push_back(sdf::Piece::arc({w - r, 0}, r, point, right, 1, false));
        out.push_back(sdf::Piece::segment(right, upper_right));
        out.push_back(sdf::Piece::segment(upper_right, upper_left));
        out.push_back(sdf::Piece::segment(upper_left, left));
    }

    static constexpr auto describe() {
        return shape<Shield>(
            {.key = "shield", .doc = "A heater shield, point down."},
            fields(field("width", &Shield::width, {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "From side to side."}),
                   field("height", &Shield::height,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Of the upright sides, from the local x axis up."}),
                   field("tip", &Shield::tip,
                         {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "How far the point hangs below the sides."})),
            contract("width / 2 <= tip <= 2 width", [](const auto& s) { return s.width <= 2 * s.tip && s.tip <= 2 * s.width; }));
    }

private:
    Real radius() const { return (tip * tip / width) + width * Real(0.25); }
};

}  // namespace my

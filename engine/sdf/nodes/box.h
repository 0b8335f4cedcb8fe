#pragma once
#include "engine/core/geometry.h"
#include "engine/reflect/describe.h"
#include "engine/sdf/outline.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf {

/// Rectangle centred on the local origin, its corners rounded within its size.
template <class Real>
struct Box {
    Point<Real> size{Real(0.1), Real(0.05)};
    Real round = Real(0);

    static constexpr bool convex = true;

    /// In the first quadrant q is the position relative to the corner's centre of rounding. Beside a side the nearest point
    /// is on that side; in the corner's quadrant it is on the arc.
    Real distance(const Point<Real>& p) const {
        const Point<Real> q{abs(p.x) - (size.x * Real(0.5) - round), abs(p.y) - (size.y * Real(0.5) - round)};
        const Real beside = max(q.x, q.y);
        const Real around = norm(Point<Real>{max(q.x, Real(0)), max(q.y, Real(0))});
        return select(min(q.x, q.y) > Real(0), around, beside) - round;
    }
    Box2 bounds() const { return Box2::centred(0.5 * size.x, 0.5 * size.y); }
    void outline(Outline& out) const {
        const double x = 0.5 * size.x, y = 0.5 * size.y, u = x - round, v = y - round;
        const Vec2 corners[] = {{u, -v}, {u, v}, {-u, v}, {-u, -v}};  // centres of rounding, counter-clockwise
        const Vec2 normals[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};    // of the side that ends at each corner
        for (int i = 0; i < 4; ++i) {
            const Vec2 &c = corners[i], &next = corners[(i + 1) % 4], &n = normals[i], &m = normals[(i + 1) % 4];
            if (round > 0) out.push_back(Piece::arc(c, round, c + round * n, c + round * m, 1, false));
            if (c != next) out.push_back(Piece::segment(c + round * m, next + round * m));
        }
    }

    static constexpr auto describe() {
        return shape<Box>({.key = "box", .doc = "Rectangle centred on the local origin; its corners may be rounded."},
                          fields(field("size", &Box::size,
                                       {.unit = Unit::metre, .min = above(0), .step = 0.001, .doc = "Full width and height."}),
                                 field("round", &Box::round,
                                       {.unit = Unit::metre, .min = from(0), .step = 0.0005,
                                        .doc = "Radius of the corners, within the size."})),
                          contract("round <= half the smaller side",
                                   [](const auto& box) { return box.round <= 0.5 * min(box.size.x, box.size.y); }));
    }
};

}  // namespace pinfield::sdf

// Nodes as they are published, each without the contract or the branch that it needs: the known faults of the catalog's table 1 and of
// its section on operators, written down from the mathematics. For tests of the laws only; the engine's own nodes are in engine/sdf.
#pragma once
#include <span>

#include "engine/reflect/describe.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/scalar.h"

namespace pinfield::sdf::faulty {

inline constexpr Exactness only_bounds{Side::bound, Side::bound};

/// A wall whose direction is (b - a) / |b - a|: 0/0 where its ends meet.
template <class Real>
struct SegmentOfNoLength {
    Point<double> a{-0.04, 0}, b{0.04, 0};
    Real distance(const Point<Real>& p) const {
        const double length = norm(Point<double>{b.x - a.x, b.y - a.y});
        const Real tx((b.x - a.x) / length), ty((b.y - a.y) / length), x = p.x - Real(a.x), y = p.y - Real(a.y);
        const Real along = clamp(x * tx + y * ty, Real(0), Real(length));
        return norm(Point<Real>{x - along * tx, y - along * ty}) - Real(0.005);
    }
    Box2 bounds() const { return Box2::of({a.x, a.y}, {b.x, b.y}).grown(0.005); }
    static constexpr auto describe() {
        return shape<SegmentOfNoLength>({.key = "segment_of_no_length"}, fields(field("a", &SegmentOfNoLength::a, {.unit = Unit::metre}),
                                                                               field("b", &SegmentOfNoLength::b, {.unit = Unit::metre})));
    }
};

/// Two discs and their common tangents: the tangents' cosine is no number when one disc swallows the other.
template <class Real>
struct CapsuleSwallowed {
    Real first = Real(0.02), second = Real(0.01), length = Real(0.04);
    Real distance(const Point<Real>& p) const {
        const Real sine = (first - second) / length, cosine = sqrt(Real(1) - sine * sine), x = abs(p.x);
        const Real along = p.y * cosine - x * sine;
        const Real beside = x * cosine + p.y * sine - first;
        const Real top = norm(Point<Real>{x, p.y - length}) - second, bottom = norm(p) - first;
        return select(along < Real(0), bottom, select(along > length * cosine, top, beside));
    }
    Box2 bounds() const { return Box2::everything(); }
    static constexpr auto describe() {
        using C = CapsuleSwallowed;
        return shape<C>({.key = "capsule_swallowed", .exactness = only_bounds},
                        fields(field("first", &C::first, {.unit = Unit::metre, .min = above(0)}),
                               field("second", &C::second, {.unit = Unit::metre, .min = above(0)}),
                               field("length", &C::length, {.unit = Unit::metre, .min = above(0)})));
    }
};

/// A closed form that divides by the difference of the squared axes: no number for a circle.
template <class Real>
struct EllipseOfEqualAxes {
    Real a = Real(0.04), b = Real(0.02);
    Real distance(const Point<Real>& p) const {
        const Real from_evolute = p.x * a / (a * a - b * b);
        return norm(Point<Real>{p.x / a, p.y / b}) * min(a, b) - min(a, b) + Real(0) * from_evolute;
    }
    Box2 bounds() const { return Box2::everything(); }
    static constexpr auto describe() {
        using E = EllipseOfEqualAxes;
        return shape<E>(
            {.key = "ellipse_of_equal_axes", .exactness = only_bounds},
            fields(field("a", &E::a, {.unit = Unit::metre, .min = above(0)}), field("b", &E::b, {.unit = Unit::metre, .min = above(0)})));
    }
};

/// f / |grad f| for f = |p / axes| - 1, said to be a bound: it claims too much inside, and grows too fast there.
template <class Real>
struct EllipseByItsGradient {
    Real distance(const Point<Real>& p) const {
        const Real a(0.04), b(0.02), k = norm(Point<Real>{p.x / a, p.y / b}), slope = norm(Point<Real>{p.x / (a * a), p.y / (b * b)});
        return k * (k - Real(1)) / max(slope, Real(1e-12));
    }
    Box2 bounds() const { return Box2::centred(0.04, 0.02); }
    static constexpr auto describe() {
        return shape<EllipseByItsGradient>({.key = "ellipse_by_its_gradient", .exactness = only_bounds}, fields());
    }
};

/// A lens of two circles, told from its tips by a line that is right only for lenses longer than they are high.
template <class Real>
struct LensHigherThanLong {
    Real half_length = Real(0.04), half_height = Real(0.02);
    Real distance(const Point<Real>& p) const {
        const Real x = abs(p.x), y = abs(p.y), radius = (half_length * half_length + half_height * half_height) / (Real(2) * half_height);
        const Real centre = radius - half_height;
        return select((x - half_length) * centre > y * half_length, norm(Point<Real>{x - half_length, y}),
                      norm(Point<Real>{x, y + centre}) - radius);
    }
    Box2 bounds() const { return Box2::everything(); }
    static constexpr auto describe() {
        using L = LensHigherThanLong;
        return shape<L>({.key = "lens_higher_than_long", .exactness = only_bounds},
                        fields(field("half_length", &L::half_length, {.unit = Unit::metre, .min = above(0)}),
                               field("half_height", &L::half_height, {.unit = Unit::metre, .min = above(0)})));
    }
};

/// A box whose right and left corners have radii of their own, which nobody keeps below half its size: a jump on the axis.
template <class Real>
struct BoxTooRound {
    Real right = Real(0.01), left = Real(0.005);
    Real distance(const Point<Real>& p) const {
        const Real rounding = select(p.x > Real(0), right, left);
        const Real x = abs(p.x) - Real(0.04) + rounding, y = abs(p.y) - Real(0.02) + rounding;
        return min(max(x, y), Real(0)) + norm(Point<Real>{max(x, Real(0)), max(y, Real(0))}) - rounding;
    }
    Box2 bounds() const { return Box2::centred(0.04, 0.02); }
    static constexpr auto describe() {
        using B = BoxTooRound;
        return shape<B>({.key = "box_too_round", .exactness = only_bounds},
                        fields(field("right", &B::right, {.unit = Unit::metre, .min = from(0)}),
                               field("left", &B::left, {.unit = Unit::metre, .min = from(0)})));
    }
};

/// A cross whose inside asks for its notches' corners only: with stubby arms the ends are nearer.
template <class Real>
struct CrossWithStubbyArms {
    Real distance(const Point<Real>& p) const {
        const Real length(0.04), width(0.03), far = max(abs(p.x), abs(p.y)), near = min(abs(p.x), abs(p.y));
        const Real beyond = far - length, aside = near - width;
        const Real outside = norm(Point<Real>{max(beyond, Real(0)), max(aside, Real(0))});
        const Real notch = norm(Point<Real>{far - width, min(aside, Real(0))});
        return select(max(beyond, aside) > Real(0), outside, -select(far > width, -aside, notch));
    }
    void outline(Outline& out) const {
        constexpr double l = 0.04, w = 0.03;
        const Vec2 corners[] = {{l, -w}, {l, w}, {w, w}, {w, l}, {-w, l}, {-w, w}, {-l, w}, {-l, -w}, {-w, -w}, {-w, -l}, {w, -l}, {w, -w}};
        for (std::size_t i = 0; i < 12; ++i) out.push_back(Piece::segment(corners[i], corners[(i + 1) % 12]));
    }
    Box2 bounds() const { return Box2::centred(0.04, 0.04); }
    static constexpr auto describe() {
        return shape<CrossWithStubbyArms>({.key = "cross_with_stubby_arms", .exactness = only_bounds}, fields());
    }
};

/// A half circle with a sign from the side of its curve: beyond its ends the sign jumps where nothing is.
template <class Real>
struct OpenCurveWithASign {
    Real distance(const Point<Real>& p) const {
        const Real to_arc = abs(norm(p) - Real(0.03)), to_end = norm(Point<Real>{abs(p.x) - Real(0.03), p.y});
        const Real d = select(p.y > Real(0), to_arc, to_end);
        return select(norm(p) < Real(0.03), -d, d);
    }
    Box2 bounds() const { return Box2::centred(0.03, 0.03); }
    static constexpr auto describe() {
        return shape<OpenCurveWithASign>({.key = "open_curve_with_a_sign", .exactness = only_bounds}, fields());
    }
};

/// A triangle by its edges' sides, whichever way round: zero everywhere once its corners are in line.
template <class Real>
struct TriangleOfOneLine {
    Point<double> a{-0.03, -0.02}, b{0.03, -0.02}, c{0, 0.04};
    Real distance(const Point<Real>& p) const {
        const double way = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), turn = way > 0 ? 1 : way < 0 ? -1 : 0;
        const Point<double> corners[] = {a, b, c, a};
        Real nearest(1e30), inside(1e30);
        for (int i = 0; i < 3; ++i) {
            const Point<double>&from = corners[i], &to = corners[i + 1];
            const double dx = to.x - from.x, dy = to.y - from.y, squared = max(dx * dx + dy * dy, 1e-300);
            const Real x = p.x - Real(from.x), y = p.y - Real(from.y);
            const Real along = clamp((x * Real(dx) + y * Real(dy)) / Real(squared), Real(0), Real(1));
            nearest = min(nearest, norm(Point<Real>{x - along * Real(dx), y - along * Real(dy)}));
            inside = min(inside, Real(turn) * (Real(dx) * y - Real(dy) * x));
        }
        return -nearest * select(inside > Real(0), Real(1), select(inside < Real(0), Real(-1), Real(0)));
    }
    Box2 bounds() const { return Box2::of({a.x, a.y}, {b.x, b.y}).including({c.x, c.y}); }
    static constexpr auto describe() {
        using T = TriangleOfOneLine;
        return shape<T>({.key = "triangle_of_one_line", .exactness = only_bounds},
                        fields(field("a", &T::a, {.unit = Unit::metre}), field("b", &T::b, {.unit = Unit::metre}),
                               field("c", &T::c, {.unit = Unit::metre})));
    }
};

/// The point folded into one cell, which asks no neighbour: discs off the cell's centre are nearer across the border.
template <class Real>
struct RepetitionWithoutNeighbours {
    Real distance(const Point<Real>& p) const {
        const Real cell(0.05), x = p.x - cell * floor(p.x / cell + Real(0.5));
        return norm(Point<Real>{x - Real(0.015), p.y}) - Real(0.008);
    }
    Box2 bounds() const { return Box2::everything(); }
    static constexpr auto describe() {
        return shape<RepetitionWithoutNeighbours>({.key = "repetition_without_neighbours", .exactness = only_bounds}, fields());
    }
};

/// A quarter circle between two surfaces, by both distances at once: where they face each other it grows by up to the square root of 2.
template <class Real>
struct RoundUnionBothSides {
    Real k = Real(0.02);
    Real combine(const Real& a, const Real& b) const {
        return max(k, min(a, b)) - norm(Point<Real>{max(k - a, Real(0)), max(k - b, Real(0))});
    }
    static Real hard(const Real& a, const Real& b) { return min(a, b); }
    Slack slack() const { return {.below = k, .above = k}; }
    static Exactness exactness(std::span<const Exactness>) { return only_bounds; }
    static Box2 bounds(std::span<const Box2>) { return Box2::everything(); }
    static constexpr auto describe() {
        return operation<RoundUnionBothSides>({.key = "round_union_both_sides", .exactness = only_bounds, .children = {1, any_number}},
                                              fields(field("k", &RoundUnionBothSides::k, {.unit = Unit::metre, .min = above(0)})));
    }
};

/// An intersection that is promised exact outside: a mitre beyond its corners.
template <class Real>
struct IntersectionSaidExact {
    static Real combine(const Real& a, const Real& b) { return max(a, b); }
    static Exactness exactness(std::span<const Exactness>) { return {}; }
    static Box2 bounds(std::span<const Box2> children) {
        Box2 out = Box2::everything();
        for (const Box2& child : children) out = out.intersected(child);
        return out;
    }
    static constexpr auto describe() {
        return operation<IntersectionSaidExact>({.key = "intersection_said_exact", .children = {1, any_number}}, fields());
    }
};

}  // namespace pinfield::sdf::faulty

// Nodes with one fault each, for tests of the laws only: a law that lets its fault pass is no law.
#pragma once
#include <span>
#include <tuple>
#include <vector>

#include "engine/reflect/describe.h"
#include "engine/sdf/edges.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/outline.h"
#include "engine/sdf/scalar.h"
#include "engine/sdf/simple_chain.h"

namespace pinfield::sdf::faulty {

/// What the faulty discs share: all but the distance is right, and a node says what else is wrong.
inline constexpr double r = 0.04;
inline void disc_outline(Outline& out) { out.push_back(Piece::circle({0, 0}, r)); }

/// 0/0 at the centre.
template <class Real>
struct NanAtCentre {
    Real distance(const Point<Real>& p) const { return dot(p, p) / norm(p) - Real(r); }
    Box2 bounds() const { return Box2::centred(r, r); }
    static constexpr auto describe() { return shape<NanAtCentre>({.key = "nan_at_centre"}, fields()); }
};

/// What a triangle with collinear corners used to be in many a library.
template <class Real>
struct ZeroPlane {
    Real distance(const Point<Real>& p) const { return p.x * Real(0); }
    Box2 bounds() const { return Box2::centred(r, r); }
    static constexpr auto describe() {
        return shape<ZeroPlane>({.key = "zero_plane", .exactness = {Side::bound, Side::bound}}, fields());
    }
};

/// A seam on the y axis, as of a repetition of something lopsided.
template <class Real>
struct Jump {
    Real distance(const Point<Real>& p) const { return select(p.x < Real(0), Real(0.9), Real(1)) * (norm(p) - Real(r)); }
    Box2 bounds() const { return Box2::centred(r, r); }
    static constexpr auto describe() {
        return shape<Jump>({.key = "jump", .exactness = {Side::bound, Side::bound}}, fields());
    }
};

/// Claims more distance than there is, slowly enough to keep its Lipschitz constant.
template <class Real>
struct OverEstimate {
    Real distance(const Point<Real>& p) const { return norm(p) - Real(0.9 * r); }
    Box2 bounds() const { return Box2::centred(r, r); }
    void outline(Outline& out) const { disc_outline(out); }
    static constexpr auto describe() {
        return shape<OverEstimate>({.key = "over_estimate", .exactness = {Side::bound, Side::bound}}, fields());
    }
};

/// Inside out on the axis of symmetry alone, where random points never fall.
template <class Real>
struct WrongSignOnAxis {
    Real distance(const Point<Real>& p) const {
        const Real d = norm(p) - Real(r);
        return select(abs(p.x) <= Real(0), -d, d);
    }
    Box2 bounds() const { return Box2::centred(r, r); }
    void outline(Outline& out) const { disc_outline(out); }
    static constexpr auto describe() { return shape<WrongSignOnAxis>({.key = "wrong_sign_on_axis"}, fields()); }
};

/// Inside out everywhere.
template <class Real>
struct InsideOut {
    Real distance(const Point<Real>& p) const { return Real(r) - norm(p); }
    Box2 bounds() const { return Box2::everything(); }
    void outline(Outline& out) const { disc_outline(out); }
    static constexpr auto describe() { return shape<InsideOut>({.key = "inside_out"}, fields()); }
};

/// |x| by way of a square root, whose derivative at 0 is lost: no normal on the axis.
template <class Real>
struct NoGradientOnAxis {
    Real distance(const Point<Real>& p) const { return sqrt(p.x * p.x) - Real(r); }
    Box2 bounds() const { return {{-r, -infinity}, {r, infinity}}; }
    static constexpr auto describe() { return shape<NoGradientOnAxis>({.key = "no_gradient_on_axis"}, fields()); }
};

/// The gradient of something else: a derivative was dropped.
template <class Real>
struct LostDerivative {
    Real distance(const Point<Real>& p) const { return norm(Point<Real>{p.x, Real(frozen(p.y))}) - Real(r); }
    Box2 bounds() const { return Box2::centred(r, r); }
    static constexpr auto describe() {
        return shape<LostDerivative>({.key = "lost_derivative", .exactness = {Side::bound, Side::bound}}, fields());
    }
};

template <class Real>
struct BoundsTooSmall {
    Real distance(const Point<Real>& p) const { return norm(p) - Real(r); }
    Box2 bounds() const { return Box2::centred(r, 0.99 * r); }
    static constexpr auto describe() { return shape<BoundsTooSmall>({.key = "bounds_too_small"}, fields()); }
};

template <class Real>
struct BoundsTooLarge {
    Real distance(const Point<Real>& p) const { return norm(p) - Real(r); }
    Box2 bounds() const { return Box2::centred(2 * r, r); }
    void outline(Outline& out) const { disc_outline(out); }
    static constexpr auto describe() { return shape<BoundsTooLarge>({.key = "bounds_too_large"}, fields()); }
};

/// Loses digits in single precision by adding and taking away something large.
template <class Real>
struct PacketOff {
    Real distance(const Point<Real>& p) const { return norm(p) + Real(10) - Real(r) - Real(10); }
    Box2 bounds() const { return Box2::centred(r, r); }
    static constexpr auto describe() {
        return shape<PacketOff>({.key = "packet_off", .exactness = {Side::bound, Side::bound}}, fields());
    }
};

template <class Real>
struct WrongLipschitz {
    Real distance(const Point<Real>& p) const { return norm(p) - Real(r); }
    Box2 bounds() const { return Box2::centred(r, r); }
    static constexpr auto describe() {
        return shape<WrongLipschitz>({.key = "wrong_lipschitz", .exactness = {.lipschitz = 0.9}}, fields());
    }
};

/// A square by the largest coordinate: a bound beyond the corners, but called exact.
template <class Real>
struct WrongClaim {
    Real distance(const Point<Real>& p) const { return max(abs(p.x), abs(p.y)) - Real(r); }
    Box2 bounds() const { return Box2::centred(r, r); }
    void outline(Outline& out) const {
        const Vec2 corners[] = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
        for (int i = 0; i < 4; ++i) out.push_back(Piece::segment(corners[i], corners[(i + 1) % 4]));
    }
    static constexpr auto describe() { return shape<WrongClaim>({.key = "wrong_claim"}, fields()); }
};

/// An exact distance of some other figure: only its foot point gives it away, for it has no outline to compare with.
template <class Real>
struct HalfDistance {
    Real distance(const Point<Real>& p) const { return Real(0.5) * (norm(p) - Real(r)); }
    Box2 bounds() const { return Box2::centred(r, r); }
    static constexpr auto describe() { return shape<HalfDistance>({.key = "half_distance"}, fields()); }
};

/// Describes itself as exact, computes otherwise.
template <class Real>
struct TwoClaims {
    Real distance(const Point<Real>& p) const { return norm(p) - Real(r); }
    Exactness exactness() const { return {.inside = Side::bound}; }
    Box2 bounds() const { return Box2::centred(r, r); }
    static constexpr auto describe() { return shape<TwoClaims>({.key = "two_claims"}, fields()); }
};

/// A union that is promised exact inside.
template <class Real>
struct UnionSaidExact {
    static Real combine(const Real& a, const Real& b) { return min(a, b); }
    static Exactness exactness(std::span<const Exactness>) { return {}; }
    static Box2 bounds(std::span<const Box2> children) {
        Box2 out;
        for (const Box2& child : children) out = out.merged(child);
        return out;
    }
    static constexpr auto describe() {
        return operation<UnionSaidExact>({.key = "union_said_exact", .children = {1, any_number}}, fields());
    }
};

/// A blend that digs deeper than it says.
template <class Real>
struct SlackTooSmall {
    Real k = Real(0.01);
    Real combine(const Real& a, const Real& b) const { return min(a, b) - k; }
    static Real hard(const Real& a, const Real& b) { return min(a, b); }
    Slack slack() const { return {.below = 0.5 * k}; }
    static Exactness exactness(std::span<const Exactness>) { return {Side::bound, Side::bound}; }
    static Box2 bounds(std::span<const Box2>) { return Box2::everything(); }
    static constexpr auto describe() {
        return operation<SlackTooSmall>({.key = "slack_too_small", .exactness = {Side::bound, Side::bound}, .children = {1, any_number}},
                                        fields(field("k", &SlackTooSmall::k, {.unit = Unit::metre, .min = above(0)})));
    }
};

/// A mean whose derivatives are those of a minimum.
template <class Real>
struct WrongPartials {
    static Real combine(const Real& a, const Real& b) { return min(a, b) + Real(0.25) * (Real(frozen(b)) - Real(frozen(a))); }
    static Real hard(const Real& a, const Real& b) { return min(a, b); }
    static Slack slack() { return {1, 1}; }
    static Exactness exactness(std::span<const Exactness>) { return {Side::bound, Side::bound}; }
    static Box2 bounds(std::span<const Box2>) { return Box2::everything(); }
    static constexpr auto describe() {
        return operation<WrongPartials>({.key = "wrong_partials", .exactness = {Side::bound, Side::bound}, .children = {1, any_number}},
                                        fields());
    }
};

/// Says it grows by less than it does.
template <class Real>
struct WrongAffine {
    static Real modify(const Real& d) { return d - Real(0.01); }
    static Affine affine() { return {.offset = -0.005}; }
    static Exactness exactness(std::span<const Exactness> children) { return {children[0].outside, Side::bound}; }
    static Box2 bounds(std::span<const Box2> children) { return children[0].grown(0.01); }
    static constexpr auto describe() {
        return operation<WrongAffine>({.key = "wrong_affine", .exactness = {.inside = Side::bound}, .children = {1, 1}}, fields());
    }
};

/// Sends its packets through a large sum that its doubles survive.
template <class Real>
struct WarpPacketsOff {
    static Point<Real> warp(const Point<Real>& p) { return {p.x + Real(10) - Real(10), p.y}; }
    static Exactness exactness(std::span<const Exactness>) { return {Side::bound, Side::bound}; }
    static Box2 bounds(std::span<const Box2> children) { return children[0]; }
    static constexpr auto describe() {
        return operation<WarpPacketsOff>({.key = "warp_packets_off", .exactness = {Side::bound, Side::bound}, .children = {1, 1}},
                                         fields());
    }
};

/// The outline of a hole: drawn with the solid on its right.
template <class Real>
struct OutlineOfAHole {
    Real distance(const Point<Real>& p) const { return norm(p) - Real(r); }
    Box2 bounds() const { return Box2::centred(r, r); }
    void outline(Outline& out) const { out.push_back(Piece::circle({0, 0}, r, -1)); }
    static constexpr auto describe() { return shape<OutlineOfAHole>({.key = "outline_of_a_hole"}, fields()); }
};

/// The way to the foot decides the gradient, also where rounding is all that is left of it.
template <class Real>
struct NormalByFoot {
    Real distance(const Point<Real>& p) const {
        using Plain = decltype(frozen(Real(0)));
        const Point<Plain> q{frozen(p.x), frozen(p.y)};
        const Plain length = norm(q), scale = Plain(r) / max(length, Plain(1e-30));
        const auto at_centre = length <= Plain(0);
        const Point<Plain> foot{select(at_centre, Plain(r), q.x * scale), q.y * scale};
        const Real from_foot = norm(Point<Real>{p.x - Real(foot.x), p.y - Real(foot.y)});
        return select(length < Plain(r), -from_foot, from_foot);
    }
    Box2 bounds() const { return Box2::centred(r, r); }
    void outline(Outline& out) const { disc_outline(out); }
    static constexpr auto describe() { return shape<NormalByFoot>({.key = "normal_by_foot"}, fields()); }
};

/// A disc that is a nanometre larger than it was told, whatever its size.
template <class Real>
struct HiddenLength {
    Real radius = Real(r);
    Real distance(const Point<Real>& p) const { return norm(p) - radius - Real(1e-9); }
    Box2 bounds() const { return Box2::centred(radius + 1e-9, radius + 1e-9); }
    static constexpr auto describe() {
        return shape<HiddenLength>({.key = "hidden_length"},
                                   fields(field("radius", &HiddenLength::radius, {.unit = Unit::metre, .min = above(0)})));
    }
};

/// A union that prefers its first child, within the slack that it admits.
template <class Real>
struct FirstComesFirst {
    Real k = Real(0.01);
    Real combine(const Real& a, const Real& b) const { return min(a - k, b); }
    static Real hard(const Real& a, const Real& b) { return min(a, b); }
    Slack slack() const { return {.below = k}; }
    static Exactness exactness(std::span<const Exactness>) { return {Side::bound, Side::bound}; }
    static Box2 bounds(std::span<const Box2>) { return Box2::everything(); }
    static constexpr auto describe() {
        return operation<FirstComesFirst>(
            {.key = "first_comes_first", .exactness = {Side::bound, Side::bound}, .children = {1, any_number}},
            fields(field("k", &FirstComesFirst::k, {.unit = Unit::metre, .min = above(0)})));
    }
};

/// What is on the left of a closed chain, which is its inside for those who draw it counter-clockwise only.
template <class Real>
struct LeftOfChain {
    static constexpr double example[] = {-0.04, -0.03, 0.04, -0.03, 0, 0.04};
    PointList<Real> points{example, 3};
    double side = 1;
    static constexpr auto derived() { return std::tuple(&LeftOfChain::side); }
    void derive() { side = doubled_area(points.xy, points.count) < 0 ? -1.0 : 1.0; }
    Real distance(const Point<Real>& p) const { return Real(side) * distance_to_chain(p, points.xy, points.count, side); }
    Box2 bounds() const { return Box2::everything(); }
    static constexpr auto describe() {
        return shape<LeftOfChain>({.key = "left_of_chain"}, fields(field("points", &LeftOfChain::points, {.unit = Unit::metre})),
                                  contract("at least 3 points", [](const auto& chain) { return chain.points.count >= 3; }));
    }
};

/// The end of a wall that runs along +x, which branches by one number that it makes of a Real: of a box it sees one side only.
template <class Real>
struct BranchesByMiddle {
    Real distance(const Point<Real>& p) const {
        const Real beyond = norm(p) - Real(r), beside = abs(p.y) - Real(r);
        if constexpr (requires { frozen(p.x).lo; }) return frozen(p.x).lo + frozen(p.x).hi < 0 ? beyond : beside;
        else return select(p.x < Real(0), beyond, beside);
    }
    Box2 bounds() const { return {{-r, -r}, {infinity, r}}; }
    static constexpr auto describe() { return shape<BranchesByMiddle>({.key = "branches_by_middle"}, fields()); }
};

}  // namespace pinfield::sdf::faulty

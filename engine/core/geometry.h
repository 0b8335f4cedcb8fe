// Plane geometry shared by every layer: points, boxes, similarities.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace pinfield {

/// A point or vector in the plane, metres unless a name says otherwise.
using Vec2 = Eigen::Vector2d;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline double dot(const Vec2& a, const Vec2& b) { return a.x() * b.x() + a.y() * b.y(); }
/// z of the 3D cross product: > 0 when b lies counter-clockwise of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
/// Plain sqrt(x^2 + y^2): unlike hypot, the same bits from every libm, and symmetric in x and y.
inline double length(const Vec2& a) { return std::sqrt(a.x() * a.x() + a.y() * a.y()); }
/// Quarter turn counter-clockwise.
inline Vec2 perpendicular(const Vec2& a) { return {-a.y(), a.x()}; }

/// Axis-aligned box, possibly empty (lo > hi) or infinite.
struct Box2 {
    Vec2 lo{infinity, infinity}, hi{-infinity, -infinity};

    static Box2 empty() { return {}; }
    static Box2 everything() { return {{-infinity, -infinity}, {infinity, infinity}}; }
    /// Box of half sizes (hx, hy) about the origin.
    static Box2 centred(double hx, double hy) { return {{-hx, -hy}, {hx, hy}}; }
    static Box2 of(const Vec2& a, const Vec2& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

    bool is_empty() const { return lo.x() > hi.x() || lo.y() > hi.y(); }
    bool is_finite() const { return lo.allFinite() && hi.allFinite(); }
    Vec2 centre() const { return 0.5 * (lo + hi); }
    Vec2 size() const { return hi - lo; }
    bool contains(const Vec2& p) const {
        return lo.x() <= p.x() && p.x() <= hi.x() && lo.y() <= p.y() && p.y() <= hi.y();
    }
    bool overlaps(const Box2& b) const {
        return lo.x() <= b.hi.x() && b.lo.x() <= hi.x() && lo.y() <= b.hi.y() && b.lo.y() <= hi.y();
    }
    Box2 grown(double r) const { return is_empty() ? *this : Box2{lo - Vec2(r, r), hi + Vec2(r, r)}; }
    Box2 including(const Vec2& p) const { return {lo.cwiseMin(p), hi.cwiseMax(p)}; }
    Box2 merged(const Box2& b) const { return {lo.cwiseMin(b.lo), hi.cwiseMax(b.hi)}; }
    Box2 intersected(const Box2& b) const { return {lo.cwiseMax(b.lo), hi.cwiseMin(b.hi)}; }
    /// Distance from p to the box, 0 inside; infinity to an empty box. Never above the distance to anything in the box.
    double distance(const Vec2& p) const {
        const double dx = std::max({lo.x() - p.x(), p.x() - hi.x(), 0.0});
        const double dy = std::max({lo.y() - p.y(), p.y() - hi.y(), 0.0});
        return std::sqrt(dx * dx + dy * dy);
    }
};

/// Similarity of the plane: p -> offset + R(angle) * scale * F * p, where F negates y when `mirrored`.
/// (Negating x instead is the same map after half a turn.) Composes as frames do: world_from_b = world_from_a * a_from_b.
struct Similarity {
    double cosine = 1, sine = 0;
    double scale = 1;  // > 0
    bool mirrored = false;
    Vec2 offset{0, 0};

    static Similarity translation(const Vec2& d) { return {1, 0, 1, false, d}; }

    /// Maps a direction: rotation and reflection, no scale, no offset; keeps lengths.
    Vec2 direction(const Vec2& d) const {
        const double y = mirrored ? -d.y() : d.y();
        return {cosine * d.x() - sine * y, sine * d.x() + cosine * y};
    }
    Vec2 operator*(const Vec2& p) const { return offset + scale * direction(p); }
    Similarity operator*(const Similarity& b) const {
        const double s = mirrored ? -b.sine : b.sine;
        return {cosine * b.cosine - sine * s, sine * b.cosine + cosine * s, scale * b.scale, mirrored != b.mirrored,
                *this * b.offset};
    }
    Similarity inverse() const {
        Similarity inv{cosine, mirrored ? sine : -sine, 1 / scale, mirrored, {0, 0}};
        inv.offset = -(inv.scale * inv.direction(offset));
        return inv;
    }
    /// Axis-aligned box around the image of a box. An infinite side stays infinite on every axis it reaches.
    Box2 operator*(const Box2& b) const {
        if (b.is_empty()) return b;
        if (!b.is_finite()) return Box2::everything();
        Box2 out;
        for (const Vec2& corner : {b.lo, b.hi, Vec2(b.lo.x(), b.hi.y()), Vec2(b.hi.x(), b.lo.y())})
            out = out.including(*this * corner);
        return out;
    }
};

}  // namespace pinfield

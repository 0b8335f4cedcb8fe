// Equality of programs, bit for bit.
#pragma once
#include <bit>
#include <string>

#include "engine/program/program.h"

namespace pinfield::test {

inline bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
inline bool same(const Vec2& a, const Vec2& b) { return same(a.x(), b.x()) && same(a.y(), b.y()); }
inline bool same(const Box2& a, const Box2& b) { return same(a.lo, b.lo) && same(a.hi, b.hi); }
inline bool same(int a, int b) { return a == b; }
inline bool same(const Similarity& a, const Similarity& b) {
    return same(a.cosine, b.cosine) && same(a.sine, b.sine) && same(a.scale, b.scale) && a.mirrored == b.mirrored &&
           same(a.offset, b.offset);
}
inline bool same(const Op& a, const Op& b) {
    return a.kernels == b.kernels && a.params == b.params && a.param_count == b.param_count &&
           a.first_link == b.first_link && a.child_count == b.child_count && a.first_image == b.first_image &&
           a.image_count == b.image_count && same(a.local_from_field, b.local_from_field) && same(a.scale, b.scale) &&
           same(a.bounds, b.bounds) && a.exactness == b.exactness && a.origin == b.origin && a.material == b.material;
}
inline bool same(const Solid& a, const Solid& b) {
    return a.root == b.root && same(a.bounds, b.bounds) && a.origin == b.origin && a.part == b.part && a.layers == b.layers &&
           a.visible == b.visible && a.is_domain == b.is_domain && a.lowered == b.lowered && same(a.fit_error, b.fit_error) &&
           same(a.horizon, b.horizon) && a.first_piece == b.first_piece && a.piece_count == b.piece_count;
}
inline bool same(const BoundaryPiece& a, const BoundaryPiece& b) {
    const sdf::Piece &p = a.piece, &q = b.piece;
    return same(p.a, q.a) && same(p.b, q.b) && same(p.centre, q.centre) && same(p.radius, q.radius) &&
           p.turn == q.turn && p.reflex == q.reflex && a.solid == b.solid && a.leaf == b.leaf && a.layers == b.layers;
}
bool same(const Mover& a, const Mover& b);
bool same(const Sensor& a, const Sensor& b);
bool same(const Part& a, const Part& b);
bool same(const MaterialRecord& a, const MaterialRecord& b);
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!same(a[i], b[i])) return false;
    return true;
}

/// The order in which a hierarchy visits its entries says all that can be observed of it.
inline bool same_visits(const Field& a, const Field& b) {
    std::vector<int> visits[2];
    for (int k = 0; k < 2; ++k) {
        const Bvh& bvh = k == 0 ? a.bvh : b.bvh;
        for (const Vec2& p : {Vec2(0.1, 0.2), Vec2(-0.3, 0.7), Vec2(0.26, 0.9)})
            bvh.nearest(p, infinity, [&](int entry) {
                visits[k].push_back(entry);
                return infinity;
            });
        bvh.overlapping(Box2::of({0.1, 0.1}, {0.4, 0.6}), [&](int entry) { visits[k].push_back(entry); });
    }
    return visits[0] == visits[1];
}
inline bool same(const Field& a, const Field& b) {
    return same(a.ops, b.ops) && a.links == b.links && same(a.images, b.images) && same(a.params, b.params) &&
           same(a.solids, b.solids) && same(a.pieces, b.pieces) && a.tree_solids == b.tree_solids && same_visits(a, b);
}
inline bool same(const Mover& a, const Mover& b) {
    return same(a.field, b.field) && a.part == b.part && same(a.pivot, b.pivot) && same(a.cosine, b.cosine) &&
           same(a.sine, b.sine) && same(a.handedness, b.handedness) && same(a.bounding_radius, b.bounding_radius);
}
inline bool same(const Sensor& a, const Sensor& b) { return same(a.field, b.field) && a.part == b.part; }
inline bool same(const Part& a, const Part& b) {
    return a.type == b.type && a.origin == b.origin && a.name == b.name && same(a.world_from_part, b.world_from_part) &&
           same(a.params, b.params) && a.inputs == b.inputs && a.solid == b.solid && a.mover == b.mover &&
           a.sensor == b.sensor;
}
inline bool same(const MaterialRecord& a, const MaterialRecord& b) {
    return a.name == b.name && same(a.restitution, b.restitution) && same(a.falloff, b.falloff) &&
           same(a.tangential, b.tangential) && same(a.friction, b.friction) &&
           same(a.scatter_degrees, b.scatter_degrees) && a.color == b.color;
}
inline bool same(const PhysicsRecord& a, const PhysicsRecord& b) {
    return same(a.step, b.step) && a.integrator == b.integrator && same(a.gravity, b.gravity) &&
           same(a.ball_radius, b.ball_radius) && same(a.ball_mass, b.ball_mass) &&
           same(a.ball_restitution, b.ball_restitution) && same(a.tolerance, b.tolerance) &&
           same(a.rest_speed, b.rest_speed);
}
/// Empty, or the first thing that differs.
inline std::string difference(const Program& a, const Program& b) {
    if (!same(a.fixed.ops, b.fixed.ops)) return "ops";
    if (!same(a.fixed.solids, b.fixed.solids)) return "solids";
    if (!same(a.fixed.pieces, b.fixed.pieces)) return "pieces";
    if (!same(a.fixed, b.fixed)) return "fixed field";
    if (!same(a.movers, b.movers)) return "movers";
    if (!same(a.sensors, b.sensors)) return "sensors";
    if (!same(a.parts, b.parts)) return "parts";
    if (!same(a.materials, b.materials)) return "materials";
    if (!same(a.physics, b.physics)) return "physics";
    if (a.inputs != b.inputs || a.layers != b.layers || !same(a.size, b.size) || a.name != b.name) return "the rest";
    return {};
}

}  // namespace pinfield::test

// Equality of programs, bit for bit. Every struct is taken apart by a structured binding that names all its members, so that a new member
// does not compile until it is compared, too.
#pragma once
#include <bit>
#include <string>
#include <tuple>
#include <vector>

#include "engine/program/program.h"

namespace pinfield::test {

inline auto members(const Box2& box) {
    const auto& [lo, hi] = box;
    return std::tie(lo, hi);
}
inline auto members(const Similarity& similarity) {
    const auto& [cosine, sine, scale, mirrored, offset] = similarity;
    return std::tie(cosine, sine, scale, mirrored, offset);
}
inline auto members(const Op& op) {
    const auto& [kernels, params, param_count, first_link, child_count, first_image, image_count, local_from_field, scale, bounds,
                 exactness, origin, material] = op;
    return std::tie(kernels, params, param_count, first_link, child_count, first_image, image_count, local_from_field, scale, bounds,
                    exactness, origin, material);
}
inline auto members(const Solid& solid) {
    const auto& [root, bounds, origin, part, layers, visible, is_domain, lowered, fit_error, horizon, first_piece, piece_count] = solid;
    return std::tie(root, bounds, origin, part, layers, visible, is_domain, lowered, fit_error, horizon, first_piece, piece_count);
}
inline auto members(const sdf::Piece& piece) {
    const auto& [a, b, centre, radius, turn, reflex] = piece;
    return std::tie(a, b, centre, radius, turn, reflex);
}
inline auto members(const BoundaryPiece& boundary) {
    const auto& [piece, solid, leaf, layers] = boundary;
    return std::tie(piece, solid, leaf, layers);
}
inline auto members(const Field& field) {
    const auto& [ops, links, images, params, solids, pieces, bvh, tree_solids, horizon] = field;
    return std::tie(ops, links, images, params, solids, pieces, bvh, tree_solids, horizon);
}
inline auto members(const Mover& mover) {
    const auto& [field, part, pivot, cosine, sine, handedness, slides, axis, bounding_radius] = mover;
    return std::tie(field, part, pivot, cosine, sine, handedness, slides, axis, bounding_radius);
}
inline auto members(const Sensor& sensor) {
    const auto& [field, part] = sensor;
    return std::tie(field, part);
}
inline auto members(const Part& part) {
    const auto& [type, origin, name, world_from_part, params, layers, inputs, solid, mover, sensor] = part;
    return std::tie(type, origin, name, world_from_part, params, layers, inputs, solid, mover, sensor);
}
inline auto members(const MaterialRecord& material) {
    const auto& [name, restitution, falloff, tangential, friction, scatter_degrees, color] = material;
    return std::tie(name, restitution, falloff, tangential, friction, scatter_degrees, color);
}
inline auto members(const PhysicsRecord& physics) {
    const auto& [step, integrator, gravity, ball_radius, ball_mass, ball_restitution, ball_inertia, rolling_resistance, tolerance, rest_speed] =
        physics;
    return std::tie(step, integrator, gravity, ball_radius, ball_mass, ball_restitution, ball_inertia, rolling_resistance, tolerance, rest_speed);
}

/// The order in which a hierarchy visits its entries says all that can be observed of it.
inline std::vector<int> visits_of(const Bvh& bvh) {
    std::vector<int> visits;
    for (const Vec2& p : {Vec2(0.1, 0.2), Vec2(-0.3, 0.7), Vec2(0.26, 0.9)})
        bvh.nearest(p, infinity, [&](int entry) {
            visits.push_back(entry);
            return infinity;
        });
    bvh.overlapping(Box2::of({0.1, 0.1}, {0.4, 0.6}), [&](int entry) { visits.push_back(entry); });
    return visits;
}

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

/// A struct that is not taken apart above compiles only if it has an operator== of its own.
template <class T>
bool same(const T& a, const T& b) {
    if constexpr (std::is_same_v<T, double>) {
        return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
    } else if constexpr (std::is_same_v<T, Vec2>) {
        return same(a.x(), b.x()) && same(a.y(), b.y());
    } else if constexpr (std::is_same_v<T, Bvh>) {
        return visits_of(a) == visits_of(b);
    } else if constexpr (is_vector<T>) {
        if (a.size() != b.size()) return false;
        for (std::size_t i = 0; i < a.size(); ++i)
            if (!same(a[i], b[i])) return false;
        return true;
    } else if constexpr (requires { members(a); }) {
        const auto all = [&]<std::size_t... I>(std::index_sequence<I...>) {
            return (same(std::get<I>(members(a)), std::get<I>(members(b))) && ...);
        };
        return all(std::make_index_sequence<std::tuple_size_v<decltype(members(a))>>());
    } else {
        return a == b;
    }
}

/// Empty, or the first thing that differs.
inline std::string difference(const Program& a, const Program& b) {
    const auto& [catalog, fixed, movers, sensors, parts, materials, inputs, layers, physics, size, name] = a;
    if (!same(fixed.ops, b.fixed.ops)) return "ops";
    if (!same(fixed.solids, b.fixed.solids)) return "solids";
    if (!same(fixed.pieces, b.fixed.pieces)) return "pieces";
    if (!same(fixed, b.fixed)) return "fixed field";
    if (!same(movers, b.movers)) return "movers";
    if (!same(sensors, b.sensors)) return "sensors";
    if (!same(parts, b.parts)) return "parts";
    if (!same(materials, b.materials)) return "materials";
    if (!same(physics, b.physics)) return "physics";
    if (inputs != b.inputs || layers != b.layers || !same(size, b.size) || name != b.name) return "the rest";
    if (catalog != b.catalog) return "catalog";
    return {};
}

}  // namespace pinfield::test

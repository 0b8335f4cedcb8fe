// Distances of a Field at points.
#pragma once
#include "engine/program/program.h"

namespace pinfield {

/// The nearest solid surface as seen from a point.
struct Nearest {
    double distance = infinity;  ///< signed: negative inside a solid
    Vec2 gradient{0, 0};         ///< of the distance: points away from the surface outside; unit where certified
    int solid = -1;
    int leaf = -1;               ///< op whose surface it is: material and attribution
    bool certified = false;      ///< the distance is the true one, not only a bound
};

/// Signed distance to the union of the solids of these layers: the minimum over solids of each one's distance, which is exact for
/// solids of lines and arcs and where the formula's side is exact or its foot point certifies it, and within 1e-9
/// of its size for what was traced. Outside every solid the minimum is certified where the nearest solid's value is: the others' are
/// bounds, so none of them can truly be nearer. Inside, the greatest depth is certified where that solid's is and the way out ends in
/// the open.
/// `reach`: surfaces farther than this may be left out (the result then has solid == -1 and distance == reach).
Nearest nearest(const Field& field, const Vec2& p, LayerMask layers = ground_layer, double reach = infinity);

/// As nearest(), for a point known to lie outside all solids, and as the ball meets them: skips the inside tests, and takes a traced
/// boundary for the solid's own, never certified. What the sweep asks.
Nearest nearest_outside(const Field& field, const Vec2& p, LayerMask layers, double reach);

/// Where the shortest way to the open ends: a hair beyond the surface, so that what abuts there is met. All is open where no other solid
/// comes nearer than `clearance`.
struct Exit {
    Vec2 beyond;
    double clearance = 0;  ///< metres
    bool is_needed = false;  ///< false for points so far outside that no solid can lie over them
};
Exit exit_of(const Nearest& nearest, const Vec2& p);

/// Signed distance to one solid alone.
Nearest nearest_of_solid(const Field& field, int solid, const Vec2& p);

/// Raw value and gradient of an op's tree: what its formula says, exact or only a bound: op.exactness says which.
/// `leaf` receives the winning leaf: the one with whose own value the tree's moves most, the first of equals.
sdf::Sample evaluate_tree(const Field& field, int op, const Vec2& p, int* leaf = nullptr);

/// A solid to ask in packets. Where a packed outline (outline_distance.h) is given, it says how far, and the formula only on which side.
struct PacketSolid {
    int solid = 0;
    const double* outline = nullptr;
};
/// Distances of the union of the candidates at n points, float packets of an instruction set; `solid` (may be null) receives the winner's
/// index.
void evaluate_packets(const Field& field, std::span<const PacketSolid> candidates, const float* x, const float* y, int n,
                      float* distance, int* solid, sdf::Isa isa);

}  // namespace pinfield

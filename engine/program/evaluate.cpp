#include "engine/program/evaluate.h"

#include "engine/core/at.h"
#include "engine/program/trace.h"
#include "engine/program/tree.h"
#include "engine/program/zero_loops.h"
#include "engine/sdf/piece.h"

namespace pinfield {
namespace {

/// How far past the foot a certificate looks for the surface, relative to the size of the numbers at hand: some 10^5 roundings, more than
/// the deepest trees add up, and a hundredth of the 1e-9 that is promised.
constexpr double certificate_slack = 1e-11;

const Solid& solid_at(const Field& field, int solid) { return at(field.solids, solid); }

/// The nearest entry found so far by a search over Field::bvh. Of equals the lower entry stays, so that the result does
/// not depend on the order of visits.
struct Winner {
    double squared;
    int entry = -1;

    void offer(double distance_squared, int candidate) {
        if (distance_squared < squared || (distance_squared == squared && (entry < 0 || candidate < entry)))
            squared = distance_squared, entry = candidate;
    }
};

Nearest surface(const Field& field, int piece, const Vec2& p, bool inside_at_ends) {
    const BoundaryPiece& boundary = at(field.pieces, piece);
    const sdf::PieceFoot foot = foot_on_piece(boundary.piece, p);
    Nearest out;
    out.solid = boundary.solid;
    out.leaf = boundary.leaf;
    out.certified = solid_at(field, boundary.solid).fit_error == 0;
    const bool inside = foot.interior ? foot.inside : inside_at_ends;
    out.distance = inside ? -foot.distance : foot.distance;
    out.gradient = inside && !foot.interior ? Vec2(-foot.normal) : foot.normal;
    return out;
}

/// Is the value the true distance? Walk it along the gradient and a hair further: if the surface was crossed by then it
/// is no farther, and as a bound it is no nearer.
bool is_certified(const Field& field, const Op& root, int op, const Vec2& p, const sdf::Sample& s) {
    if ((s.value < 0 ? root.exactness.inside : root.exactness.outside) == Side::exact) return true;
    const double slack = certificate_slack * (1 + std::fabs(s.value) + p.cwiseAbs().maxCoeff());
    const double walk = s.value < 0 ? s.value - slack : s.value + slack;
    const double beyond = tree_value(field, op, p - walk * s.gradient);
    return s.value < 0 ? beyond >= 0 : beyond <= 0;
}

/// The gradient of a distance that was certified: on the surface a bound has the same foot, and rises more slowly.
Vec2 certified_gradient(const sdf::Sample& s) {
    const double slope = length(s.gradient);
    return slope > 0 && std::fabs(slope - 1) > 1e-9 ? Vec2(s.gradient / slope) : s.gradient;
}

/// The distance to a solid's box is a bound of the distance to the solid, too, and far from one that is warped the better one. It must be
/// asked wherever the formula is: the broad phase goes by boxes, and a ball that it lets come as near as the box says must not be
/// found to overlap what the formula says.
bool may_be_nearer_than_its_box(const Field& field, const Solid& solid) {
    return at(field.ops, solid.root).exactness.outside != Side::exact;
}

double outside_value(const Field& field, const Solid& solid, const Vec2& p) {
    const double value = std::max(tree_value(field, solid.root, p), 0.0);
    return may_be_nearer_than_its_box(field, solid) ? std::max(value, solid.bounds.distance(p)) : value;
}

Nearest surface_of_tree(const Field& field, int solid, const Vec2& p) {
    const int root = solid_at(field, solid).root;
    Nearest out;
    const sdf::Sample s = evaluate_tree(field, root, p, &out.leaf);
    out.distance = s.value;
    out.gradient = s.gradient;
    out.solid = solid;
    out.certified = is_certified(field, at(field.ops, root), root, p, s);
    if (out.certified) out.gradient = certified_gradient(s);
    const Box2& box = solid_at(field, solid).bounds;
    if (!out.certified && box.distance(p) > std::max(s.value, 0.0)) {
        const Vec2 from_box = p - p.cwiseMax(box.lo).cwiseMin(box.hi);
        out.distance = box.distance(p);
        out.gradient = from_box / length(from_box);
    }
    return out;
}

/// A traced boundary is a hair's breadth off the formula's zero line, and further at a sharp corner, by one over the sine of how it turns.
/// The formula itself may know the distance; else the foot is moved onto that line, or into its corner, which leaves of the error no more
/// than its square.
Nearest corrected(const Field& field, const Nearest& found, const Vec2& p) {
    if (found.solid < 0 || solid_at(field, found.solid).fit_error == 0) return found;
    const int root = solid_at(field, found.solid).root;
    const double error = 2 * solid_at(field, found.solid).fit_error, size = solid_at(field, found.solid).fit_error / trace_tolerance;
    const sdf::Sample s = evaluate_tree(field, root, p);
    if (std::fabs(s.value - found.distance) <= error && is_certified(field, at(field.ops, root), root, p, s))
        return {s.value, certified_gradient(s), found.solid, found.leaf, true};
    const Vec2 fitted = p - found.distance * found.gradient;
    const auto seen_from = [&](const Vec2& foot, double most) {
        Nearest out = found;
        const double distance = length(p - foot);
        if (std::fabs(distance - std::fabs(found.distance)) > most) return found;
        out.distance = s.value < 0 ? -distance : distance;
        if (distance > error) out.gradient = (p - foot) / out.distance;
        return out;
    };
    const std::optional<ZeroPoint> foot = zero_point_near(field, root, fitted, size);
    // A point of the line that is seen less squarely than this, the cosine of 89 degrees, is no foot but a place beside the corner that is
    // nearest: true feet are off square by no more than the fit's error over the distance.
    constexpr double most_oblique = 0.02;
    if (foot && std::fabs(dot(p - foot->at, foot->along)) <= most_oblique * length(p - foot->at)) return seen_from(foot->at, error);
    const std::optional<ZeroCorner> corner = zero_corner_near(field, root, fitted, 2 * error, size);
    if (corner) return seen_from(corner->at, error / corner->sine);
    return foot ? seen_from(foot->at, error) : found;
}

/// Index of the piece of a lowered solid that is nearest to p.
int nearest_piece_of(const Field& field, int index, const Vec2& p) {
    const Solid& solid = solid_at(field, index);
    Winner winner{infinity};
    const int end = solid.first_piece + solid.piece_count;
    constexpr int few = 48;  // below this a plain loop beats a search that meets the other solids' pieces too
    if (solid.piece_count <= few) {
        for (int i = solid.first_piece; i < end; ++i)
            winner.offer(squared_distance_to_piece(at(field.pieces, i).piece, p), i);
    } else {
        field.bvh.nearest_squared(p, infinity, [&](int entry) {
            if (solid.first_piece <= entry && entry < end)
                winner.offer(squared_distance_to_piece(at(field.pieces, entry).piece, p), entry);
            return winner.squared;
        });
    }
    return winner.entry;
}

/// May the pieces' distance be wrong, because an endless solid's may lie nearer where they were cut off?
bool reaches_beyond(double horizon, const Vec2& p, double distance) {
    return horizon < infinity && length(p) + std::fabs(distance) > horizon;
}

bool contains(const Field& field, const Solid& solid, const Vec2& p) {
    return solid.bounds.contains(p) && tree_value(field, solid.root, p) < 0;
}

/// Does any solid of these layers, other than `except`, lie over the end of the way out?
bool is_covered(const Field& field, const Exit& way, LayerMask layers, int except) {
    for (std::size_t i = 0; i < field.solids.size(); ++i) {
        const Solid& solid = field.solids[i];
        if (static_cast<int>(i) == except || !(solid.layers & layers) || solid.bounds.distance(way.beyond) > way.clearance) continue;
        if (tree_value(field, solid.root, way.beyond) <= way.clearance) return true;
    }
    return false;
}

/// Far out, where each solid is asked by what is known of it there.
Nearest nearest_one_by_one(const Field& field, const Vec2& p, LayerMask layers, double reach) {
    Nearest out{.distance = reach};
    for (std::size_t i = 0; i < field.solids.size(); ++i) {
        if (!(field.solids[i].layers & layers)) continue;
        const Nearest here = nearest_of_solid(field, static_cast<int>(i), p);
        if (here.distance < out.distance) out = here;
    }
    return out;
}

}  // namespace

Nearest nearest_outside(const Field& field, const Vec2& p, LayerMask layers, double reach) {
    const int pieces = static_cast<int>(field.pieces.size());
    Winner winner{reach * reach};
    field.bvh.nearest_squared(p, winner.squared, [&](int entry) {
        if (entry < pieces) {
            const BoundaryPiece& boundary = at(field.pieces, entry);
            if (boundary.layers & layers) winner.offer(squared_distance_to_piece(boundary.piece, p), entry);
        } else {
            const Solid& solid = solid_at(field, at(field.tree_solids, entry - pieces));
            if (solid.layers & layers) {
                const double value = outside_value(field, solid, p);
                winner.offer(value * value, entry);
            }
        }
        return winner.squared;
    });
    const double distance = std::sqrt(winner.squared);
    if (reaches_beyond(field.horizon, p, distance)) return nearest_one_by_one(field, p, layers, reach);
    if (winner.entry < 0) return {.distance = reach};
    if (winner.entry < pieces) return surface(field, winner.entry, p, false);
    return surface_of_tree(field, at(field.tree_solids, winner.entry - pieces), p);
}

Nearest nearest_of_solid(const Field& field, int index, const Vec2& p) {
    const Solid& solid = solid_at(field, index);
    if (!solid.lowered) return surface_of_tree(field, index, p);
    const Nearest found = surface(field, nearest_piece_of(field, index, p), p, contains(field, solid, p));
    return reaches_beyond(solid.horizon, p, found.distance) ? surface_of_tree(field, index, p) : corrected(field, found, p);
}

Nearest nearest(const Field& field, const Vec2& p, LayerMask layers, double reach) {
    Nearest out;
    for (std::size_t i = 0; i < field.solids.size(); ++i) {
        const Solid& solid = field.solids[i];
        if (!(solid.layers & layers) || !contains(field, solid, p)) continue;
        const Nearest here = nearest_of_solid(field, static_cast<int>(i), p);
        if (here.distance < out.distance) out = here;
    }
    if (out.solid < 0) out = corrected(field, nearest_outside(field, p, layers, reach), p);
    if (!out.certified) return out;
    const Exit way = exit_of(out, p);
    if (way.is_needed) out.certified = !is_covered(field, way, layers, out.solid);
    return out;
}

Exit exit_of(const Nearest& nearest, const Vec2& p) {
    const double hair = certificate_slack * (1 + std::fabs(nearest.distance) + p.cwiseAbs().maxCoeff());
    return {p + (hair - nearest.distance) * nearest.gradient, 0.5 * hair, nearest.distance <= hair};
}

}  // namespace pinfield

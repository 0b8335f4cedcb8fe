#include "engine/program/offset.h"

#include <algorithm>
#include <cmath>

#include "engine/core/at.h"
#include "engine/program/cutting.h"
#include "engine/program/tree.h"
#include "engine/sdf/piece.h"

namespace pinfield {
namespace {

using sdf::Piece;

/// The signed distances, metres, at which f(d) = 0: on which side of the boundary, and how far from it, the new one runs.
std::vector<double> levels_of(const Op& op, const double* params) {
    const sdf::Affine affine = op.kernels->affine(params);
    const double level = -affine.offset * op.scale;
    if (!affine.absolute) return {affine.sign * level};
    return level > 0 ? std::vector<double>{level, -level} : std::vector<double>{};
}

/// Appends the piece moved out of the solid by `distance`, unless that turns an arc inside out.
void add_parallel(const OwnedPiece& owned, double distance, double tolerance, std::vector<CutPiece>& edges) {
    const Piece& piece = owned.piece;
    const int owner = static_cast<int>(edges.size());
    if (!piece.is_arc()) {
        const Vec2 along = piece.b - piece.a, shift = -(distance / length(along)) * perpendicular(along);
        edges.push_back(cut_piece_of(Piece::segment(piece.a + shift, piece.b + shift), owner, owned.origin));
        return;
    }
    const double radius = piece.radius + piece.turn * distance;
    if (radius <= tolerance) return;
    const auto moved = [&](const Vec2& p) { return Vec2(piece.centre + (radius / length(p - piece.centre)) * (p - piece.centre)); };
    Piece out = piece.is_full_circle() ? Piece::circle(piece.centre, radius, piece.turn)
                                       : Piece::arc(piece.centre, radius, moved(piece.a), moved(piece.b), piece.turn, piece.reflex);
    edges.push_back(cut_piece_of(out, owner, owned.origin));
}

/// Every corner once, with the piece that leaves or enters it.
std::vector<std::pair<Vec2, int>> corners_of(const std::vector<OwnedPiece>& boundary, double tolerance) {
    std::vector<std::pair<Vec2, int>> corners;
    for (const OwnedPiece& owned : boundary) {
        if (owned.piece.is_full_circle()) continue;
        for (const Vec2& end : {owned.piece.a, owned.piece.b}) {
            const bool known =
                std::any_of(corners.begin(), corners.end(), [&](const auto& c) { return length(c.first - end) <= tolerance; });
            if (!known) corners.emplace_back(end, owned.origin);
        }
    }
    return corners;
}

}  // namespace

bool offset_is_exact(const Exactness& child, const sdf::Affine& affine) {
    const bool outside = child.outside == Side::exact, inside = child.inside == Side::exact;
    if (affine.absolute) return outside && inside;
    const double level = -affine.sign * affine.offset;
    return level == 0 || (level > 0 ? outside : inside);
}

/// Every point of the new boundary is at that distance from a piece or from a corner: so it lies on the parallel of a piece or on a circle
/// about a corner. All of these are cut where they meet, and those parts stay across which the offset's own field changes sign.
std::vector<OwnedPiece> offset_boundary(const Field& field, int offset_op, const std::vector<OwnedPiece>& boundary) {
    const Op& op = at(field.ops, offset_op);
    const std::vector<double> levels = levels_of(op, field.params.data() + op.params);
    double extent = 0;
    for (const OwnedPiece& owned : boundary) {
        const Box2 box = cut_piece_of(owned.piece, 0, 0).box;
        extent = std::max({extent, box.lo.cwiseAbs().maxCoeff(), box.hi.cwiseAbs().maxCoeff()});
    }
    for (const double level : levels) extent = std::max(extent, std::fabs(level));
    const double tolerance = 1e-12 * extent;

    std::vector<CutPiece> edges;
    for (const double level : levels)
        for (const OwnedPiece& owned : boundary) add_parallel(owned, level, tolerance, edges);
    const double radius = levels.empty() ? 0 : std::fabs(levels[0]);
    if (radius > tolerance)
        for (const auto& [corner, origin] : corners_of(boundary, tolerance))
            edges.push_back(cut_piece_of(Piece::circle(corner, radius), static_cast<int>(edges.size()), origin));
    cut_all(edges, tolerance);

    std::vector<OwnedPiece> out;
    const double aside = 100 * tolerance;
    for (const CutPiece& edge : edges)
        for (const Piece& part : parts_of(edge)) {
            const Probe probe = probe_of(part, edge.cuts);
            const double right = tree_value(field, offset_op, probe.at + aside * probe.right);
            const double left = tree_value(field, offset_op, probe.at - aside * probe.right);
            if ((left < 0) != (right < 0)) out.push_back({left < 0 ? part : reversed(part), edge.origin});
        }
    return out;
}

}  // namespace pinfield

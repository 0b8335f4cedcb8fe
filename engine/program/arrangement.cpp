#include "engine/program/arrangement.h"

#include <algorithm>

#include "engine/program/cutting.h"
#include "engine/program/evaluate.h"
#include "engine/sdf/piece.h"

namespace pinfield {
namespace {

using sdf::Piece;

class Arrangement {
public:
    Arrangement(const Field& field, int root, const FoundLeaves& found)
        : field_(field), leaves_(found.leaves), membership_(field, root, found.lattice_copies) {
        const std::vector<LeafImage>& leaves = found.leaves;
        double extent = 0;
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const Vec2 middle = 0.5 * (leaves[i].outline[0].a + leaves[i].outline[0].b);  // of a line, near the rest
            const Box2 box = leaves[i].endless ? Box2{middle, middle} : leaves[i].bounds;
            extent = std::max({extent, box.lo.cwiseAbs().maxCoeff(), box.hi.cwiseAbs().maxCoeff()});
            for (std::size_t k = 0; k < leaves[i].outline.size(); ++k)
                edges_.push_back(cut_piece_of(leaves[i].outline[k], static_cast<int>(i), leaves[i].origin(k)));
        }
        // Thousands of roundings wide, so that outlines meant to touch do; far below the 1e-9 that lowering promises.
        tolerance_ = 1e-12 * extent;
    }

    std::vector<OwnedPiece> boundary() {
        cut_all(edges_, tolerance_);
        std::vector<OwnedPiece> out;
        for (const CutPiece& edge : edges_)
            for (const Piece& part : parts_of(edge)) judge(edge, part, out);
        return out;
    }

private:
    /// Keeps the part when the solid lies on one side of it only. Sides are judged leaf by leaf: the part's own leaf is
    /// on its left; any other holds both sides or none, unless its outline runs along here, which the sign of its
    /// gradient then resolves. Of parts that run along each other the first leaf's stays.
    void judge(const CutPiece& edge, const Piece& part, std::vector<OwnedPiece>& out) {
        const Probe probe = probe_of(part, edge.cuts);
        std::vector<char> left(leaves_.size(), 0), right(leaves_.size(), 0);
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            const LeafImage& leaf = leaves_[i];
            if (static_cast<int>(i) == edge.owner) {
                left[i] = 1;
                continue;
            }
            if (!leaf.bounds.grown(tolerance_).contains(probe.at)) continue;
            const sdf::Sample sample = sample_of(leaf, probe.at);
            if (std::fabs(sample.value) > tolerance_) {
                left[i] = right[i] = sample.value < 0;
                continue;
            }
            if (static_cast<int>(i) < edge.owner) return;
            const bool same_way = dot(sample.gradient, probe.right) > 0;
            left[i] = same_way;
            right[i] = !same_way;
        }
        const bool solid_left = membership_.solid(left), solid_right = membership_.solid(right);
        if (solid_left != solid_right) out.push_back({solid_left ? part : reversed(part), edge.origin});
    }

    /// The leaf's distance at p, or a bound of it. Its outline is asked, which is what the others are cut by, where p is on it and the
    /// formula's foot is too near to have a side, and where it was traced.
    sdf::Sample sample_of(const LeafImage& leaf, const Vec2& p) const {
        const sdf::Sample own = evaluate_tree(field_, leaf.leaf, leaf.field_from_leaf.inverse() * p);
        if (leaf.error == 0 && (std::fabs(own.value) > tolerance_ || leaf.endless))
            return {own.value, leaf.field_from_leaf.direction(own.gradient)};
        sdf::PieceFoot nearest;
        for (const Piece& piece : leaf.outline) {
            const sdf::PieceFoot foot = foot_on_piece(piece, p);
            if (foot.distance < nearest.distance) nearest = foot;
        }
        const bool inside = nearest.interior ? nearest.inside : own.value < 0;
        return {inside ? -nearest.distance : nearest.distance, nearest.normal};
    }

    const Field& field_;
    const std::vector<LeafImage>& leaves_;
    Membership membership_;
    std::vector<CutPiece> edges_;
    double tolerance_ = 0;
};

}  // namespace

std::vector<OwnedPiece> boundary_of(const Field& field, int root, const FoundLeaves& found) {
    const std::vector<LeafImage>& leaves = found.leaves;
    if (leaves.size() > 1) return Arrangement(field, root, found).boundary();
    std::vector<OwnedPiece> out;
    const Membership membership(field, root, found.lattice_copies);
    const bool in_is_solid = membership.solid({1}), out_is_solid = membership.solid({0});
    if (in_is_solid == out_is_solid) return out;
    for (std::size_t k = 0; k < leaves[0].outline.size(); ++k) {
        const Piece& piece = leaves[0].outline[k];
        out.push_back({in_is_solid ? piece : reversed(piece), leaves[0].origin(k)});
    }
    return out;
}

}  // namespace pinfield

#include "engine/program/arrangement.h"

#include <algorithm>

#include "engine/program/evaluate.h"
#include "engine/program/meet.h"
#include "engine/program/piece_distance.h"

namespace pinfield {
namespace {

using sdf::Piece;

Piece reversed(const Piece& piece) {
    Piece out = piece;
    std::swap(out.a, out.b);
    out.turn = -piece.turn;
    return out;
}

struct Edge {
    Piece piece;
    int owner = 0;
    Box2 box;
    std::vector<Vec2> cuts;
};

/// Grows with the position along the piece, from its start.
double position_along(const Piece& piece, const Vec2& p) {
    if (!piece.is_arc()) return dot(p - piece.a, piece.b - piece.a);
    const Vec2 start = piece.a - piece.centre, here = p - piece.centre;
    const double sine = piece.turn * cross(start, here), cosine = dot(start, here);
    const double share =
        cosine / (std::fabs(sine) + std::fabs(cosine));  // an angle in all but name: 0 ... 4 round the circle
    return sine >= 0 ? 1 - share : 3 + share;
}

Piece part_of(const Piece& piece, const Vec2& from, const Vec2& to) {
    Piece out = piece;
    out.a = from;
    out.b = to;
    if (piece.is_arc()) out.reflex = piece.turn * cross(from - piece.centre, to - piece.centre) < 0;
    return out;
}

std::vector<Piece> parts_of(const Edge& edge) {
    std::vector<Vec2> cuts = edge.cuts;
    std::sort(cuts.begin(), cuts.end(), [&](const Vec2& p, const Vec2& q) {
        return position_along(edge.piece, p) < position_along(edge.piece, q);
    });
    std::vector<Piece> parts;
    if (edge.piece.is_full_circle()) {
        if (cuts.size() < 2) return {edge.piece};
        for (std::size_t i = 0; i < cuts.size(); ++i)
            parts.push_back(part_of(edge.piece, cuts[i], cuts[(i + 1) % cuts.size()]));
        return parts;
    }
    if (cuts.empty()) return {edge.piece};
    cuts.push_back(edge.piece.b);
    Vec2 from = edge.piece.a;
    for (const Vec2& to : cuts) {
        parts.push_back(part_of(edge.piece, from, to));
        from = to;
    }
    return parts;
}

/// A point of the piece away from its ends and, for an uncut circle, from `touched`; with the normal to its right.
struct Probe {
    Vec2 at, right;
};

Probe probe_of(const Piece& piece, const std::vector<Vec2>& touched) {
    if (!piece.is_arc()) {
        const Vec2 along = piece.b - piece.a;
        return {0.5 * (piece.a + piece.b), -perpendicular(along) / length(along)};
    }
    Vec2 ray(-1, 0);
    if (!piece.is_full_circle()) {
        const Vec2 chord = piece.b - piece.a;  // an arc bulges to the side of its chord that it does not turn to
        ray = -piece.turn * perpendicular(chord) / length(chord);
    } else if (!touched.empty()) {
        ray = (piece.centre - touched[0]) / length(piece.centre - touched[0]);
    }
    return {piece.centre + piece.radius * ray, piece.turn * ray};
}

class Arrangement {
public:
    Arrangement(const Field& field, int root, const std::vector<LeafImage>& leaves)
        : field_(field), root_(root), leaves_(leaves) {
        double extent = 0;
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            extent = std::max(
                {extent, leaves[i].bounds.lo.cwiseAbs().maxCoeff(), leaves[i].bounds.hi.cwiseAbs().maxCoeff()});
            for (const Piece& piece : leaves[i].outline)
                edges_.push_back({piece, static_cast<int>(i), bounds_of(piece), {}});
        }
        // Thousands of roundings wide, so that outlines meant to touch do; far below the 1e-9 that lowering promises.
        tolerance_ = 1e-12 * extent;
    }

    std::vector<OwnedPiece> boundary() {
        cut_all();
        std::vector<OwnedPiece> out;
        for (const Edge& edge : edges_)
            for (const Piece& part : parts_of(edge)) judge(edge, part, out);
        return out;
    }

private:
    void cut_pair(Edge& a, Edge& b) {
        if (a.owner != b.owner && a.box.grown(tolerance_).overlaps(b.box))
            meet(a.piece, b.piece, tolerance_, a.cuts, b.cuts);
    }

    void cut_all() {
        std::vector<Box2> boxes;
        for (const Edge& edge : edges_) boxes.push_back(edge.box);
        const Bvh bvh(boxes);
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            std::vector<int> partners;
            bvh.overlapping(edges_[i].box.grown(tolerance_), [&](int j) { partners.push_back(j); });
            std::sort(partners.begin(), partners.end());
            for (const int j : partners)
                if (static_cast<std::size_t>(j) > i) cut_pair(edges_[i], edges_[static_cast<std::size_t>(j)]);
        }
    }

    /// Keeps the part when the solid lies on one side of it only. Sides are told leaf by leaf: the part's own leaf is
    /// on its left; any other holds both sides or none, unless its outline runs along here, which the sign of its
    /// gradient then resolves. Of parts that run along each other the first leaf's stays.
    void judge(const Edge& edge, const Piece& part, std::vector<OwnedPiece>& out) {
        const Probe probe = probe_of(part, edge.cuts);
        std::vector<char> left(leaves_.size(), 0), right(leaves_.size(), 0);
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            const LeafImage& leaf = leaves_[i];
            if (static_cast<int>(i) == edge.owner) {
                left[i] = 1;
                continue;
            }
            if (!leaf.bounds.grown(tolerance_).contains(probe.at)) continue;
            const sdf::Sample sample = evaluate_tree(field_, leaf.leaf, leaf.field_from_leaf.inverse() * probe.at);
            if (std::fabs(sample.value) > tolerance_) {
                left[i] = right[i] = sample.value < 0;
                continue;
            }
            if (static_cast<int>(i) < edge.owner) return;
            const bool same_way = dot(leaf.field_from_leaf.direction(sample.gradient), probe.right) > 0;
            left[i] = same_way;
            right[i] = !same_way;
        }
        const bool solid_left = is_in_tree(field_, root_, left), solid_right = is_in_tree(field_, root_, right);
        if (solid_left != solid_right) out.push_back({solid_left ? part : reversed(part), edge.owner});
    }

    const Field& field_;
    int root_;
    const std::vector<LeafImage>& leaves_;
    std::vector<Edge> edges_;
    double tolerance_ = 0;
};

}  // namespace

std::vector<OwnedPiece> boundary_of(const Field& field, int root, const std::vector<LeafImage>& leaves) {
    if (leaves.size() > 1) return Arrangement(field, root, leaves).boundary();
    std::vector<OwnedPiece> out;
    const bool in_is_solid = is_in_tree(field, root, {1}), out_is_solid = is_in_tree(field, root, {0});
    if (in_is_solid == out_is_solid) return out;
    for (const Piece& piece : leaves[0].outline) out.push_back({in_is_solid ? piece : reversed(piece), 0});
    return out;
}

}  // namespace pinfield

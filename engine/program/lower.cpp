#include "engine/program/lower.h"

#include <algorithm>
#include <map>

#include "engine/program/arrangement.h"
#include "engine/program/field.h"
#include "engine/program/offset.h"
#include "engine/program/piece_distance.h"
#include "engine/program/trace.h"

namespace pinfield {
namespace {

using sdf::Form;
using sdf::Piece;

/// A mirrored piece runs the other way round to keep the solid on its left; an arc then turns as it did before.
Piece moved(const Similarity& to_from, const Piece& piece) {
    Piece out = piece;
    out.a = to_from * (to_from.mirrored ? piece.b : piece.a);
    out.b = piece.is_full_circle() ? out.a : Vec2(to_from * (to_from.mirrored ? piece.a : piece.b));
    if (!piece.is_arc()) return out;
    out.centre = to_from * piece.centre;
    out.radius = to_from.scale * piece.radius;
    return out;
}

/// Does the operation only ask whether a point is in its operands? (A boundary stands for the solid below it.)
bool is_boolean(const sdf::Kernels& kernels, const double* params) {
    switch (kernels.form) {
        case Form::shape: return kernels.outline || kernels.endless;
        case Form::fold: return kernels.combine_hard == kernels.combine;
        case Form::modify: {
            const sdf::Affine affine = kernels.affine(params);
            return !affine.absolute && affine.offset == 0;
        }
        case Form::images: return true;
        case Form::warp: return false;
    }
    return false;
}

/// A walk of a tree for its leaves. What was traced once is copied where images show it again.
class LeafCollector {
public:
    explicit LeafCollector(const Field& field) : field_(field) {}

    /// False when something below the op has no outline and cannot be traced.
    bool collect(int index, const Similarity& chain);
    std::vector<LeafImage> leaves;

private:
    bool add_shape(int index, const Similarity& chain);
    bool add_half_plane(int index, const Similarity& chain);
    bool add_offset(int index, const Similarity& chain);
    bool add_traced(int index, const Similarity& chain);
    bool add(int index, const Similarity& chain, const std::vector<OwnedPiece>& pieces, double error = 0);

    const Field& field_;
    std::map<int, TracedBoundary> traced_;
};

bool LeafCollector::add(int index, const Similarity& chain, const std::vector<OwnedPiece>& pieces, double error) {
    if (pieces.empty()) return false;
    LeafImage leaf{index, chain, {}, {}};
    leaf.error = error;
    for (const OwnedPiece& piece : pieces) {
        leaf.outline.push_back(moved(chain, piece.piece));
        leaf.origins.push_back(piece.origin);
        leaf.bounds = leaf.bounds.merged(bounds_of(leaf.outline.back()));
    }
    leaves.push_back(std::move(leaf));
    return true;
}

bool LeafCollector::add_offset(int index, const Similarity& chain) {
    const Op& op = field_.ops[static_cast<std::size_t>(index)];
    const FoundBoundary below = boundary_below(field_, field_.links[static_cast<std::size_t>(op.first_link)]);
    // The offset's own field is the distance to a formula's zero line, and a hair's breadth from parallels of what was fitted to it.
    if (below.pieces.empty() || below.error > 0 || below.horizon < infinity) return add_traced(index, chain);
    return add(index, chain, offset_boundary(field_, index, below.pieces));
}

bool LeafCollector::add_traced(int index, const Similarity& chain) {
    const auto known = traced_.find(index);
    const TracedBoundary& traced = known != traced_.end() ? known->second : traced_[index] = traced_boundary(field_, index);
    return add(index, chain, traced.pieces, traced.error);
}

bool LeafCollector::add_shape(int index, const Similarity& chain) {
    const Op& op = field_.ops[static_cast<std::size_t>(index)];
    sdf::Outline local;
    op.kernels->outline(field_.params.data() + op.params, local);
    const Similarity field_from_local = op.local_from_field.inverse();
    std::vector<OwnedPiece> pieces;
    for (const Piece& piece : local) pieces.push_back({moved(field_from_local, piece), index});
    return add(index, chain, pieces);
}

/// A metre of its line to either side of the point nearest to the origin: cut_at_horizon() makes it long.
bool LeafCollector::add_half_plane(int index, const Similarity& chain) {
    const Similarity field_from_local = chain * field_.ops[static_cast<std::size_t>(index)].local_from_field.inverse();
    const Vec2 on_line = field_from_local.offset, along = field_from_local.direction({field_from_local.mirrored ? 1 : -1, 0});
    const Vec2 nearest = on_line - dot(on_line, along) * along;
    LeafImage leaf{index, chain, {Piece::segment(nearest - along, nearest + along)}, Box2::everything()};
    leaf.endless = true;
    leaves.push_back(std::move(leaf));
    return true;
}

bool LeafCollector::collect(int index, const Similarity& chain) {
    const Op& op = field_.ops[static_cast<std::size_t>(index)];
    if (is_boundary(op)) return collect(field_.links[static_cast<std::size_t>(op.first_link)], chain);
    if (!is_boolean(*op.kernels, field_.params.data() + op.params))
        return op.kernels->form == Form::modify ? add_offset(index, chain) : add_traced(index, chain);
    if (op.kernels->form == Form::shape) return op.kernels->endless ? add_half_plane(index, chain) : add_shape(index, chain);
    const int appearances = op.kernels->form == Form::images ? op.image_count : 1;
    for (int image = 0; image < appearances; ++image)
        for (int i = 0; i < op.child_count; ++i) {
            const int child = field_.links[static_cast<std::size_t>(op.first_link + i)];
            const bool in_place = op.kernels->form != Form::images;
            const Similarity here =
                in_place ? chain : chain * field_.images[static_cast<std::size_t>(op.first_image + image)];
            if (!collect(child, here)) return false;
        }
    return true;
}

/// Walks the tree as LeafCollector does; a field of -1 stands for inside and 1 for outside.
double membership(const Field& field, int index, const std::vector<char>& in_leaf, std::size_t& next) {
    const Op& op = field.ops[static_cast<std::size_t>(index)];
    const double* params = field.params.data() + op.params;
    const auto child = [&](int i) {
        return membership(field, field.links[static_cast<std::size_t>(op.first_link + i)], in_leaf, next);
    };
    if (is_boundary(op)) return child(0);
    switch (op.kernels->form) {
        case Form::shape: return in_leaf[next++] ? -1.0 : 1.0;
        case Form::fold: {
            if (!is_boolean(*op.kernels, params)) return in_leaf[next++] ? -1.0 : 1.0;
            double value = child(0);
            for (int i = 1; i < op.child_count; ++i) value = op.kernels->combine(params, value, child(i));
            return value;
        }
        case Form::modify:
            if (!is_boolean(*op.kernels, params)) return in_leaf[next++] ? -1.0 : 1.0;
            return op.kernels->affine(params).sign * child(0);
        case Form::images: {
            double value = 1;
            for (int i = 0; i < op.image_count; ++i) value = std::min(value, child(0));
            return value;
        }
        case Form::warp: return in_leaf[next++] ? -1.0 : 1.0;
    }
    return 1;
}

/// Gives half planes the length that is needed; the horizon: how far from the origin that is.
double cut_at_horizon(std::vector<LeafImage>& leaves) {
    if (std::none_of(leaves.begin(), leaves.end(), [](const LeafImage& leaf) { return leaf.endless; })) return infinity;
    double reach = 0;
    for (const LeafImage& leaf : leaves) {
        const Box2 box = leaf.endless ? bounds_of(leaf.outline[0]) : leaf.bounds;
        reach = std::max({reach, box.lo.cwiseAbs().maxCoeff(), box.hi.cwiseAbs().maxCoeff()});
    }
    const double horizon = horizon_reaches * reach;
    for (LeafImage& leaf : leaves) {
        if (!leaf.endless) continue;
        Piece& line = leaf.outline[0];
        const Vec2 middle = 0.5 * (line.a + line.b), along = 0.5 * (line.b - line.a);
        line = Piece::segment(middle - horizon * along, middle + horizon * along);
    }
    return horizon;
}

}  // namespace

FoundLeaves leaf_images(const Field& field, int root) {
    LeafCollector collector(field);
    if (!collector.collect(root, Similarity{})) return {};
    const double horizon = cut_at_horizon(collector.leaves);
    return {std::move(collector.leaves), horizon};
}

bool is_in_tree(const Field& field, int root, const std::vector<char>& in_leaf) {
    std::size_t next = 0;
    return membership(field, root, in_leaf, next) < 0;
}

FoundBoundary boundary_below(const Field& field, int root) {
    const auto [leaves, horizon] = leaf_images(field, root);
    if (leaves.empty()) {
        TracedBoundary traced = traced_boundary(field, root);
        return {std::move(traced.pieces), traced.error};
    }
    double error = 0;
    for (const LeafImage& leaf : leaves) error = std::max(error, leaf.error);
    // What has an end has it within the reach of what is not endless.
    const bool ends = field.ops[static_cast<std::size_t>(root)].bounds.is_finite();
    return {boundary_of(field, root, leaves), error, ends ? infinity : horizon};
}

void lower(Field& field, int index) {
    Solid& solid = field.solids[static_cast<std::size_t>(index)];
    solid.first_piece = static_cast<int>(field.pieces.size());
    const FoundBoundary boundary = boundary_below(field, solid.root);
    if (boundary.pieces.empty()) return;  // nothing, or everything: only the tree can tell which
    const Exactness& formula = field.ops[static_cast<std::size_t>(solid.root)].exactness;
    if (boundary.horizon < infinity && formula.outside == Side::exact && formula.inside == Side::exact) return;  // it knows no horizon
    for (const OwnedPiece& piece : boundary.pieces)
        field.pieces.push_back({piece.piece, index, piece.origin, solid.layers});
    solid.piece_count = static_cast<int>(boundary.pieces.size());
    solid.lowered = true;
    solid.fit_error = boundary.error;
    solid.horizon = boundary.horizon;
}

}  // namespace pinfield

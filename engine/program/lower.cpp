#include "engine/program/lower.h"

#include <algorithm>
#include <map>

#include "engine/core/at.h"
#include "engine/program/arrangement.h"
#include "engine/program/field.h"
#include "engine/program/offset.h"
#include "engine/program/trace.h"
#include "engine/sdf/piece.h"

namespace pinfield {
namespace {

using sdf::Form;
using sdf::Piece;

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

/// A walk of a tree for its leaves. What was traced once is copied where images show it again; of lattices those copies count that meet
/// the solid's bounds.
class LeafCollector {
public:
    LeafCollector(const Field& field, const Box2& bounds) : field_(field), bounds_(bounds) {}

    /// False when something below the op has no outline and cannot be traced.
    bool collect(int index, const Similarity& chain);
    std::vector<LeafImage> leaves;
    std::vector<int> lattice_copies;  ///< in the order of the walk

private:
    bool collect_lattice(int index, const Similarity& chain);
    bool add_shape(int index, const Similarity& chain);
    bool add_half_plane(int index, const Similarity& chain);
    bool add_offset(int index, const Similarity& chain);
    bool add_traced(int index, const Similarity& chain);
    bool add(int index, const Similarity& chain, const std::vector<OwnedPiece>& pieces, double error = 0);

    const Field& field_;
    Box2 bounds_;
    std::map<int, TracedBoundary> traced_;
};

int child_of(const Field& field, const Op& op, int i) { return at(field.links, op.first_link + i); }

/// What stands in every cell: the child of the op that unites it with its neighbours.
int child_in_cells(const Field& field, const Op& lattice) {
    return child_of(field, at(field.ops, child_of(field, lattice, 0)), 0);
}

bool LeafCollector::add(int index, const Similarity& chain, const std::vector<OwnedPiece>& pieces, double error) {
    if (pieces.empty()) return false;
    LeafImage leaf{index, chain, {}, {}};
    leaf.error = error;
    for (const OwnedPiece& piece : pieces) {
        leaf.outline.push_back(transformed(chain, piece.piece));
        leaf.origins.push_back(piece.origin);
        leaf.bounds = leaf.bounds.merged(bounds_of(leaf.outline.back()));
    }
    leaves.push_back(std::move(leaf));
    return true;
}

bool LeafCollector::add_offset(int index, const Similarity& chain) {
    const Op& op = at(field_.ops, index);
    const FoundBoundary below = boundary_below(field_, at(field_.links, op.first_link));
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
    const Op& op = at(field_.ops, index);
    sdf::Outline local;
    op.kernels->outline(field_.params.data() + op.params, local);
    const Similarity field_from_local = op.local_from_field.inverse();
    std::vector<OwnedPiece> pieces;
    for (const Piece& piece : local) pieces.push_back({transformed(field_from_local, piece), index});
    return pieces.empty() ? add_traced(index, chain) : add(index, chain, pieces);
}

/// A metre of its line to either side of the point nearest to the origin: cut_at_horizon() makes it long.
bool LeafCollector::add_half_plane(int index, const Similarity& chain) {
    const Similarity field_from_local = chain * at(field_.ops, index).local_from_field.inverse();
    const Vec2 on_line = field_from_local.offset, along = field_from_local.direction({field_from_local.mirrored ? 1 : -1, 0});
    const Vec2 nearest = on_line - dot(on_line, along) * along;
    LeafImage leaf{index, chain, {Piece::segment(nearest - along, nearest + along)}, Box2::everything()};
    leaf.endless = true;
    leaves.push_back(std::move(leaf));
    return true;
}

bool LeafCollector::collect_lattice(int index, const Similarity& chain) {
    if (!bounds_.is_finite()) return false;
    const Op& op = at(field_.ops, index);
    const int child = child_in_cells(field_, op);
    const Similarity field_from_local = op.local_from_field.inverse();
    const auto offsets = op.kernels->lattice(field_.params.data() + op.params)
                             .offsets_meeting((chain * field_from_local).inverse() * bounds_,
                                              op.local_from_field * at(field_.ops, child).bounds);
    if (!offsets) return false;
    lattice_copies.push_back(static_cast<int>(offsets->size()));
    for (const Vec2& offset : *offsets) {
        const Vec2 in_field = field_from_local.scale * field_from_local.direction(offset);
        if (!collect(child, chain * Similarity::translation(in_field))) return false;
    }
    return true;
}

bool LeafCollector::collect(int index, const Similarity& chain) {
    const Op& op = at(field_.ops, index);
    if (op.kernels->lattice) return collect_lattice(index, chain);
    if (is_found_outline(op)) return collect(at(field_.links, op.first_link), chain);
    if (!is_boolean(*op.kernels, field_.params.data() + op.params))
        return op.kernels->form == Form::modify ? add_offset(index, chain) : add_traced(index, chain);
    if (op.kernels->form == Form::shape) return op.kernels->endless ? add_half_plane(index, chain) : add_shape(index, chain);
    const int appearances = op.kernels->form == Form::images ? op.image_count : 1;
    for (int image = 0; image < appearances; ++image)
        for (int i = 0; i < op.child_count; ++i) {
            const int child = at(field_.links, op.first_link + i);
            const bool in_place = op.kernels->form != Form::images;
            const Similarity here =
                in_place ? chain : chain * at(field_.images, op.first_image + image);
            if (!collect(child, here)) return false;
        }
    return true;
}

/// Does a piece begin wherever one ends, and end wherever one begins? A boundary with a gap would let balls in: worse than none.
bool is_closed(const std::vector<OwnedPiece>& pieces, double tolerance) {
    const auto by_x = [](const Vec2& p, const Vec2& q) { return p.x() < q.x(); };
    std::vector<Vec2> starts, ends;
    for (const OwnedPiece& owned : pieces) {
        if (owned.piece.is_full_circle()) continue;
        starts.push_back(owned.piece.a);
        ends.push_back(owned.piece.b);
    }
    std::sort(starts.begin(), starts.end(), by_x);
    std::sort(ends.begin(), ends.end(), by_x);
    const auto all_meet = [&](const std::vector<Vec2>& some, const std::vector<Vec2>& others) {
        return std::all_of(some.begin(), some.end(), [&](const Vec2& p) {
            const auto first = std::lower_bound(others.begin(), others.end(), Vec2(p.x() - tolerance, 0), by_x);
            const auto last = std::upper_bound(first, others.end(), Vec2(p.x() + tolerance, 0), by_x);
            return std::any_of(first, last, [&](const Vec2& q) { return std::fabs(p.y() - q.y()) <= tolerance; });
        });
    };
    return all_meet(starts, ends) && all_meet(ends, starts);
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
    LeafCollector collector(field, at(field.ops, root).bounds);
    if (!collector.collect(root, Similarity{})) return {};
    const double horizon = cut_at_horizon(collector.leaves);
    return {std::move(collector.leaves), std::move(collector.lattice_copies), horizon};
}

Membership::Membership(const Field& field, int root, const std::vector<int>& lattice_copies) : field_(field) {
    std::size_t next_lattice = 0;
    append(root, lattice_copies, next_lattice);
}

void Membership::append(int index, const std::vector<int>& lattice_copies, std::size_t& next_lattice) {
    const Op& op = at(field_.ops, index);
    const double* params = field_.params.data() + op.params;
    const auto unite = [&](int child, int copies) {
        for (int i = 0; i < copies; ++i) append(child, lattice_copies, next_lattice);
        steps_.push_back({Step::unite, copies});
    };
    if (op.kernels->lattice) return unite(child_in_cells(field_, op), lattice_copies[next_lattice++]);
    if (is_found_outline(op)) return append(child_of(field_, op, 0), lattice_copies, next_lattice);
    if (op.kernels->form == Form::shape || !is_boolean(*op.kernels, params)) return steps_.push_back({Step::leaf});
    if (op.kernels->form == Form::images) return unite(child_of(field_, op, 0), op.image_count);
    for (int i = 0; i < op.child_count; ++i) append(child_of(field_, op, i), lattice_copies, next_lattice);
    if (op.kernels->form == Form::fold) steps_.push_back({Step::fold, op.child_count, op.kernels, params});
    else if (op.kernels->affine(params).sign < 0) steps_.push_back({Step::negate});
}

bool Membership::solid(const std::vector<char>& in_leaf) const {
    std::vector<double> values;
    values.reserve(in_leaf.size());
    std::size_t next_leaf = 0;
    for (const Step& step : steps_) {
        if (step.what == Step::leaf) {
            values.push_back(in_leaf[next_leaf++] ? -1.0 : 1.0);
            continue;
        }
        if (step.what == Step::negate) {
            values.back() = -values.back();
            continue;
        }
        const std::size_t first = values.size() - static_cast<std::size_t>(step.count);
        double value = step.count > 0 ? values[first] : 1;
        for (std::size_t i = first + 1; i < values.size(); ++i)
            value = step.what == Step::unite ? std::min(value, values[i]) : step.kernels->combine(step.params, value, values[i]);
        values.resize(first);
        values.push_back(value);
    }
    return values.back() < 0;
}

FoundBoundary boundary_below(const Field& field, int root) {
    if (at(field.ops, root).bounds.is_empty()) return {{}, 0, infinity, true};
    const FoundLeaves found = leaf_images(field, root);
    if (found.leaves.empty()) {
        TracedBoundary traced = traced_boundary(field, root);
        return {std::move(traced.pieces), traced.error, infinity, traced.nothing};
    }
    double error = 0;
    for (const LeafImage& leaf : found.leaves) error = std::max(error, leaf.error);
    // What has an end has it within the reach of what is not endless.
    const bool ends = at(field.ops, root).bounds.is_finite();
    std::vector<OwnedPiece> pieces = boundary_of(field, root, found);
    if (error > 0 && !is_closed(pieces, 100 * error)) return {};
    // Without a boundary all of the plane is as it is far from everything.
    const bool nothing = pieces.empty() && ends && error == 0;
    return {std::move(pieces), error, ends ? infinity : found.horizon, nothing};
}

bool lower(Field& field, int index) {
    Solid& solid = at(field.solids, index);
    solid.first_piece = static_cast<int>(field.pieces.size());
    const FoundBoundary boundary = boundary_below(field, solid.root);
    if (boundary.nothing) return false;
    if (boundary.pieces.empty()) return true;  // nothing, or everything: only the tree can tell which
    const Exactness& formula = at(field.ops, solid.root).exactness;
    if (boundary.horizon < infinity && formula.outside == Side::exact && formula.inside == Side::exact) return true;  // it knows no horizon
    for (const OwnedPiece& piece : boundary.pieces)
        field.pieces.push_back({piece.piece, index, piece.origin, solid.layers});
    solid.piece_count = static_cast<int>(boundary.pieces.size());
    solid.lowered = true;
    solid.fit_error = boundary.error;
    solid.horizon = boundary.horizon;
    return true;
}

}  // namespace pinfield

#include "engine/program/lower.h"

#include "engine/program/arrangement.h"
#include "engine/program/field.h"
#include "engine/program/offset.h"
#include "engine/program/piece_distance.h"

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
        case Form::shape: return kernels.outline != nullptr;
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

bool add_offset(const Field& field, int index, const Similarity& chain, std::vector<LeafImage>& out) {
    const Op& op = field.ops[static_cast<std::size_t>(index)];
    const int child = field.links[static_cast<std::size_t>(op.first_link)];
    LeafImage leaf{index, chain, {}, {}};
    for (const OwnedPiece& piece : offset_boundary(field, index, boundary_below(field, child))) {
        leaf.outline.push_back(moved(chain, piece.piece));
        leaf.origins.push_back(piece.origin);
        leaf.bounds = leaf.bounds.merged(bounds_of(leaf.outline.back()));
    }
    if (leaf.outline.empty()) return false;
    out.push_back(std::move(leaf));
    return true;
}

bool add_leaf(const Field& field, int index, const Similarity& chain, std::vector<LeafImage>& out) {
    const Op& op = field.ops[static_cast<std::size_t>(index)];
    sdf::Outline local;
    op.kernels->outline(field.params.data() + op.params, local);
    if (local.empty()) return false;
    LeafImage leaf{index, chain, {}, {}};
    const Similarity field_from_local = chain * op.local_from_field.inverse();
    for (const Piece& piece : local) {
        leaf.outline.push_back(moved(field_from_local, piece));
        leaf.bounds = leaf.bounds.merged(bounds_of(leaf.outline.back()));
    }
    out.push_back(std::move(leaf));
    return true;
}

bool collect(const Field& field, int index, const Similarity& chain, std::vector<LeafImage>& out) {
    const Op& op = field.ops[static_cast<std::size_t>(index)];
    if (is_boundary(op)) return collect(field, field.links[static_cast<std::size_t>(op.first_link)], chain, out);
    if (op.kernels->form == Form::modify && !is_boolean(*op.kernels, field.params.data() + op.params)) return add_offset(field, index, chain, out);
    if (!is_boolean(*op.kernels, field.params.data() + op.params)) return false;
    if (op.kernels->form == Form::shape) return add_leaf(field, index, chain, out);
    const int appearances = op.kernels->form == Form::images ? op.image_count : 1;
    for (int image = 0; image < appearances; ++image)
        for (int i = 0; i < op.child_count; ++i) {
            const int child = field.links[static_cast<std::size_t>(op.first_link + i)];
            const bool in_place = op.kernels->form != Form::images;
            const Similarity here =
                in_place ? chain : chain * field.images[static_cast<std::size_t>(op.first_image + image)];
            if (!collect(field, child, here, out)) return false;
        }
    return true;
}

/// Walks the tree as collect() does; a field of -1 stands for inside and 1 for outside.
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
        case Form::warp: break;  // never lowered
    }
    return 1;
}

}  // namespace

std::vector<LeafImage> leaf_images(const Field& field, int root) {
    std::vector<LeafImage> out;
    if (!collect(field, root, Similarity{}, out)) out.clear();
    return out;
}

bool is_in_tree(const Field& field, int root, const std::vector<char>& in_leaf) {
    std::size_t next = 0;
    return membership(field, root, in_leaf, next) < 0;
}

std::vector<OwnedPiece> boundary_below(const Field& field, int root) {
    const std::vector<LeafImage> leaves = leaf_images(field, root);
    return leaves.empty() ? std::vector<OwnedPiece>{} : boundary_of(field, root, leaves);
}

void lower(Field& field, int index) {
    Solid& solid = field.solids[static_cast<std::size_t>(index)];
    solid.first_piece = static_cast<int>(field.pieces.size());
    const std::vector<OwnedPiece> boundary = boundary_below(field, solid.root);
    if (boundary.empty()) return;  // nothing, or everything: only the tree can tell which
    for (const OwnedPiece& piece : boundary)
        field.pieces.push_back({piece.piece, index, piece.origin, solid.layers});
    solid.piece_count = static_cast<int>(boundary.size());
    solid.lowered = true;
}

}  // namespace pinfield

// The shapes of a CSG tree as one arrangement of outlines in the plane, and the part of it that bounds the result.
#pragma once
#include <vector>

#include "engine/program/program.h"

namespace pinfield {

/// One appearance of a leaf: images operations show their child several times.
struct LeafImage {
    int leaf = 0;                ///< op: a shape, or an offset of a solid whose boundary was found before
    Similarity field_from_leaf;  ///< isometry: from where the leaf itself stands to where this appearance does
    sdf::Outline outline;        ///< in the field's frame, solid on the left
    Box2 bounds;
    std::vector<int> origins{};  ///< of an offset: the shape that each piece of the outline comes from

    int origin(std::size_t piece) const { return origins.empty() ? leaf : origins[piece]; }
};

/// A piece of the boundary and the shape that it comes from.
struct OwnedPiece {
    sdf::Piece piece;
    int origin = 0;  ///< op
};

/// All appearances below an op, in the order a walk of the tree meets them; empty when the tree holds anything but
/// shapes with outlines under union, intersection, difference, xor, complement, images, and round, inset and onion of such.
std::vector<LeafImage> leaf_images(const Field& field, int root);

/// Is a point in the tree's solid, given for each appearance whether it is in that one?
bool is_in_tree(const Field& field, int root, const std::vector<char>& in_leaf);

/// The boundary of the solid below an op, or nothing where leaf_images() finds nothing, or no boundary is there to be found.
std::vector<OwnedPiece> boundary_below(const Field& field, int root);

/// The boundary of the tree's solid: every outline is cut where others meet it, and those cuts stay that have the solid
/// on one side only, turned so that it is the left one.
std::vector<OwnedPiece> boundary_of(const Field& field, int root, const std::vector<LeafImage>& leaves);

}  // namespace pinfield

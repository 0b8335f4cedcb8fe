// The shapes of a CSG tree as one arrangement of outlines in the plane, and the part of it that bounds the result.
#pragma once
#include <vector>

#include "engine/program/program.h"

namespace pinfield {

/// One appearance of a leaf: images operations show their child several times.
struct LeafImage {
    int leaf = 0;                ///< op
    Similarity field_from_leaf;  ///< isometry: from where the leaf itself stands to where this appearance does
    sdf::Outline outline;        ///< in the field's frame, solid on the left
    Box2 bounds;
};

/// A piece of the boundary and the appearance that it comes from.
struct OwnedPiece {
    sdf::Piece piece;
    int owner = 0;  ///< index into the leaf images
};

/// All appearances below an op, in the order a walk of the tree meets them; empty when the tree holds anything but
/// shapes with outlines under union, intersection, difference, xor, complement and images.
std::vector<LeafImage> leaf_images(const Field& field, int root);

/// Is a point in the tree's solid, given for each appearance whether it is in that one?
bool is_in_tree(const Field& field, int root, const std::vector<char>& in_leaf);

/// The boundary of the tree's solid: every outline is cut where others meet it, and those cuts stay that have the solid
/// on one side only, turned so that it is the left one.
std::vector<OwnedPiece> boundary_of(const Field& field, int root, const std::vector<LeafImage>& leaves);

}  // namespace pinfield

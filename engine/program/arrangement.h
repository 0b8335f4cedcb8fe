// The shapes of a CSG tree as one arrangement of outlines in the plane, and the part of it that bounds the result.
#pragma once
#include <vector>

#include "engine/program/program.h"

namespace pinfield {

/// One appearance of a leaf: images operations show their child several times.
struct LeafImage {
    int leaf = 0;                ///< op: a shape; an offset of a solid whose boundary was found before; or what was traced
    Similarity field_from_leaf;  ///< isometry: from where the leaf itself stands to where this appearance does
    sdf::Outline outline;        ///< in the field's frame, solid on the left
    Box2 bounds;
    std::vector<int> origins{};  ///< of all but a shape: the shape that each piece of the outline comes from
    bool endless = false;        ///< a half plane: the outline is as much of its line as lies before the horizon
    double error = 0;            ///< metres that the outline strays at most from the leaf's own zero line: > 0 where it was traced

    int origin(std::size_t piece) const { return origins.empty() ? leaf : origins[piece]; }
};

/// A piece of the boundary and the shape that it comes from.
struct OwnedPiece {
    sdf::Piece piece;
    int origin = 0;  ///< op
};

/// Half planes are cut off there, in reaches of what else there is: far enough not to matter on a table, near enough for the corners to
/// keep their digits.
inline constexpr double horizon_reaches = 100;

struct FoundLeaves {
    std::vector<LeafImage> leaves;
    std::vector<int> lattice_copies;  ///< how many copies of its child each lattice counts, in the same order
    double horizon = infinity;  ///< metres from the origin, within which half planes' lines are whole
};
/// All appearances below an op, in the order a walk of the tree meets them: shapes with outlines, half planes, and round, inset and onion
/// of such, under union, intersection, difference, xor, complement, images, and lattices within finite bounds; whatever else is there is
/// traced as a whole. Empty when some of that cannot be.
FoundLeaves leaf_images(const Field& field, int root);

/// Is a point in the tree's solid, given for each appearance whether it is in that one? The tree is walked once, as leaf_images() does, for
/// any number of questions; the field must stay as it is.
class Membership {
public:
    Membership(const Field& field, int root, const std::vector<int>& lattice_copies);
    bool solid(const std::vector<char>& in_leaf) const;

private:
    /// What is done with the values before: -1 inside, 1 outside.
    struct Step {
        enum What : unsigned char { leaf, negate, unite, fold } what = leaf;
        int count = 0;  ///< of values that are united or folded
        const sdf::Kernels* kernels = nullptr;
        const double* params = nullptr;
    };
    void append(int op, const std::vector<int>& lattice_copies, std::size_t& next_lattice);

    const Field& field_;
    std::vector<Step> steps_;
};

struct FoundBoundary {
    std::vector<OwnedPiece> pieces;
    double error = 0;           ///< metres that its pieces stray at most from the leaves' zero lines: > 0 where some were traced
    double horizon = infinity;  ///< metres from the origin within which all of it is there
    bool nothing = false;       ///< there is none, and no solid: what is cut from itself, or common to what is apart
};
/// The boundary of the solid below an op; no pieces where none is there to be found.
FoundBoundary boundary_below(const Field& field, int root);

/// The boundary of the tree's solid: every outline is cut where others meet it, and those cuts stay that have the solid
/// on one side only, turned so that it is the left one.
std::vector<OwnedPiece> boundary_of(const Field& field, int root, const FoundLeaves& found);

}  // namespace pinfield

// What a picture asks of a Field's solids: the formula where it is the distance, else how far away the boundary is, of which a tile needs
// few pieces.
#pragma once
#include <vector>

#include "engine/core/at.h"
#include "engine/program/program.h"

namespace pinfield {

/// A packed outline, as outline_distance.h reads it; empty: the formula is enough.
using OutlineBlock = std::vector<double>;

class DrawnSolids {
public:
    /// For points of this window only: an endless solid's boundary is whole up to its horizon.
    DrawnSolids(const Field& field, const Box2& window);

    bool by_boundary(int solid) const { return !at(outlines_, solid).empty(); }
    /// All of it, or empty.
    const OutlineBlock& outline(int solid) const { return at(outlines_, solid); }
    double lipschitz(int solid) const;
    /// Is the distance outside at least that to the solid's box?
    bool exceeds_box(int solid) const;
    double value(int solid, const Vec2& p) const;

private:
    const Field& field_;
    std::vector<OutlineBlock> outlines_;
};

/// The pieces that may be nearest to some point within `reach` of `centre`.
void keep_near(const OutlineBlock& outline, const Vec2& centre, double reach, OutlineBlock& out);

}  // namespace pinfield

#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// A solid given by its boundary of lines and arcs alone: what compiling puts below an offset, so that it is one of the true distance
/// where the solid is a CSG tree, whose own field is only a bound. Its block is nothing but the packed outline; nobody writes it in a
/// table.
template <class Real>
struct Boundary {
    static constexpr int most_pieces = 0;  // its block is packed by who makes it

    void outline(Outline&) const {}

    static constexpr auto describe() { return shape<Boundary>({.key = "boundary", .doc = "The boundary of a CSG tree."}, fields()); }
};

}  // namespace pinfield::sdf

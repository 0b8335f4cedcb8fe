#pragma once
#include "engine/reflect/describe.h"
#include "engine/sdf/outline_path.h"

namespace pinfield::sdf {

/// A solid given by an outline of lines and arcs alone: what compiling puts below an offset once it has found the boundary of what is there,
/// so that the offset is one of the true distance where the tree's own field is only a bound. Its block is nothing but the packed outline;
/// nobody writes it in a table.
template <class Real>
struct FoundOutline {
    static constexpr int most_pieces = 0;  // its block is packed by who makes it

    void outline(Outline&) const {}

    static constexpr auto describe() {
        return shape<FoundOutline>({.key = "found_outline", .doc = "The outline that was found of a tree of shapes."}, fields());
    }
};

}  // namespace pinfield::sdf

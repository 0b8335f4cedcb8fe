// The boundary of a solid that is known by its formula alone, as lines and arcs: its zero line, traced and fitted.
#pragma once
#include <vector>

#include "engine/program/arrangement.h"

namespace pinfield {

/// How far a traced boundary strays at most from the zero line it was fitted to, in sizes of what was traced (the longer side of its box).
inline constexpr double trace_tolerance = 1e-7;

struct TracedBoundary {
    std::vector<OwnedPiece> pieces;
    double error = 0;  ///< metres that they stray at most from the zero line
    bool nothing = false;  ///< there are none, as there is no solid
};
/// The boundary of the solid below an op, in the field's frame, each piece with the shape whose surface it is. Nothing where there is none,
/// where it has no end or is far larger than any table, where it cannot be fitted, and where too much of it may hide something too small to
/// be seen. What is at least 1/8000 of its size thick is not missed, of the solid and of what is around it.
TracedBoundary traced_boundary(const Field& field, int op);

}  // namespace pinfield

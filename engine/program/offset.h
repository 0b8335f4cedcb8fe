// The boundary of a solid grown, shrunk or made a shell: round, inset and onion as lines and arcs again.
#pragma once
#include <vector>

#include "engine/program/arrangement.h"

namespace pinfield {

/// Does an offset look only at sides on which its child's distance is the true one? True of what is no offset.
bool offset_is_exact(const Exactness& child, const sdf::Affine& affine);

/// The boundary of what an offset op makes of the solid with this boundary. Where its child's field is no exact distance on the side
/// that the offset looks at, the result means nothing. Empty when nothing is left.
std::vector<OwnedPiece> offset_boundary(const Field& field, int offset_op, const std::vector<OwnedPiece>& boundary);

}  // namespace pinfield

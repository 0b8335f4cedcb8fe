#include "engine/program/arrangement.h"
namespace pinfield {
namespace {
sdf::Piece reversed(const sdf::Piece& piece) {
    sdf::Piece out = piece;
    std::swap(out.a, out.b);
    out.turn = -piece.turn;
    return out;
}
}  // namespace
std::vector<OwnedPiece> boundary_of(const Field& field, int root, const std::vector<LeafImage>& leaves) {
    std::vector<OwnedPiece> out;
    if (leaves.size() > 1) return out;
    const bool as_is = is_in_tree(field, root, {1});
    for (const sdf::Piece& piece : leaves[0].outline) out.push_back({as_is ? piece : reversed(piece), 0});
    return out;
}
}  // namespace pinfield

#include "engine/program/cutting.h"

#include <algorithm>

#include "engine/core/at.h"
#include "engine/program/bvh.h"
#include "engine/sdf/meet.h"
#include "engine/sdf/piece.h"

namespace pinfield {
namespace {

using sdf::Piece;

void cut_pair(CutPiece& a, CutPiece& b, double tolerance) {
    if (a.owner != b.owner && a.box.grown(tolerance).overlaps(b.box)) meet(a.piece, b.piece, tolerance, a.cuts, b.cuts);
}

}  // namespace

CutPiece cut_piece_of(const Piece& piece, int owner, int origin) { return {piece, owner, origin, bounds_of(piece)}; }

void cut_all(std::vector<CutPiece>& edges, double tolerance) {
    std::vector<Box2> boxes;
    for (const CutPiece& edge : edges) boxes.push_back(edge.box);
    const Bvh bvh(boxes);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        std::vector<int> partners;
        bvh.overlapping(edges[i].box.grown(tolerance), [&](int j) { partners.push_back(j); });
        std::sort(partners.begin(), partners.end());
        for (const int j : partners)
            if (static_cast<std::size_t>(j) > i) cut_pair(edges[i], at(edges, j), tolerance);
    }
}

std::vector<Piece> parts_of(const CutPiece& edge) {
    std::vector<Vec2> cuts = edge.cuts;
    std::sort(cuts.begin(), cuts.end(), [&](const Vec2& p, const Vec2& q) {
        return position_along(edge.piece, p) < position_along(edge.piece, q);
    });
    std::vector<Piece> parts;
    if (edge.piece.is_full_circle()) {
        if (cuts.size() < 2) return {edge.piece};
        for (std::size_t i = 0; i < cuts.size(); ++i)
            parts.push_back(part_of(edge.piece, cuts[i], cuts[(i + 1) % cuts.size()]));
        return parts;
    }
    if (cuts.empty()) return {edge.piece};
    cuts.push_back(edge.piece.b);
    Vec2 from = edge.piece.a;
    for (const Vec2& to : cuts) {
        parts.push_back(part_of(edge.piece, from, to));
        from = to;
    }
    return parts;
}

Probe probe_of(const Piece& piece, const std::vector<Vec2>& touched) {
    if (piece.is_full_circle()) {
        const Vec2 away = touched.empty() ? Vec2(-1, 0) : Vec2((piece.centre - touched[0]) / length(piece.centre - touched[0]));
        return {piece.centre + piece.radius * away, piece.turn * away};
    }
    const Vec2 middle = middle_of(piece);
    return {middle, -perpendicular(direction_at(piece, middle))};
}

}  // namespace pinfield

#include "engine/program/drawn_solids.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/core/at.h"
#include "engine/program/tree.h"
#include "engine/sdf/outline_distance.h"
#include "engine/sdf/outline_path.h"
#include "engine/sdf/register.h"

namespace pinfield {
namespace {

const Op& root_of(const Field& field, int solid) {
    return at(field.ops, at(field.solids, solid).root);
}

bool is_exact(const Exactness& e) { return e.outside == Side::exact && e.inside == Side::exact; }

OutlineBlock found_outline_block(const Field& field, const Solid& solid) {
    sdf::Outline outline;
    for (int i = 0; i < solid.piece_count; ++i) outline.push_back(at(field.pieces, solid.first_piece + i).piece);
    return sdf::found_outline_block(outline);
}

/// To a packed piece, both its ends included: unlike outline_distance.h, which leaves an end to the piece that starts there.
double distance_to(const double* packed, const Vec2& at) {
    sdf::PackedPiece c;
    static_assert(sizeof(c) == sdf::packed_piece_size * sizeof(double));
    std::memcpy(&c, packed, sizeof(c));
    const Point<double> p{at.x(), at.y()};
    const double past_start = (p.x - c.ax) * c.start_x + (p.y - c.ay) * c.start_y,
                 past_end = (p.x - c.bx) * c.end_x + (p.y - c.by) * c.end_y;
    if (past_start >= 0 && past_end <= 0) return std::fabs(sdf::distance_to_curve(p, c).distance);
    return std::min(length(at - Vec2(c.ax, c.ay)), length(at - Vec2(c.bx, c.by)));
}

}  // namespace

DrawnSolids::DrawnSolids(const Field& field, const Box2& window) : field_(field), outlines_(field.solids.size()) {
    const double farthest = std::max(length(window.lo), length(window.hi)) + length(window.size());
    for (std::size_t i = 0; i < field.solids.size(); ++i) {
        const Solid& solid = field.solids[i];
        if (!solid.visible || !solid.lowered || is_exact(at(field.ops, solid.root).exactness)) continue;
        OutlineBlock outline = found_outline_block(field, solid);
        if (solid.horizon < infinity &&
            farthest + std::fabs(sdf::found_outline_kernels().distance(outline.data(), window.centre().x(), window.centre().y())) >
                solid.horizon)
            continue;
        outlines_[i] = std::move(outline);
    }
}

double DrawnSolids::lipschitz(int solid) const { return by_boundary(solid) ? 1 : root_of(field_, solid).exactness.lipschitz; }

bool DrawnSolids::exceeds_box(int solid) const { return by_boundary(solid) || root_of(field_, solid).exactness.outside == Side::exact; }

double DrawnSolids::value(int solid, const Vec2& p) const {
    const double formula = tree_value(field_, at(field_.solids, solid).root, p);
    if (!by_boundary(solid)) return formula;
    return std::copysign(sdf::found_outline_kernels().distance(outline(solid).data(), p.x(), p.y()), formula);
}

void keep_near(const OutlineBlock& outline, const Vec2& centre, double reach, OutlineBlock& out) {
    using sdf::packed_head_size, sdf::packed_piece_size;
    const auto count = static_cast<std::size_t>(outline[0]);
    const auto piece = [&](std::size_t i) { return outline.data() + packed_head_size + i * packed_piece_size; };
    std::vector<double> away(count);
    for (std::size_t i = 0; i < count; ++i) away[i] = distance_to(piece(i), centre);
    const double enough = *std::min_element(away.begin(), away.end()) + 2 * reach;
    out.assign(outline.begin(), outline.begin() + packed_head_size);
    out[0] = out[2] = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (away[i] > enough) continue;
        out.insert(out.end(), piece(i), piece(i) + packed_piece_size);
        ++out[0];
    }
}

}  // namespace pinfield

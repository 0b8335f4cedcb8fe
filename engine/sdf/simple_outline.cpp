#include "engine/sdf/simple_outline.h"

#include <algorithm>
#include <vector>

#include "engine/sdf/meet.h"
#include "engine/sdf/piece.h"

namespace pinfield::sdf {
namespace {

struct Boxed {
    const Piece* piece;
    Box2 box;
};

}  // namespace

bool is_simple_outline(const Outline& outline) {
    std::vector<Boxed> pieces;
    Box2 all;
    for (const Piece& piece : outline) {
        pieces.push_back({&piece, bounds_of(piece)});
        all = all.merged(pieces.back().box);
    }
    if (pieces.empty()) return true;
    const double tolerance = 1e-10 * all.size().maxCoeff();
    std::sort(pieces.begin(), pieces.end(), [](const Boxed& a, const Boxed& b) { return a.box.lo.x() < b.box.lo.x(); });
    std::vector<Vec2> cuts;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t j = i + 1; j < pieces.size() && pieces[j].box.lo.x() <= pieces[i].box.hi.x() + tolerance; ++j) {
            if (!pieces[i].box.grown(tolerance).overlaps(pieces[j].box)) continue;
            const Piece &a = *pieces[i].piece, &b = *pieces[j].piece;
            meet(a, b, tolerance, cuts, cuts);
            if (!cuts.empty() || length(a.a - b.a) <= tolerance) return false;
        }
    return true;
}

double signed_area(const Outline& outline) {
    double area = 0;
    if (outline.empty()) return 0;
    const Vec2 origin = outline.front().a;
    for (const Piece& piece : outline) {
        area += 0.5 * cross(Vec2(piece.a - origin), Vec2(piece.b - origin));
        if (piece.is_arc()) area += area_beside_chord(piece);
    }
    return area;
}

Outline reversed(const Outline& outline) {
    Outline out(outline.rbegin(), outline.rend());
    for (Piece& piece : out) piece = reversed(piece);
    return out;
}

}  // namespace pinfield::sdf

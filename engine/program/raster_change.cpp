#include "engine/program/raster_change.h"

#include <algorithm>

#include "engine/core/at.h"

namespace pinfield {
namespace {

bool same(const Box2& a, const Box2& b) { return a.lo == b.lo && a.hi == b.hi; }

bool same(const Similarity& a, const Similarity& b) {
    return a.cosine == b.cosine && a.sine == b.sine && a.scale == b.scale && a.mirrored == b.mirrored && a.offset == b.offset;
}

/// Its place in the lists that a Field has, and what it is; not where it is or how large.
bool same_structure(const Op& a, const Op& b) {
    return a.kernels == b.kernels && a.params == b.params && a.param_count == b.param_count && a.first_link == b.first_link &&
           a.child_count == b.child_count && a.first_image == b.first_image && a.image_count == b.image_count;
}

bool same_structure(const Field& a, const Field& b) {
    const auto solids = [](const Solid& s, const Solid& t) { return s.root == t.root; };
    const auto ops = [](const Op& s, const Op& t) { return same_structure(s, t); };
    return a.links == b.links && a.images.size() == b.images.size() && a.params.size() == b.params.size() &&
           std::equal(a.ops.begin(), a.ops.end(), b.ops.begin(), b.ops.end(), ops) &&
           std::equal(a.solids.begin(), a.solids.end(), b.solids.begin(), b.solids.end(), solids);
}

bool same_values(const Field& a, const Field& b, const Op& s, const Op& t) {
    if (!same(s.local_from_field, t.local_from_field) || s.scale != t.scale || !same(s.bounds, t.bounds) || s.material != t.material)
        return false;
    if (s.exactness.outside != t.exactness.outside || s.exactness.inside != t.exactness.inside ||
        s.exactness.lipschitz != t.exactness.lipschitz)
        return false;
    for (int i = s.params; i < s.params + s.param_count; ++i)
        if (!(at(a.params, i) == at(b.params, i))) return false;
    for (int i = s.first_image; i < s.first_image + s.image_count; ++i)
        if (!same(at(a.images, i), at(b.images, i))) return false;
    return true;
}

bool same_piece(const BoundaryPiece& a, const BoundaryPiece& b) {
    return a.piece.a == b.piece.a && a.piece.b == b.piece.b && a.piece.centre == b.piece.centre && a.piece.radius == b.piece.radius &&
           a.piece.turn == b.piece.turn && a.piece.reflex == b.piece.reflex;
}

bool same_solid(const Field& a, const Field& b, int first_op, int solid) {
    const Solid& s = at(a.solids, solid);
    const Solid& t = at(b.solids, solid);
    if (!same(s.bounds, t.bounds) || s.layers != t.layers || s.visible != t.visible || s.lowered != t.lowered || s.horizon != t.horizon ||
        s.piece_count != t.piece_count)
        return false;
    for (int op = first_op; op <= s.root; ++op)
        if (!same_values(a, b, at(a.ops, op), at(b.ops, op))) return false;
    for (int i = 0; i < s.piece_count; ++i)
        if (!same_piece(at(a.pieces, s.first_piece + i), at(b.pieces, t.first_piece + i))) return false;
    return true;
}

/// Is it nowhere nearer than its box?
bool keeps_to_box(const Field& field, const Solid& solid) {
    return (solid.lowered && solid.horizon == infinity) || at(field.ops, solid.root).exactness.outside == Side::exact;
}

}  // namespace

std::optional<std::vector<Box2>> changed_boxes(const Field& before, const Field& after) {
    if (!same_structure(before, after)) return {};
    std::vector<Box2> boxes;
    int first_op = 0;
    for (int i = 0; i < static_cast<int>(before.solids.size()); ++i) {
        const Solid& s = at(before.solids, i);
        const Solid& t = at(after.solids, i);
        if (!same_solid(before, after, first_op, i)) {
            if (!keeps_to_box(before, s) || !keeps_to_box(after, t)) return {};
            boxes.insert(boxes.end(), {s.bounds, t.bounds});
        }
        first_op = s.root + 1;
    }
    return boxes;
}

bool is_out_of_reach(const Raster& raster, const PixelBox& pixels, const std::vector<Box2>& boxes) {
    const Vec2 pixel = raster.window.size().cwiseQuotient(Vec2(raster.width, raster.height));
    const Vec2 corner(raster.window.lo.x(), raster.window.hi.y());
    const Vec2 a = corner + Vec2(pixels.left * pixel.x(), -pixels.top * pixel.y());
    const Vec2 b = corner + Vec2(pixels.right * pixel.x(), -pixels.bottom * pixel.y());
    const Box2 here = Box2::of(a, b);
    double nearest = infinity;
    for (const Box2& box : boxes) {
        const Vec2 gap = (box.lo - here.hi).cwiseMax(here.lo - box.hi).cwiseMax(0.0);
        nearest = std::min(nearest, length(gap));
    }
    if (nearest == 0) return false;  // in its box a solid may be deeper than anything
    // What a packet computes, a float, may err by some roundings of the coordinates.
    const double margin = 2 * length(pixel) + 1e-5 * std::max(length(raster.window.lo), length(raster.window.hi));
    for (int y = pixels.top; y < std::min(pixels.bottom, raster.height); ++y)
        for (int x = pixels.left; x < std::min(pixels.right, raster.width); ++x)
            if (!(static_cast<double>(at(raster.distance, y * raster.width + x)) + margin < nearest)) return false;
    return true;
}

}  // namespace pinfield

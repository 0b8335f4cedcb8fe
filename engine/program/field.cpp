#include "engine/program/field.h"

#include <span>

#include "engine/core/at.h"
#include "engine/sdf/piece.h"
#include "engine/sdf/register.h"

namespace pinfield {
namespace {

/// A place in each of a Field's lists. The shares of the solids follow each other without gaps, in the order of the
/// solids.
struct Place {
    int op = 0, link = 0, image = 0, param = 0, solid = 0, piece = 0;
};

template <class T>
int count(const std::vector<T>& list) {
    return static_cast<int>(list.size());
}

Place end_of(const Field& f) {
    return {count(f.ops), count(f.links), count(f.images), count(f.params), count(f.solids), count(f.pieces)};
}

/// Where the share of solid `index` begins: where its first op, a leaf that was emitted before all else, says.
Place begin_of(const Field& field, int index) {
    if (index == count(field.solids)) return end_of(field);
    const int first_op = index == 0 ? 0 : field.solids[static_cast<std::size_t>(index) - 1].root + 1;
    const Op& op = at(field.ops, first_op);
    return {first_op,  op.first_link, op.first_image,
            op.params, index,         at(field.solids, index).first_piece};
}

Place operator-(const Place& a, const Place& b) {
    return {a.op - b.op, a.link - b.link, a.image - b.image, a.param - b.param, a.solid - b.solid, a.piece - b.piece};
}

/// Corrects the references of all entries from `from` on, when what they refer to moves by `by`.
void shift(Field& field, const Place& from, const Place& by) {
    const auto tail = [](auto& list, int first) { return std::span(list).subspan(static_cast<std::size_t>(first)); };
    for (Op& op : tail(field.ops, from.op)) {
        op.params += by.param;
        op.first_link += by.link;
        op.first_image += by.image;
    }
    for (int& child : tail(field.links, from.link)) child += by.op;
    for (Solid& solid : tail(field.solids, from.solid)) {
        solid.root += by.op;
        solid.first_piece += by.piece;
    }
    for (BoundaryPiece& piece : tail(field.pieces, from.piece)) {
        piece.solid += by.solid;
        piece.leaf += by.op;
    }
}

template <class T>
void replace(std::vector<T>& list, int begin, int end, const std::vector<T>& with) {
    const int shared = std::min(end - begin, count(with));
    std::copy(with.begin(), with.begin() + shared, list.begin() + begin);
    if (shared < end - begin)
        list.erase(list.begin() + begin + shared, list.begin() + end);
    else
        list.insert(list.begin() + end, with.begin() + shared, with.end());
}

}  // namespace

bool is_found_outline(const Op& op) { return op.kernels == &sdf::found_outline_kernels(); }

void append(Field& field, const Field& fragment) {
    const Place at = end_of(field);
    field.ops.insert(field.ops.end(), fragment.ops.begin(), fragment.ops.end());
    field.links.insert(field.links.end(), fragment.links.begin(), fragment.links.end());
    field.images.insert(field.images.end(), fragment.images.begin(), fragment.images.end());
    field.params.insert(field.params.end(), fragment.params.begin(), fragment.params.end());
    field.solids.insert(field.solids.end(), fragment.solids.begin(), fragment.solids.end());
    field.pieces.insert(field.pieces.end(), fragment.pieces.begin(), fragment.pieces.end());
    shift(field, at, at);
}

void replace_solid(Field& field, int solid, const Field& fragment) {
    const Place begin = begin_of(field, solid), end = begin_of(field, solid + 1);
    shift(field, end, end_of(fragment) - (end - begin));
    Field placed = fragment;
    shift(placed, {}, begin);
    replace(field.ops, begin.op, end.op, placed.ops);
    replace(field.links, begin.link, end.link, placed.links);
    replace(field.images, begin.image, end.image, placed.images);
    replace(field.params, begin.param, end.param, placed.params);
    replace(field.solids, begin.solid, end.solid, placed.solids);
    replace(field.pieces, begin.piece, end.piece, placed.pieces);
}

void index(Field& field) {
    field.tree_solids.clear();
    field.horizon = infinity;
    for (const Solid& solid : field.solids) field.horizon = std::min(field.horizon, solid.horizon);
    std::vector<Box2> boxes;
    boxes.reserve(field.pieces.size() + field.solids.size());
    for (const BoundaryPiece& boundary : field.pieces) boxes.push_back(bounds_of(boundary.piece));
    for (std::size_t i = 0; i < field.solids.size(); ++i) {
        if (field.solids[i].lowered) continue;
        field.tree_solids.push_back(static_cast<int>(i));
        boxes.push_back(field.solids[i].bounds);
    }
    field.bvh = Bvh(boxes);
}

}  // namespace pinfield

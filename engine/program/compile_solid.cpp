// A scene node's shape as ops: frames composed, parameters packed, bounds and exactness propagated, boundary lowered.
#include <fmt/format.h>

#include <algorithm>

#include "engine/core/at.h"
#include "engine/core/error_codes.h"
#include "engine/program/arrangement.h"
#include "engine/program/compile_item.h"
#include "engine/program/lower.h"
#include "engine/program/offset.h"
#include "engine/reflect/erase.h"
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/operations/complement.h"
#include "engine/sdf/operations/repeat.h"
#include "engine/sdf/operations/union.h"
#include "engine/sdf/outline_path.h"
#include "engine/sdf/register.h"

namespace pinfield {
namespace {

/// No further away or larger than a length may be, and not smaller by as much: groups multiply their scales.
bool is_computable(const Similarity& s) {
    return std::isfinite(s.cosine) && std::isfinite(s.sine) && s.scale >= 1 / longest_length && s.scale <= longest_length &&
           s.offset.allFinite() && s.offset.cwiseAbs().maxCoeff() <= longest_length;
}

/// Of the type's own fields, without the common ones.
std::vector<Value> own_values(const Node& node) {
    std::vector<Value> out;
    for (int i = 0; i < node.type->own_fields; ++i) out.push_back(at(node.fields, i).value);
    return out;
}

/// For formulas that grow boxes by a length of their own frame.
Box2 scaled(const Box2& box, double factor) { return box.is_empty() ? box : Box2{factor * box.lo, factor * box.hi}; }

/// Grows a Field op by op, children before parents.
class Emitter {
public:
    Emitter(CompileContext& context, Field& field) : context_(context), scene_(context.scene), field_(field) {}

    int emit_node(NodeId id, const Similarity& field_from_node);
    int emit_part_shape(const Node& node, const Similarity& field_from_node);
    /// An op of a built-in operation that the author did not write.
    template <template <class> class N>
    int emit_implied(NodeId origin, const Similarity& field_from_node, const std::vector<int>& children) {
        const NodeType* type = scene_.catalog().find(N<double>::describe().meta.key);
        return emit(*type->kernels, {}, origin, field_from_node, children);
    }
    int emit(const sdf::Kernels& kernels, std::vector<double> block, NodeId origin, const Similarity& field_from_op,
             const std::vector<int>& children);

private:
    int by_its_boundary(int child);
    int with_neighbours(int child, const sdf::Lattice& lattice, NodeId origin, const Similarity& field_from_op);
    void bound(Op& op, const Similarity& field_from_op);
    Box2 box_over(const Op& op, const Similarity& field_from_op, const std::vector<Box2>& children) const;
    Box2 box_to_grow(int index, double reach) const;
    Box2 box_below(int index, double level) const;
    bool is_warped(int index) const;
    int child_of(const Op& op, int i) const { return at(field_.links, op.first_link + i); }
    double reach_of(const Op& op) const;
    int material_of(NodeId id) const;

    CompileContext& context_;
    const Scene& scene_;
    Field& field_;
};

int Emitter::emit_node(NodeId id, const Similarity& field_from_node) {
    const Node& node = *scene_.find(id);
    std::vector<int> children;
    for (const NodeId child : node.children)
        children.push_back(emit_node(child, field_from_node * parent_from_local(*scene_.find(child))));
    const sdf::Kernels& kernels = *node.type->kernels;
    std::vector<double> block = pack(*node.type, own_values(node), kernels.derived_count);
    kernels.derive(block.data());
    // An offset of a bound is the offset of some other figure.
    if (kernels.affine && !children.empty()) {
        const Exactness& below = at(field_.ops, children[0]).exactness;
        if (!offset_is_exact(below, kernels.affine(block.data()))) children[0] = by_its_boundary(children[0]);
    }
    if (kernels.lattice) children[0] = with_neighbours(children[0], kernels.lattice(block.data()), id, field_from_node);
    return emit(kernels, std::move(block), id, field_from_node, children);
}

/// The tree's boundary in its place, if it has one: the true distance instead of a bound.
int Emitter::by_its_boundary(int child) {
    const Op tree = at(field_.ops, child);
    const FoundBoundary found = boundary_below(field_, child);
    if (found.pieces.empty() || found.horizon < infinity) return child;
    sdf::Outline outline;
    for (const OwnedPiece& owned : found.pieces) outline.push_back(owned.piece);
    const int boundary = emit(sdf::found_outline_kernels(), sdf::found_outline_block(outline), tree.origin, Similarity{}, {child});
    at(field_.ops, boundary).bounds = tree.bounds.is_finite() ? sdf::bounds_of(outline) : tree.bounds;
    return boundary;
}

/// The child together with those of its copies that a point of the lattice's middle cell must ask. Which are nearest is known of true
/// distances only: a bound's least value may be that of a copy farther away.
int Emitter::with_neighbours(int child, const sdf::Lattice& lattice, NodeId origin, const Similarity& field_from_op) {
    const Op& below = at(field_.ops, child);
    const Box2 box = field_from_op.inverse() * below.bounds;
    const Place& place = scene_.find(origin)->key;
    if (!box.is_empty() && !box.is_finite()) {
        context_.problems.push_back(diagnose(Code::broken_contract, place, "what has no end cannot be repeated without end"));
        return child;
    }
    const auto [columns, rows] = lattice.neighbours(box);
    if ((2 * columns + 1) * (2 * rows + 1) > sdf::Repeat<double>::most_copies) {
        context_.problems.push_back(
            diagnose(Code::broken_contract, place, "the child reaches over too many cells: more than 1024 of its copies overlap"));
        return child;
    }
    if (below.exactness.outside != Side::exact) child = by_its_boundary(child);
    const sdf::Repeat<double> around{.count = {2.0 * columns + 1, 2.0 * rows + 1}, .step = {lattice.step.x(), lattice.step.y()}};
    const NodeType& type = *scene_.catalog().find(sdf::Repeat<double>::describe().meta.key);
    return emit(*type.kernels, store(around), origin, field_from_op, {child});
}

int Emitter::emit_part_shape(const Node& node, const Similarity& field_from_node) {
    if (node.children.empty()) {
        if (!node.type->part->customary_shape) return -1;
        CustomaryShape shape = node.type->part->customary_shape(pack(*node.type, own_values(node)).data());
        return emit(*shape.kernels, std::move(shape.params), node.id, field_from_node * shape.part_from_shape, {});
    }
    std::vector<int> children;
    for (const NodeId child : node.children)
        children.push_back(emit_node(child, field_from_node * parent_from_local(*scene_.find(child))));
    return children.size() == 1 ? children[0] : emit_implied<sdf::Union>(node.id, field_from_node, children);
}

int Emitter::emit(const sdf::Kernels& kernels, std::vector<double> block, NodeId origin,
                  const Similarity& field_from_op, const std::vector<int>& children) {
    Op op;
    op.kernels = &kernels;
    op.params = static_cast<int>(field_.params.size());
    op.param_count = static_cast<int>(block.size());
    field_.params.insert(field_.params.end(), block.begin(), block.end());
    op.first_link = static_cast<int>(field_.links.size());
    op.child_count = static_cast<int>(children.size());
    field_.links.insert(field_.links.end(), children.begin(), children.end());
    op.first_image = static_cast<int>(field_.images.size());
    op.local_from_field = field_from_op.inverse();
    op.scale = field_from_op.scale;
    op.origin = origin;
    op.material = material_of(origin);
    if (!is_computable(field_from_op))
        context_.problems.push_back(
            diagnose(Code::not_finite, scene_.find(origin)->where, "is placed or scaled beyond what can be computed"));
    if (kernels.images) {
        const Similarity identity;
        for (const Similarity& image : kernels.images(block.data())) {
            const bool stays = image.cosine == 1 && image.sine == 0 && !image.mirrored && image.offset == Vec2(0, 0);
            field_.images.push_back(stays ? identity : field_from_op * image * op.local_from_field);
            field_.images.back().scale = 1;
        }
        op.image_count = static_cast<int>(field_.images.size()) - op.first_image;
    }
    bound(op, field_from_op);
    field_.ops.push_back(op);
    return static_cast<int>(field_.ops.size()) - 1;
}

/// Fills in bounds and exactness from the children's.
void Emitter::bound(Op& op, const Similarity& field_from_op) {
    const double* params = field_.params.data() + op.params;
    std::vector<Box2> boxes;
    std::vector<Exactness> sides;
    for (int i = 0; i < op.child_count; ++i) {
        boxes.push_back(box_to_grow(child_of(op, i), reach_of(op)));
        sides.push_back(at(field_.ops, child_of(op, i)).exactness);
    }
    op.exactness = op.kernels->exactness(params, sides);
    op.bounds = box_over(op, field_from_op, boxes);
}

/// From boxes of its children, all in the Field's frame.
Box2 Emitter::box_over(const Op& op, const Similarity& field_from_op, const std::vector<Box2>& children) const {
    const double* params = field_.params.data() + op.params;
    const bool is_warp = op.kernels->form == sdf::Form::warp;
    if (op.kernels->form == sdf::Form::shape) return field_from_op * op.kernels->bounds(params);
    if (op.kernels->form == sdf::Form::images) {
        Box2 all;
        for (int i = 0; i < op.image_count; ++i) all = all.merged(at(field_.images, op.first_image + i) * children[0]);
        return all;
    }
    std::vector<Box2> local;
    for (const Box2& child : children) local.push_back(is_warp ? op.local_from_field * child : scaled(child, 1 / op.scale));
    const Box2 box = op.kernels->bounds_over(params, local);
    return is_warp ? field_from_op * box : scaled(box, op.scale);
}

/// How far, in metres, an op may be solid over where its children's fields are.
double Emitter::reach_of(const Op& op) const {
    return op.kernels->reach ? op.kernels->reach(field_.params.data() + op.params, op.child_count) * op.scale : 0;
}

/// Is the op's field no distance for the sake of a warp or a formula?
bool Emitter::is_warped(int index) const {
    const Op& op = at(field_.ops, index);
    if (op.exactness.outside == Side::exact) return false;
    if (op.kernels->form == sdf::Form::warp || op.kernels->bounds_below) return true;
    for (int i = 0; i < op.child_count; ++i)
        if (is_warped(child_of(op, i))) return true;
    return false;
}

/// A box that holds where the op's field is below `reach` once it has been grown by that, as its parent's formula will do.
Box2 Emitter::box_to_grow(int index, double reach) const {
    return reach > 0 && is_warped(index) ? box_below(index, reach).grown(-reach) : at(field_.ops, index).bounds;
}

/// Where the op's field is below `level` metres. Of a distance, and of what is folded of distances, that is as far outside of its box; but
/// a warp divides its child's field, by more than one the more it bends, so that its isolines lie farther out: where its child's do.
Box2 Emitter::box_below(int index, double level) const {
    const Op& op = at(field_.ops, index);
    if (!is_warped(index)) return op.bounds.grown(level);
    if (op.kernels->bounds_below)
        return op.local_from_field.inverse() * op.kernels->bounds_below(field_.params.data() + op.params, level / op.scale);
    const double factor = op.kernels->form == sdf::Form::warp ? op.kernels->factor(field_.params.data() + op.params) : 1;
    const double reach = reach_of(op);
    std::vector<Box2> boxes;
    for (int i = 0; i < op.child_count; ++i) boxes.push_back(box_below(child_of(op, i), level / factor + reach).grown(-reach));
    return box_over(op, op.local_from_field.inverse(), boxes);
}

/// Index into Program::materials; the default's when there is no such material.
int Emitter::material_of(NodeId id) const {
    if (id == scene_.table().id) return 0;
    const auto found = context_.materials.find(scene_.material_name(id));
    return found != context_.materials.end() ? found->second : 0;
}

/// The field's only solid, from its last op down; nothing is left of a field that has no inside.
void finish(Field& field, NodeId origin, LayerMask layers, bool visible, bool is_domain) {
    Solid solid;
    solid.is_domain = is_domain;
    solid.root = static_cast<int>(field.ops.size()) - 1;
    solid.bounds = field.ops.back().bounds;
    solid.origin = origin;
    solid.layers = layers;
    solid.visible = visible;
    field.solids.push_back(solid);
    if (!lower(field, 0)) field = {};
}

bool is_visible(const Scene& scene, NodeId id) {
    for (const Node* node = scene.find(id); node; node = node->parent ? scene.find(node->parent) : nullptr)
        if (!node->get<bool>("visible")) return false;
    return true;
}

/// How many shapes there are to see at and below a node; refuses repetitions within repetitions, which multiply, before anything is made
/// of them.
double appearances(const Scene& scene, NodeId id, Diagnostics& problems) {
    constexpr double most = 2048;  // a second's work for the arrangement
    const Node& node = *scene.find(id);
    if (node.children.empty()) return 1;
    double below = 0;
    for (const NodeId child : node.children) below += appearances(scene, child, problems);
    if (!node.type->kernels || !node.type->kernels->images) return below;
    std::vector<double> block = pack(*node.type, own_values(node), node.type->kernels->derived_count);
    node.type->kernels->derive(block.data());
    const double all = below * static_cast<double>(node.type->kernels->images(block.data()).size());
    if (all > most && below > 1) {
        problems.push_back(
            diagnose(Code::too_many_repeats, node.key,
                     fmt::format("{} shows {} shapes, repetitions in it multiplied; {} is the most", node.type->key(), all, most)));
        return 1;
    }
    return all;
}

}  // namespace

Field compile_solid(CompileContext& context, const Item& item, const Similarity& field_from_node) {
    Field field;
    const std::size_t problems_before = context.problems.size();
    appearances(context.scene, item.node, context.problems);
    if (context.problems.size() > problems_before) return field;
    Emitter emitter(context, field);
    const Node& node = *context.scene.find(item.node);
    const int shape =
        item.is_part ? emitter.emit_part_shape(node, field_from_node) : emitter.emit_node(item.node, field_from_node);
    if (shape < 0) return field;
    if (item.role == Role::domain) emitter.emit_implied<sdf::Complement>(item.node, field_from_node, {shape});
    finish(field, item.node, layers_of(context, item.node), is_visible(context.scene, item.node), item.role == Role::domain);
    return field;
}

Field compile_default_domain(CompileContext& context, LayerMask layers) {
    Field field;
    Emitter emitter(context, field);
    const Node& table = context.scene.table();
    std::vector<Value> values;
    for (const FieldSlot& slot : table.fields) values.push_back(slot.value);
    const auto info = load<TableInfo>(pack(*table.type, values).data());
    const sdf::Box<double> box{.size = info.size};
    const NodeType& type = *context.scene.catalog().find(sdf::Box<double>::describe().meta.key);
    const Similarity world_from_box = Similarity::translation(0.5 * Vec2(info.size.x, info.size.y));
    const int shape = emitter.emit(*type.kernels, store(box), table.id, world_from_box, {});
    emitter.emit_implied<sdf::Complement>(table.id, world_from_box, {shape});
    finish(field, table.id, layers, true, true);
    return field;
}

}  // namespace pinfield

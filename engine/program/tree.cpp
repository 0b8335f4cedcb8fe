// The tree back-end of evaluate.h: an op's formula over its children's, value alone or with gradient and winning leaf.
#include "engine/program/tree.h"

#include <cassert>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/program/field.h"
#include "engine/program/trace.h"

namespace pinfield {
namespace {

using sdf::Form;
using sdf::Sample;

const double* params_of(const Field& field, const Op& op) { return field.params.data() + op.params; }
const Op& op_at(const Field& field, int op) { return at(field.ops, op); }
int child_of(const Field& field, const Op& op, int i) {
    return at(field.links, op.first_link + i);
}
const Similarity& image_of(const Field& field, const Op& op, int i) {
    return at(field.images, op.first_image + i);
}

double fold_value(const Field& field, const Op& op, const Vec2& p) {
    const double* params = params_of(field, op);
    double value = tree_value(field, child_of(field, op, 0), p);
    for (int i = 1; i < op.child_count; ++i) {
        const double next = tree_value(field, child_of(field, op, i), p);
        value = op.kernels->combine(params, value / op.scale, next / op.scale) * op.scale;
    }
    return value;
}

/// Can an image be nearer than `best`, in which the child would be seen from `there`? An exact distance outside exceeds that to its box.
bool may_be_nearer(const Op& child, const Vec2& there, double best) {
    return child.exactness.outside != Side::exact || child.bounds.distance(there) <= std::max(best, 0.0);
}

double images_value(const Field& field, const Op& op, const Vec2& p) {
    const int child = child_of(field, op, 0);
    double value = infinity;
    for (int i = 0; i < op.image_count; ++i) {
        const Vec2 there = image_of(field, op, i).inverse() * p;
        if (may_be_nearer(op_at(field, child), there, value)) value = std::min(value, tree_value(field, child, there));
    }
    return value;
}

/// Is a found outline wrong about the side that p is on? It is where a needle of the solid is thinner than what its boundary strays, and the
/// needle's two sides have changed places: the tree's formula knows. As near as it strays the outline knows better, and on a seam of zeros.
bool is_other_side(const Field& field, const Op& outline, const Vec2& p, double distance) {
    constexpr double hair = 1e-12;
    const double strays = 2 * trace_tolerance * outline.bounds.size().maxCoeff();
    if (std::fabs(distance) <= strays) return false;
    const double formula = tree_value(field, child_of(field, outline, 0), p);
    return std::fabs(formula) > hair && (formula < 0) != (distance < 0);
}

double shape_value(const Field& field, int index, const Vec2& p) {
    const Op& op = op_at(field, index);
    const Vec2 local = op.local_from_field * p;
    const double distance = op.kernels->distance(params_of(field, op), local.x(), local.y()) * op.scale;
    return is_found_outline(op) && is_other_side(field, op, p, distance) ? -distance : distance;
}

/// A value with the leaf that moves it most.
struct LeafSample {
    Sample sample;
    int leaf = 0;
    double share = 1;  ///< how much the value moves with the leaf's own
};

LeafSample sample_op(const Field& field, int index, const Vec2& p);

LeafSample sample_shape(const Field& field, int index, const Vec2& p) {
    const Op& op = op_at(field, index);
    const Vec2 local = op.local_from_field * p;
    const Sample s = op.kernels->sample(params_of(field, op), local.x(), local.y());
    Sample found{s.value * op.scale, direction_before(op.local_from_field, s.gradient)};
    if (!is_found_outline(op)) return {found, index};
    if (is_other_side(field, op, p, found.value)) found = {-found.value, -found.gradient};
    // The surface at the foot is a leaf's of the tree that the boundary stands for.
    LeafSample at_foot = sample_op(field, child_of(field, op, 0), p - found.value * found.gradient);
    at_foot.sample = found;
    return at_foot;
}

/// The leaf of a fold is the one that moves the result most; the first of equals.
LeafSample sample_fold(const Field& field, const Op& op, const Vec2& p) {
    LeafSample out = sample_op(field, child_of(field, op, 0), p);
    for (int i = 1; i < op.child_count; ++i) {
        const LeafSample next = sample_op(field, child_of(field, op, i), p);
        const sdf::Partials f = op.kernels->combine_partials(params_of(field, op), out.sample.value / op.scale,
                                                             next.sample.value / op.scale);
        out.sample = {f.value * op.scale, f.by_a * out.sample.gradient + f.by_b * next.sample.gradient};
        out.share *= std::fabs(f.by_a);
        const double share = next.share * std::fabs(f.by_b);
        if (share > out.share) out.leaf = next.leaf, out.share = share;
    }
    return out;
}

LeafSample sample_modify(const Field& field, const Op& op, const Vec2& p) {
    LeafSample out = sample_op(field, child_of(field, op, 0), p);
    const double* params = params_of(field, op);
    const sdf::Affine affine = op.kernels->affine(params);
    const bool flips = affine.absolute ? out.sample.value < 0 : affine.sign < 0;
    out.sample.value = op.kernels->modify(params, out.sample.value / op.scale) * op.scale;
    if (flips) out.sample.gradient = -out.sample.gradient;
    return out;
}

LeafSample sample_images(const Field& field, const Op& op, const Vec2& p) {
    LeafSample best;
    best.sample.value = infinity;
    for (int i = 0; i < op.image_count; ++i) {
        const Similarity& image = image_of(field, op, i);
        const Vec2 there = image.inverse() * p;
        if (!may_be_nearer(op_at(field, child_of(field, op, 0)), there, best.sample.value)) continue;
        LeafSample seen = sample_op(field, child_of(field, op, 0), there);
        if (!(seen.sample.value < best.sample.value)) continue;
        seen.sample.gradient = image.direction(seen.sample.gradient);
        best = seen;
    }
    return best;
}

double warp_value(const Field& field, const Op& op, const Vec2& p) {
    const double* params = params_of(field, op);
    const Vec2 local = op.local_from_field * p, there = op.local_from_field.inverse() * op.kernels->warp(params, local);
    return op.kernels->factor(params) * tree_value(field, child_of(field, op, 0), there) + op.kernels->lift(params, local) * op.scale;
}

LeafSample sample_warp(const Field& field, const Op& op, const Vec2& p) {
    const double* params = params_of(field, op);
    const double factor = op.kernels->factor(params);
    const Similarity field_from_local = op.local_from_field.inverse();
    const sdf::Warped warped = op.kernels->warped(params, op.local_from_field * p);
    LeafSample out = sample_op(field, child_of(field, op, 0), field_from_local * warped.point);
    out.sample.value = factor * out.sample.value + warped.lift * op.scale;
    out.sample.gradient =
        direction_before(op.local_from_field, warped.gradient(factor, direction_before(field_from_local, out.sample.gradient)));
    return out;
}

LeafSample sample_op(const Field& field, int index, const Vec2& p) {
    const Op& op = op_at(field, index);
    switch (op.kernels->form) {
        case Form::shape: return sample_shape(field, index, p);
        case Form::fold: return sample_fold(field, op, p);
        case Form::modify: return sample_modify(field, op, p);
        case Form::images: return sample_images(field, op, p);
        case Form::warp: return sample_warp(field, op, p);
    }
    assert(false && "an op has one of the five forms");
    return {};
}

}  // namespace

double tree_value(const Field& field, int index, const Vec2& p) {
    const Op& op = op_at(field, index);
    switch (op.kernels->form) {
        case Form::shape: return shape_value(field, index, p);
        case Form::fold: return fold_value(field, op, p);
        case Form::modify:
            return op.kernels->modify(params_of(field, op), tree_value(field, child_of(field, op, 0), p) / op.scale) *
                   op.scale;
        case Form::images: return images_value(field, op, p);
        case Form::warp: return warp_value(field, op, p);
    }
    assert(false && "an op has one of the five forms");
    return infinity;
}

Sample evaluate_tree(const Field& field, int op, const Vec2& p, int* leaf) {
    const LeafSample found = sample_op(field, op, p);
    if (leaf) *leaf = found.leaf;
    return found.sample;
}

}  // namespace pinfield

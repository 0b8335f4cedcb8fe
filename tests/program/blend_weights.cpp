#include "tests/program/blend_weights.h"

#include <cmath>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/program/field.h"
#include "engine/program/tree.h"

namespace pinfield::test {
namespace {

using sdf::Form;
using sdf::Sample;

const double* params_of(const Field& field, const Op& op) { return field.params.data() + op.params; }
int child_of(const Field& field, const Op& op, int i) { return at(field.links, op.first_link + i); }

void add_weights(const Field& field, int index, const Vec2& p, double share, std::vector<BlendWeight>& out);

/// Each further operand takes its part of the share from all before it.
void add_fold_weights(const Field& field, const Op& op, const Vec2& p, double share, std::vector<BlendWeight>& out) {
    std::vector<double> weights{share};
    double value = tree_value(field, child_of(field, op, 0), p);
    for (int i = 1; i < op.child_count; ++i) {
        const double next = tree_value(field, child_of(field, op, i), p);
        const sdf::Partials f = op.kernels->combine_partials(params_of(field, op), value / op.scale, next / op.scale);
        value = f.value * op.scale;
        for (double& weight : weights) weight *= std::fabs(f.by_a);
        weights.push_back(share * std::fabs(f.by_b));
    }
    for (int i = 0; i < op.child_count; ++i)
        if (const double weight = at(weights, i); weight > 0)
            add_weights(field, child_of(field, op, i), p, weight, out);
}

Vec2 seen_in_nearest_image(const Field& field, const Op& op, const Vec2& p) {
    Vec2 nearest = p;
    double least = infinity;
    for (int i = 0; i < op.image_count; ++i) {
        const Vec2 there = at(field.images, op.first_image + i).inverse() * p;
        const double value = tree_value(field, child_of(field, op, 0), there);
        if (value < least) least = value, nearest = there;
    }
    return nearest;
}

void add_weights(const Field& field, int index, const Vec2& p, double share, std::vector<BlendWeight>& out) {
    const Op& op = at(field.ops, index);
    if (op.child_count == 0) return out.push_back({index, share});
    if (op.kernels->form == Form::fold) return add_fold_weights(field, op, p, share, out);
    Vec2 there = p;  // where the only child is asked
    if (is_found_outline(op)) {
        const Sample s = evaluate_tree(field, index, p);
        there = p - s.value * s.gradient;
    } else if (op.kernels->form == Form::images) {
        there = seen_in_nearest_image(field, op, p);
    } else if (op.kernels->form == Form::warp) {
        there = op.local_from_field.inverse() * op.kernels->warp(params_of(field, op), op.local_from_field * p);
    }
    add_weights(field, child_of(field, op, 0), there, share, out);
}

}  // namespace

std::vector<BlendWeight> blend_weights(const Field& field, int op, const Vec2& p) {
    std::vector<BlendWeight> out;
    add_weights(field, op, p, 1, out);
    return out;
}

}  // namespace pinfield::test

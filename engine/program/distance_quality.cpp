#include "engine/program/distance_quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/core/at.h"
#include "engine/core/error_codes.h"
#include "engine/program/compile_item.h"
#include "engine/program/field.h"
#include "engine/program/offset.h"
#include "engine/scene/parts/spawn.h"

namespace pinfield {
namespace {

const Op& op_at(const Field& field, int op) { return at(field.ops, op); }

template <class F>
void for_each_field(const Program& program, F&& tell) {
    tell(program.fixed);
    for (const Mover& mover : program.movers) tell(mover.field);
    for (const Sensor& sensor : program.sensors) tell(sensor.field);
}

/// Calls tell(node, quality) for every op. A node may have several: what it implies (a part's union, a domain's complement) comes after
/// what it was made of, and what is known of its boundary last, so that the last call counts.
template <class F>
void for_each_quality(const Field& field, F&& tell) {
    for (const Op& op : field.ops) {
        if (is_found_outline(op)) tell(op.origin, DistanceQuality{op_at(field, at(field.links, op.first_link)).exactness, true});
        else tell(op.origin, DistanceQuality{op.exactness, false});
    }
    for (const Solid& solid : field.solids) {
        const Op& root = op_at(field, solid.root);
        // Up to its horizon only is no promise: eval certifies an endless solid point by point.
        if (solid.lowered && solid.horizon == infinity) tell(root.origin, DistanceQuality{root.exactness, true, solid.fit_error});
    }
}

/// The sides of its child that an offset looks at and finds to be bounds; empty where it finds none.
std::string_view doubtful_sides(const Exactness& child, const sdf::Affine& affine) {
    if (offset_is_exact(child, affine)) return {};
    if (!affine.absolute) return affine.sign * affine.offset < 0 ? "outside" : "inside";
    if (child.outside == child.inside) return "on both sides";
    return child.outside == Side::bound ? "outside" : "inside";
}

void add_warnings(const Field& field, const Scene& scene, Diagnostics& out) {
    for (const Op& op : field.ops) {
        if (op.kernels->form != sdf::Form::modify) continue;
        const Op& child = op_at(field, at(field.links, op.first_link));
        const std::string_view sides = doubtful_sides(child.exactness, op.kernels->affine(field.params.data() + op.params));
        const Node* node = scene.find(op.origin);
        const Node* below = scene.find(child.origin);
        if (sides.empty() || !node || !below) continue;
        out.push_back(diagnose(Code::offset_of_bound, node->key,
                               fmt::format("{} moves an isoline of a bound: {}, the distance to {} is not the true one, and its boundary "
                                           "could not be found",
                                           node->type->key(), sides, scene.path(below->id)),
                               fmt::format("offset what {} is made of instead, or cut it to a finite size", below->type->key())));
    }
}

/// Balls are where they start, on the ground or on a spawn's layers, and nothing takes them elsewhere: each other layer is reported once,
/// with the first solid on it. A domain bounds its layer and is no obstacle.
void add_untouched_layers(const Program& program, const Scene& scene, Diagnostics& out) {
    LayerMask reported = ground_layer;
    for (const Part& part : program.parts)
        if (part.is<parts::Spawn>()) reported |= part.layers;
    for_each_field(program, [&](const Field& field) {
        for (const Solid& solid : field.solids) {
            const Node* node = scene.find(solid.origin);
            if (!node || solid.is_domain || (solid.layers & reported)) continue;
            reported |= solid.layers;
            std::vector<std::string> names;
            for (std::size_t i = 0; i < program.layers.size(); ++i)
                if (solid.layers & (LayerMask{1} << i)) names.push_back(program.layers[i]);
            out.push_back(
                diagnose(Code::untouched_layer, node->key,
                         fmt::format("no ball is ever on layer {}: nothing touches this {}", fmt::join(names, ", "), node->type->key()),
                         fmt::format("balls are where spawns are, and on layer {}, where nodes are that name none", program.layers[0])));
        }
    });
}

/// Has it a shape to be made of: its own, its children's, or the customary one of its part?
bool has_shape(const Node& node, const Item& item) {
    return !item.is_part || !node.children.empty() || node.type->part->customary_shape;
}

void add_empty_solids(const Program& program, const Scene& scene, Diagnostics& out) {
    std::set<NodeId> solid;
    for_each_field(program, [&](const Field& field) {
        for (const Solid& one : field.solids) solid.insert(one.origin);
    });
    std::vector<Item> items;
    for (const NodeId root : scene.roots()) collect_items(scene, root, items);
    for (const Item& item : items) {
        const Node& node = *scene.find(item.node);
        if (solid.contains(item.node) || !has_shape(node, item)) continue;
        out.push_back(diagnose(Code::empty_solid, node.key, fmt::format("nothing is left of this {}: no ball ever meets it", node.type->key()),
                               "its children cut each other away, or lie apart"));
    }
}

void add_missing_boundaries(const Field& field, const Scene& scene, Diagnostics& out) {
    for (const Solid& solid : field.solids) {
        const Exactness& formula = op_at(field, solid.root).exactness;
        const Node* node = scene.find(solid.origin);
        const bool is_exact = formula.outside == Side::exact && formula.inside == Side::exact;
        if (solid.lowered || is_exact || !solid.bounds.is_finite() || !node) continue;
        out.push_back(diagnose(Code::no_boundary, node->key,
                               fmt::format("the boundary of this {} could not be found: balls meet it by its formula, which takes longer, and "
                                           "its distances are bounds",
                                           node->type->key()),
                               "larger waves, fewer parts and parts that overlap instead of touching help; what is larger than 4 m is never fitted"));
    }
}

}  // namespace

std::map<NodeId, DistanceQuality> distance_qualities_of(const Program& program) {
    std::map<NodeId, DistanceQuality> out;
    for_each_field(program, [&](const Field& field) {
        for_each_quality(field, [&](NodeId node, const DistanceQuality& quality) { out[node] = quality; });
    });
    return out;
}

std::optional<DistanceQuality> distance_quality_of(const Program& program, NodeId wanted) {
    std::optional<DistanceQuality> out;
    for_each_field(program, [&](const Field& field) {
        for_each_quality(field, [&](NodeId node, const DistanceQuality& quality) {
            if (node == wanted) out = quality;
        });
    });
    return out;
}

Diagnostics warnings_of(const Program& program, const Scene& scene) {
    Diagnostics out;
    for_each_field(program, [&](const Field& field) { add_warnings(field, scene, out); });
    for_each_field(program, [&](const Field& field) { add_missing_boundaries(field, scene, out); });
    add_empty_solids(program, scene, out);
    add_untouched_layers(program, scene, out);
    // As one reads: by their place.
    std::stable_sort(out.begin(), out.end(), [](const Diagnostic& a, const Diagnostic& b) { return a.where.span.begin < b.where.span.begin; });
    return out;
}

}  // namespace pinfield

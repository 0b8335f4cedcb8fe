#include "editor/lone_node.h"

#include <algorithm>

#include "engine/core/at.h"
#include "engine/physics/mechanisms/mechanism.h"
#include "engine/program/compile.h"
#include "engine/program/pose.h"
#include "engine/program/tree.h"
#include "engine/scene/edit.h"
#include "engine/scene/expanded.h"

namespace pinfield::editor {
namespace {

constexpr double fine = 1e-7;  ///< metres: a difference for slopes

/// Puts a field that every node has back to what it is where nobody says it.
void reset(Node& node, std::string_view key) {
    if (const std::optional<int> field = node.type->find_field(key)) at(node.fields, *field).value = at(node.type->fields, *field).initial;
}

Scene table_for_one(const Scene& scene, NodeId node) {
    Scene alone(scene.shared_catalog());
    alone.table().fields = scene.table().fields;
    alone.inputs = scene.inputs;
    for (const NodeId material : scene.materials())
        alone.put(alone.with_new_ids(scene.copy(material)), {}, static_cast<int>(alone.materials().size()));
    alone.put(alone.with_new_ids(scene.copy(node)), {}, 0);
    alone = expanded(std::move(alone));  // its numbers are tried, wherever they are written
    Node& root = *alone.find(alone.roots().front());
    for (const std::string_view key : {"at", "turn", "scale", "flip"}) reset(root, key);
    return alone;
}

}  // namespace

LoneNode::LoneNode(const Scene& scene, NodeId node) : scene_(table_for_one(scene, node)), root_(scene_.roots().front()) {}

std::optional<std::string> LoneNode::why_not(int field, const Value& value) const {
    return why_invalid(scene_, SetField{root_, field, value, true});
}

std::optional<LoneShape> LoneNode::shape_with(int field, const Value& value) const {
    if (why_not(field, value)) return {};
    Scene changed = scene_;
    at(changed.find(root_)->fields, field).value = value;
    return compiled(changed);
}

std::optional<LoneShape> LoneNode::compiled(const Scene& scene) const {
    const auto program = compile(scene);
    if (!program) return {};
    LoneShape shape;
    shape.program_ = *program;
    const auto stand = [&](const Field& field, const Similarity& field_from_node) {
        for (std::size_t i = 0; i < field.solids.size(); ++i)
            if (field.solids[i].origin == root_) shape.stands_.push_back({&field, static_cast<int>(i), field_from_node});
    };
    stand(shape.program_->fixed, {});
    for (const Sensor& sensor : shape.program_->sensors) stand(sensor.field, {});
    for (std::size_t i = 0; i < shape.program_->movers.size(); ++i) {
        const Mover& mover = shape.program_->movers[i];
        const MoverState rest = mover_at_rest(*shape.program_, static_cast<int>(i));
        for (const double q : {rest.q_min, rest.q_max}) stand(mover.field, world_from_mover(mover, q).inverse());
    }
    if (shape.stands_.empty()) return {};
    return shape;
}

double LoneShape::distance(const Vec2& p) const {
    double least = infinity;
    for (const Stand& stand : stands_)
        least = std::min(least, tree_value(*stand.field, at(stand.field->solids, stand.solid).root, stand.field_from_node * p));
    return least;
}

Vec2 LoneShape::normal(const Vec2& p) const {
    const Vec2 x(fine, 0), y(0, fine);
    const Vec2 slope(distance(p + x) - distance(p - x), distance(p + y) - distance(p - y));
    const double steepness = length(slope);
    return steepness > 0 ? Vec2(slope / steepness) : Vec2(0, 0);
}

std::vector<Vec2> LoneShape::joints() const {
    std::vector<Vec2> out;
    for (const Stand& stand : stands_) {
        const Solid& solid = at(stand.field->solids, stand.solid);
        const Similarity node_from_field = stand.field_from_node.inverse();
        for (int i = 0; i < solid.piece_count; ++i) out.push_back(node_from_field * at(stand.field->pieces, solid.first_piece + i).piece.a);
    }
    return out;
}

Box2 LoneShape::bounds() const {
    Box2 all;
    for (const Stand& stand : stands_) {
        const Box2& box = at(stand.field->solids, stand.solid).bounds;
        if (!box.is_empty()) all = all.merged(stand.field_from_node.inverse() * box);
    }
    return all;
}

}  // namespace pinfield::editor

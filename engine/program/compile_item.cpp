#include "engine/program/compile_item.h"

#include <algorithm>
#include <cassert>

#include "engine/core/at.h"
#include "engine/core/trig.h"
#include "engine/program/field.h"
#include "engine/sdf/piece.h"

namespace pinfield {
namespace {

constexpr double earth_gravity = 9.81;  // m/s^2, as TableInfo::slope documents

/// The struct behind a record node, by the same packing that formulas use.
template <class T>
T record_of(const Node& node) {
    std::vector<Value> values;
    for (const FieldSlot& slot : node.fields) values.push_back(slot.value);
    return load<T>(pack(*node.type, values).data());
}

MaterialRecord material_record(const std::string& name, const Material& m, const std::string& color) {
    return {name, m.restitution, m.falloff, m.tangential, m.friction, m.scatter, color};
}

MaterialRecord compile_material(const Node& node) {
    std::string color;
    for (std::size_t i = 0; i < node.fields.size(); ++i)
        if (node.type->fields[i].meta.meaning == Meaning::color) color = std::get<std::string>(node.fields[i].value);
    return material_record(node.name, record_of<Material>(node), color);
}

double farthest_from_origin(const Field& field) {
    double farthest = 0;
    for (const BoundaryPiece& boundary : field.pieces) farthest = std::max(farthest, sdf::farthest_from_origin(boundary.piece));
    for (const int solid : field.tree_solids) {
        const Box2& box = at(field.solids, solid).bounds;
        if (box.is_empty()) continue;
        for (const Vec2& corner : {box.lo, box.hi, Vec2(box.lo.x(), box.hi.y()), Vec2(box.hi.x(), box.lo.y())})
            farthest = std::max(farthest, length(corner));
    }
    return farthest;
}

int input_index(const Scene& scene, const std::string& name) {
    const auto& inputs = scene.inputs;
    const auto at = std::find_if(inputs.begin(), inputs.end(), [&](const InputBinding& i) { return i.name == name; });
    assert(at != inputs.end() && "validate() lets no unknown input pass");
    return static_cast<int>(at - inputs.begin());
}

}  // namespace

CompileContext::CompileContext(const Scene& of, std::vector<std::string> named_layers) : scene(of), layers(std::move(named_layers)) {
    materials["default"] = 0;
    int position = 0;  // as compile_materials() orders them
    for (const NodeId id : scene.materials())
        if (const std::string& name = scene.find(id)->name; name != "default") materials.emplace(name, ++position);
}

void collect_items(const Scene& scene, NodeId id, std::vector<Item>& out) {
    const Node& node = *scene.find(id);
    if (!node.type->part) {
        out.push_back({id, Role::solid, false});
    } else if (node.type->part->role != Role::group) {
        out.push_back({id, node.type->part->role, true});
    } else {
        for (const NodeId child : node.children) collect_items(scene, child, out);
    }
}

NodeId scene_node_of(const Scene& scene, NodeId id) {
    const auto is_group = [&](NodeId n) {
        return scene.find(n)->type->part && scene.find(n)->type->part->role == Role::group;
    };
    while (scene.find(id)->parent && !is_group(scene.find(id)->parent)) id = scene.find(id)->parent;
    return id;
}

std::vector<std::string> layer_names(const Scene& scene, const std::vector<Item>& items, std::size_t most) {
    std::vector<std::string> names{std::string(ground_layer_name)};
    for (const Item& item : items)
        for (const Node* node = scene.find(item.node); node; node = node->parent ? scene.find(node->parent) : nullptr)
            for (const std::string& layer : node->get<std::vector<std::string>>("layer"))
                if (std::find(names.begin(), names.end(), layer) == names.end() && names.size() < most) names.push_back(layer);
    return names;
}

LayerMask layers_of(const CompileContext& context, NodeId id) {
    LayerMask mask = 0;
    for (const std::string& layer : context.scene.layers(id))
        mask |= LayerMask{1} << (std::find(context.layers.begin(), context.layers.end(), layer) - context.layers.begin());
    return mask;
}

Part compile_part(CompileContext& context, const Item& item) {
    const Node& node = *context.scene.find(item.node);
    Part part;
    part.type = node.type;
    part.origin = item.node;
    const auto known = context.paths.find(item.node);
    part.name = known != context.paths.end() ? known->second : context.scene.path(item.node);
    part.world_from_part = world_from_local(context.scene, item.node);
    part.layers = layers_of(context, item.node);
    std::vector<Value> values;
    for (int i = 0; i < node.type->own_fields; ++i) {
        const FieldSlot& slot = at(node.fields, i);
        values.push_back(slot.value);
        if (at(node.type->fields, i).meta.meaning != Meaning::input) continue;
        for (const std::string& name : std::get<std::vector<std::string>>(slot.value))
            part.inputs.push_back(input_index(context.scene, name));
    }
    part.params = pack(*node.type, values);
    return part;
}

Mover compile_mover(CompileContext& context, const Item& item, int part) {
    const Similarity world_from_part = world_from_local(context.scene, item.node);
    Mover mover;
    mover.part = part;
    mover.pivot = world_from_part.offset;
    mover.cosine = world_from_part.cosine;
    mover.sine = world_from_part.sine;
    mover.handedness = world_from_part.mirrored ? -1 : 1;
    mover.slides = context.scene.find(item.node)->type->part->slides;
    mover.axis = world_from_part.direction({0, 1});
    const Similarity mover_from_part{.scale = world_from_part.scale, .mirrored = world_from_part.mirrored};
    mover.field = compile_solid(context, item, mover_from_part);
    for (Solid& solid : mover.field.solids) solid.part = part;
    index(mover.field);
    mover.bounding_radius = farthest_from_origin(mover.field);
    return mover;
}

std::vector<MaterialRecord> compile_materials(const Scene& scene) {
    std::vector<MaterialRecord> out{material_record("default", Material{}, {})};
    for (const NodeId id : scene.materials()) {
        const MaterialRecord record = compile_material(*scene.find(id));
        if (record.name == out[0].name)
            out[0] = record;
        else
            out.push_back(record);
    }
    return out;
}

PhysicsRecord compile_physics(const Scene& scene) {
    const auto settings = record_of<PhysicsSettings>(scene.physics());
    const auto table = record_of<TableInfo>(scene.table());
    PhysicsRecord out;
    out.step = settings.step;
    out.integrator = settings.integrator;
    // Rolling without slip, a force on the centre has the ball's mass and its inertia to move: (1 + k) m.
    out.ball_inertia = settings.ball_inertia == BallShape::sphere ? 0.4 : 0.5;
    const double moved = settings.ball_rolls ? 1 + out.ball_inertia : 1.0;
    out.gravity = {0, -earth_gravity * sine_degrees(table.slope) / moved};
    out.rolling_resistance = settings.rolling_resistance * earth_gravity * cosine_degrees(table.slope) / moved;
    out.ball_radius = settings.ball_radius;
    out.ball_mass = settings.ball_mass;
    out.ball_restitution = settings.ball_restitution;
    out.tolerance = settings.tolerance;
    out.rest_speed = settings.rest_speed;
    return out;
}

}  // namespace pinfield
